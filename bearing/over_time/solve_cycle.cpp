#include <algorithm>
#include <cmath>

#include "bearing/bearing.hpp"
#include "bearing/film/follow.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_lumped.hpp"
#include "bearing/over_time/cycle_search.hpp"
#include "bearing/over_time/kept_run.hpp"
#include "bearing/steady/nested.hpp"
#include "bearing/steady/solve.hpp"
#include "core/contract.hpp"
#include "core/stopwatch.hpp"

namespace shellback::bearing {
namespace {

/// From what is kept of it, or by `begin`.
template <class Begin>
void begin_or_take_up(CycleSearch& search, const SolveControl& control, const Begin& begin) {
  Tape* tape = control.kept != nullptr ? control.kept->under_way() : nullptr;
  if (tape == nullptr) return begin();
  search.begin(*tape);
  control.kept->taken_up();
}

/// On the case's own grid, from rest.
std::unique_ptr<CycleSearch> on_one_grid(const Case& c, Tier tier, const SolveControl& control,
                                         Cost& cost) {
  auto search = std::make_unique<CycleSearch>(c, tier, control);
  begin_or_take_up(*search, control, [&] { search->begin(equivalent_temperature(c)); });
  if (search->search(false).good()) search->judge_orbit();
  cost.factorizations = search->cost().factorizations;
  cost.newton_iterations = search->cost().newton_iterations;
  return search;
}

/// The lumped tier, on the case's own grid.
CycleResult at_one_temperature(const Case& c, const SolveControl& control) {
  CycleSearch search(c, Tier::lumped, control);
  begin_or_take_up(search, control, [&] { search.begin(mean_supply_temperature(c)); });
  Verdict v = settle_lumped_cycle(search, c);
  if (v.good()) v = search.judge_orbit();
  CycleResult r = search.result();
  r.verdict = v;
  return r;
}

/// The walls of a resolved tier settle on coarse grids first: what they need is many cycles, not
/// many cells. A coarse grid that fails is left out.
std::unique_ptr<CycleSearch> on_grids(const Case& c, Tier tier, const SolveControl& control,
                                      Cost& cost) {
  const auto grids = grid_ladder(c);
  const auto search_on = [&](int k) {
    Case on = c;
    on.model.grid = grids[k];
    return std::make_unique<CycleSearch>(on, tier, control);
  };
  if (control.kept != nullptr) cost = control.kept->cost();
  std::unique_ptr<CycleSearch> coarse;
  if (control.kept != nullptr && control.kept->coarser_grid() >= 0) {
    coarse = search_on(control.kept->coarser_grid());
    Tape tape = control.kept->coarser();
    coarse->found(tape);
  }
  for (int k = control.kept != nullptr ? control.kept->grid() : 0;; ++k) {
    const bool last = grids[k] == c.model.grid;
    if (control.kept != nullptr) control.kept->on_grid(k, cost);
    auto search = search_on(k);
    begin_or_take_up(*search, control, [&] {
      if (coarse) {
        search->begin(*coarse);
      } else {
        search->begin(equivalent_temperature(c));
      }
    });
    const Verdict& v = search->search(!last);
    if (last && v.good()) search->judge_orbit();
    cost.factorizations += search->cost().factorizations;
    cost.newton_iterations += search->cost().newton_iterations;
    if (last || v.status == Status::interrupted) return search;
    if (!v.good()) continue;
    coarse = std::move(search);
    if (control.kept == nullptr) continue;
    Tape tape;
    coarse->found(tape);
    control.kept->coarser(k, tape);
  }
}

}  // namespace

std::unique_ptr<CycleSearch> search_cycle(const Case& c, Tier tier, const SolveControl& control,
                                          Cost& cost) {
  EXPECTS(c.cycle.has_value() && tier != Tier::lumped);
  const bool resolved = physics_of(c, tier).film_energy && c.cycle->repeats();
  return resolved ? on_grids(c, tier, control, cost) : on_one_grid(c, tier, control, cost);
}

namespace {

CycleResult search_on_grid(const Case& c, Tier tier, const SolveControl& control) {
  if (tier == Tier::lumped) return at_one_temperature(c, control);
  Cost cost;
  CycleResult r = search_cycle(c, tier, control, cost)->result();
  r.cost = cost;
  return r;
}

/// A coarser grid, or one finer than the coarsest.
std::array<int, 2> another_grid(const Case& c, std::array<int, 2> grid) {
  const auto coarser = halved(grid);
  if (coarser && holds_supplies(c, *coarser)) return *coarser;
  return {2 * grid[0], std::min(2 * grid[1] - 1, most_axial_cells(c))};
}

/// Whether a journal heavier by the tenth within which two grids are to agree departs from its
/// orbit on another grid. `interrupted`: its verdict, if it was.
ending::UnstableOrbit::Elsewhere on_other_grid(Case c, Tier tier, const SolveControl& control,
                                               std::array<int, 2> grid, Cost& cost,
                                               Verdict& interrupted) {
  using Elsewhere = ending::UnstableOrbit::Elsewhere;
  c.model.grid = grid;
  c.cycle->journal_mass *= 1.0 + kAgree;
  CycleResult r;
  try {
    r = search_on_grid(c, tier, control);
  } catch (const InputError&) {  // of the grid, which nobody gave: it does not hold the supplies
    return Elsewhere::no_orbit;
  }
  cost.factorizations += r.cost.factorizations;
  cost.newton_iterations += r.cost.newton_iterations;
  if (r.verdict.status == Status::interrupted) interrupted = r.verdict;
  if (r.verdict.as<ending::UnstableOrbit>() != nullptr) return Elsewhere::departs;
  if (!r.verdict.good()) return Elsewhere::no_orbit;
  const bool judged = std::none_of(r.warnings.begin(), r.warnings.end(), [](const Note& n) {
    const auto* plain = std::get_if<note::Plain>(&n);
    return plain != nullptr && *plain == note::Plain::orbit_not_judged;
  });
  return judged ? Elsewhere::keeps_to_it : Elsewhere::not_judged;
}

/// That no journal keeps to its orbit, where two grids agree on it; else not resolved. What may
/// cost so much and no more is not searched twice.
Verdict on_two_grids(ending::UnstableOrbit orbit, const Case& c, Tier tier, SolveControl control,
                     Cost& cost) {
  if (std::isfinite(control.most_work)) return {Status::iteration_limit, orbit};
  control.kept = nullptr;
  orbit.other = another_grid(c, orbit.grid);
  Verdict interrupted;
  orbit.elsewhere = on_other_grid(c, tier, control, orbit.other, cost, interrupted);
  if (!interrupted.good()) return interrupted;
  const bool departs = orbit.elsewhere == ending::UnstableOrbit::Elsewhere::departs;
  return {departs ? Status::no_steady_state : Status::iteration_limit, orbit};
}

}  // namespace

CycleResult solve_cycle(const Case& c, Tier tier, const SolveControl& control) {
  if (!c.cycle) {
    throw InputError("load_cycle", "the case has none; take bearing::solve for a standing load");
  }
  if (tier == Tier::estimate || tier == Tier::automatic) {
    throw InputError("model.tier", std::string("the tier ") + to_string(tier) +
                                       " solves no film over a cycle by itself; take isothermal, "
                                       "lumped, thd or tehd, or fidelity::solve_cycle_case");
  }
  if (control.kept != nullptr) {
    if (auto ended = control.kept->next_ended()) return *std::move(ended);
  }
  const Stopwatch watch;
  CycleResult r = search_on_grid(c, tier, control);
  if (const auto* orbit = r.verdict.as<ending::UnstableOrbit>()) {
    r.verdict = on_two_grids(*orbit, c, tier, control, r.cost);
  }
  r.cost.wall_s = watch.seconds();
  if (control.kept == nullptr) return r;
  r.cost.wall_s += control.kept->spent_before();
  if (r.verdict.status != Status::interrupted) control.kept->end(r);
  return r;
}

}  // namespace shellback::bearing
