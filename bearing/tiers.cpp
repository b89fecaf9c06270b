#include "bearing/tiers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/branch_endings.hpp"
#include "bearing/first_film.hpp"
#include "bearing/follow.hpp"
#include "bearing/heat_march.hpp"
#include "bearing/lumped.hpp"
#include "bearing/possible_methods.hpp"
#include "bearing/solve_equilibrium.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

constexpr double kLooseHeat = 3e-3;  ///< change per iteration on the way and on coarser grids [-]
constexpr double kTransientError = 2.0;  ///< per step of that transient [K]
/// Its shortest step [s]: a film that explodes heats within microseconds, and a step shorter than
/// that is always found; with 1e-6 and 1e-8 the trajectories of the tests leave the same bound.
constexpr double kTransientShortest = 1e-6;

bool stopped(const Verdict& v) { return v.status == Status::interrupted; }

double supply_temperature(const Solution& s) { return s.model.input.supplies.front().temperature; }

ThermalOptions options_of(Accuracy accuracy, bool coarse) {
  ThermalOptions o;
  if (coarse) o.tolerance = kLooseHeat;
  o.close = !coarse;
  if (accuracy == Accuracy::result) return o;
  o.tolerance = kLooseHeat;
  o.max_iterations = kMostOfWayPoint;
  o.film.max_iterations = kMostOfWayPoint;
  return o;
}

Verdict solve_isothermal(Solution& s, bool warm, const SolveControl& control) {
  std::fill(s.film.columns.T.begin(), s.film.columns.T.end(), s.T_film);
  if (!warm) return first_film(s, s.T_film, control);
  return solve_equilibrium_near(s.model, s.target, {}, {}, s.film, s.cost, control.stop);
}

/// Walls and film from the supply's temperature through time to rest, and the steady state there.
Verdict warm_up(Solution& s, const ThermalOptions& options, const SolveControl& control) {
  MarchOptions march;
  march.heat = options_of(Accuracy::way_point, true);
  MarchStand stand{s.model.solids->uniform_state(supply_temperature(s))};
  const MarchEnd end = march_heat(s, stand, march, control);
  if (!end.verdict.good()) return end.verdict;
  return solve_heat(s, options, control);
}

/// From the last state of a branch under more load than two ends that agree may differ by: a
/// trajectory that leaves every bound shows that the branch ends; one that comes to rest is a state
/// of more load.
MarchEnd transient_beyond(Solution& s, const Branch& branch, const SolveControl& control) {
  Part of(s, branch.raised);
  of.take(std::min(1.0, (1.0 + kAgree) * branch.carried));
  MarchOptions march;
  march.error = kTransientError;
  march.shortest = kTransientShortest;
  march.heat = options_of(Accuracy::way_point, true);
  MarchStand stand{s.model.solids->state(s.heat.solids)};
  const MarchEnd end = march_heat(s, stand, march, control);
  of.take(1.0);
  return end;
}

Verdict follow_heat(Solution& s, bool coarse, const SolveControl& control) {
  const auto start = [&] {
    s.heat = cold_heat(s.model, supply_temperature(s));
    s.film = cold_start(s.model, supply_temperature(s));
    const Verdict v = solve_equilibrium(s.model, s.target, {}, {}, s.film, s.cost, control.stop);
    return v.good() ? solve_heat(s, options_of(Accuracy::way_point, true), control) : v;
  };
  const Corrector correct = [&](Solution& at, Accuracy accuracy) {
    return solve_heat(at, options_of(accuracy, coarse || accuracy == Accuracy::way_point), control);
  };
  std::optional<Branch> branch;
  if (s.target.unknowns > 0) branch = follow_from(s, Raised::load, kLight, start, correct, control);
  if (!branch) branch = follow_from(s, Raised::speed, kLight, start, correct, control);
  if (!branch) return {Status::iteration_limit, ending::Plain::no_light_state};
  if (branch->end == BranchEnd::reached) return {};
  if (branch->end == BranchEnd::interrupted) return branch->last;
  if (branch->end != BranchEnd::lost) {
    note_limit(s, *branch, true);
    return branch_ended(s, *branch);
  }
  if (s.cost.spent()) return {Status::iteration_limit, ending::Plain::given_up};
  const Solution last = s;
  const MarchEnd beyond = transient_beyond(s, *branch, control);
  const bool ran_away = beyond.left_bounds && !s.cost.spent();
  s.film = last.film;
  s.heat = last.heat;
  note_limit(s, *branch, ran_away);
  if (stopped(beyond.verdict)) return beyond.verdict;
  return ran_away ? ran_away_from(s, *branch, beyond) : branch_ended(s, *branch);
}

Verdict solve_resolved(Solution& s, Level level, const SolveControl& control) {
  const ThermalOptions options = options_of(Accuracy::result, level.coarse);
  if (level.warm) return solve_heat(s, options, control);
  const double T = supply_temperature(s);
  s.heat = cold_heat(s.model, T);
  const Verdict film = first_film(s, T, control);
  if (stopped(film) || s.cost.spent()) return film;
  if (!film.good() && !usual_methods(s.model.input)) return film;
  if (!film.good()) {  // heated oil may carry where that of the supply does not
    const Verdict v = follow_heat(s, level.coarse, control);
    return v.good() || stopped(v) ? v : film;
  }
  const FilmEquilibrium first = s.film;
  const Verdict direct = solve_heat(s, options, control);
  if (direct.good() || stopped(direct) || s.cost.spent()) return direct;
  const bool followed = usual_methods(s.model.input);
  const Verdict along = followed ? follow_heat(s, level.coarse, control) : direct;
  if (along.good() || stopped(along) || s.cost.spent() || level.coarse) return along;
  const FilmEquilibrium end = std::exchange(s.film, first);
  const HeatState heat_at_end = std::exchange(s.heat, cold_heat(s.model, T));
  const Verdict in_time = warm_up(s, options, control);
  // Where no branch begins, what the warming bearing comes to in time stands for itself.
  const bool begun = followed && !s.limits.empty();
  const bool stands = !followed || (!begun && in_time.status == Status::no_steady_state);
  if (in_time.good() || stopped(in_time) || stands) return in_time;
  s.film = end;
  s.heat = heat_at_end;
  return along;
}

}  // namespace

void solve_on_grid(Solution& s, Tier tier, Level level, const SolveControl& control) {
  if (!level.warm) {
    s.film = cold_start(s.model, s.T_film);
    s.heat = {};
    s.heat_roots.clear();
  }
  switch (tier) {
    case Tier::isothermal:
      s.verdict = solve_isothermal(s, level.warm, control);
      break;
    case Tier::lumped:
      s.verdict = solve_lumped(s, level.warm, control);
      break;
    case Tier::thd:
    case Tier::tehd:
      s.verdict = solve_resolved(s, level, control);
      break;
    case Tier::estimate:
    case Tier::automatic:
      EXPECTS(false);  // fidelity/ has turned these into one of the others
  }
}

}  // namespace shellback::bearing
