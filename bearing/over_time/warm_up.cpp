#include "bearing/over_time/warm_up.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/over_time/kept_run.hpp"
#include "bearing/over_time/solution_members.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {

double imbalance_over(const std::vector<Instant>& instants, std::size_t first, std::size_t end) {
  double made = 0.0, missing = 0.0;
  for (std::size_t k = first; k < end; ++k) {
    const Instant& a = instants[k > first ? k - 1 : k];
    const Instant& b = instants[k];
    made += 0.5 * b.dt * (a.heat_in + b.heat_in);
    const double gained = mean_that_dies_away(a.heat_in - a.heat_out, b.heat_in - b.heat_out);
    missing += b.dt * (gained - b.stored);
  }
  return made != 0.0 ? std::abs(missing / made) : 0.0;
}

double imbalance_of(const Instant& i) {
  const double heat = std::max(std::abs(i.heat_in), std::abs(i.heat_out));
  const double missing = std::abs(i.heat_in - i.heat_out - i.stored);
  return missing == 0.0 ? 0.0 : missing / heat;
}

double WarmUp::imbalance() const {
  if (solution.model.input.cycle) return imbalance_over(instants, 0, instants.size());
  double most = 0.0;
  for (const Instant& i : instants) most = larger(most, imbalance_of(i));
  return most;
}

WarmUp warm_up(const Case& c, Tier tier, const WarmUpOptions& o, const SolveControl& control) {
  if (tier != Tier::thd && tier != Tier::tehd) {
    throw InputError("model.tier",
                     "a transient follows the walls' temperatures, which only the tiers thd and "
                     "tehd have");
  }
  if (c.cycle && !c.cycle->repeats()) {
    throw InputError("load_cycle.period",
                     "a warm-up passes many cycles, and the case has a single event; give its "
                     "period");
  }
  WarmUp out;
  const auto told = [&](Tape& tape) { tape(out.instants); };
  begin_take_up(control.kept, told);
  CarriedOver none;
  out.end = pass_stretch(c, tier, o, StretchEnd::at_rest, control, none, out.solution,
                         [&](const Instant& i, const std::function<void(Tape&)>& stand) {
                           out.instants.push_back(i);
                           keep_between(control.kept, told, stand);
                         });
  keep_stopped(control.kept, out.end.verdict);
  out.solution.verdict = out.end.verdict;
  return out;
}

std::vector<Note> warm_up_warnings(const rheology::Oil& oil, const WarmUp& run,
                                   const Result& steady) {
  std::vector<Note> notes = march_warnings(oil, run.instants);
  if (!run.end.at_rest || run.instants.empty() || !steady.verdict.good()) return notes;
  const Instant& end = run.instants.back();
  const auto beyond = [&](const char* name, double value) {
    const Quantity* q = quantity_in(steady.quantities, name);
    return q != nullptr && std::abs(value - q->value) > q->error();
  };
  if (beyond("friction_torque", end.torque) && beyond("T_film_max", end.T_film_max)) {
    notes.push_back(note::OtherSteadyState{
        end.torque, end.T_film_max, steady.value("friction_torque"), steady.value("T_film_max")});
  }
  return notes;
}

}  // namespace shellback::bearing
