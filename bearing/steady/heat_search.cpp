#include "bearing/steady/heat_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/film/friction.hpp"
#include "bearing/film/solve_equilibrium.hpp"
#include "bearing/heat/heat_endings.hpp"
#include "bearing/heat/heat_march.hpp"
#include "bearing/possible_methods.hpp"
#include "bearing/steady/branch_endings.hpp"
#include "bearing/steady/first_film.hpp"

namespace shellback::bearing {
namespace {

constexpr double kLooseHeat = 3e-3;  ///< change per iteration on the way and on coarser grids [-]
constexpr double kTransientError = 2.0;  ///< per step of that transient [K]
/// Its shortest step [s]: a film that explodes heats within microseconds, and a step shorter than
/// that is always found; with 1e-6 and 1e-8 the trajectories of the tests leave the same bound.
constexpr double kTransientShortest = 1e-6;

bool stopped(const Verdict& v) { return v.status == Status::interrupted; }

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

/// Part of load or speed under which a bearing is looked at beyond the end of a branch: more than
/// two ends that agree may differ by.
double beyond(const Branch& branch) { return std::min(1.0, (1.0 + kAgree) * branch.carried); }

bool is_fed_under_pressure(const OperatingPoint& point) {
  const auto& patches = point.scene.supply.patches;
  return std::any_of(patches.begin(), patches.end(),
                     [](const fluid::SupplyPatch& patch) { return patch.pressure > 0.0; });
}

/// Short of the whole, and by no bound of the equations.
bool ends_early(const Branch& branch) {
  const bool open = branch.end == BranchEnd::turned || branch.end == BranchEnd::lost;
  return open && branch.carried < 1.0;
}

/// From the last state of a branch under more than it carries: a trajectory that leaves every bound
/// shows that the branch ends; one that comes to rest is a state of more, of another branch.
MarchEnd transient_beyond(Solution& s, const Branch& branch, const SolveControl& control) {
  Part of(s, branch.raised);
  of.take(beyond(branch));
  MarchOptions march;
  march.error = kTransientError;
  march.shortest = kTransientShortest;
  march.heat = options_of(Accuracy::way_point, true);
  MarchStand stand{s.model.solids->state(s.heat.solids)};
  const MarchEnd end = march_heat(s, stand, march, control);
  of.take(1.0);
  return end;
}

/// Everything as warm as its surroundings, and so much deformed.
HeatState heat_at_rest(const BearingModel& m) {
  const double T = m.solids->surroundings();
  HeatState h = cold_heat(m, T);
  if (m.physics.thermal_deformation)
    h.thermal_deformation = m.solids->at(m.solids->uniform_state(T)).thermal_deformation;
  return h;
}

}  // namespace

double HeatSearch::supply_temperature() const { return mean_supply_temperature(s_.model.input); }

bool HeatSearch::over(const Verdict& v) const { return v.good() || stopped(v) || s_.cost.spent(); }

bool HeatSearch::may_follow() const { return usual_methods(s_.model.input); }

void HeatSearch::back_to(Reached at) {
  s_.film = std::move(at.film);
  s_.heat = std::move(at.heat);
}

Verdict HeatSearch::cold_film() {
  s_.heat = cold_heat(s_.model, supply_temperature());
  const Verdict v = first_film(s_, supply_temperature(), control_);
  cold_film_ = s_.film;
  return v;
}

Verdict HeatSearch::iterate() {
  ThermalOptions o = options_of(Accuracy::result, level_.coarse);
  o.tolerance = std::min(o.tolerance, control_.heat_within);
  o.film = film_options(level_);
  return solve_heat(s_, o, control_);
}

std::optional<Branch> HeatSearch::follow() {
  const auto start = [&] {
    s_.heat = heat_at_rest(s_.model);
    s_.film = cold_start(s_.model, s_.point, s_.heat.T_shell.front());
    const Verdict v = solve_equilibrium(
        {s_.model, s_.point, s_.heat.thermal_deformation, {}, control_.stop}, s_.film, s_.cost);
    return v.good() ? solve_heat(s_, options_of(Accuracy::result, true), control_) : v;
  };
  std::optional<Branch> branch;
  if (s_.point.load.unknowns > 0) {
    branch = follow_loads(s_, start, corrector(), control_);
  }
  // Supplies that carry more than a light load press the journal against the other side.
  if (!branch && is_fed_under_pressure(s_.point)) {
    branch = follow_from(s_, Raised::supply, kLight, start, corrector(), control_);
  }
  if (!branch) branch = follow_from(s_, Raised::speed, kLight, start, corrector(), control_);
  return branch;
}

Corrector HeatSearch::corrector() const {
  return [this](Solution& at, Accuracy accuracy) {
    const bool loose = level_.coarse || accuracy == Accuracy::way_point;
    return solve_heat(at, options_of(accuracy, loose), control_);
  };
}

Branch HeatSearch::follow_on(const Branch& ended) {
  const double begun = beyond(ended);
  if (begun < 1.0) {
    return ended.raised == Raised::load
               ? follow_load(s_, begun, corrector(), control_)
               : follow_parts(s_, ended.raised, begun, corrector(), control_);
  }
  const Verdict v = iterate();
  if (v.good()) return {ended.raised, BranchEnd::reached, 1.0, s_.film.least.h, v};
  Branch open = ended;
  open.end = stopped(v) ? BranchEnd::interrupted : BranchEnd::lost;
  open.last = v;
  return open;
}

Verdict HeatSearch::along_branch() {
  std::optional<Branch> branch = follow();
  if (!branch) return no_branch();
  MarchEnd after;
  const auto asked = [&] { return !level_.start || branch->end == BranchEnd::lost; };
  while (ends_early(*branch) && asked() && !s_.cost.spent()) {
    const Reached last = here();
    after = transient_beyond(s_, *branch, control_);
    if (stopped(after.verdict)) {
      back_to(last);
      return after.verdict;
    }
    if (!after.at_rest || level_.start) {
      back_to(last);
      break;
    }
    const double carried = branch->carried;
    branch = follow_on(*branch);
    if (branch->end == BranchEnd::lost && !(branch->carried > carried)) {
      back_to(last);
      break;
    }
  }
  if (branch->end == BranchEnd::reached) return {};
  if (branch->end == BranchEnd::interrupted) return branch->last;
  return ended(*branch, after);
}

Verdict HeatSearch::no_branch() const {
  const BearingModel& m = s_.model;
  if (m.physics.thermal_deformation) {
    const auto closed = closed_at_rest(m.input, *m.solids, m.domain.grid);
    if (closed) return {Status::iteration_limit, *closed};
  }
  if (s_.cost.spent()) return {Status::iteration_limit, ending::Plain::given_up};
  const bool placed = s_.point.load.unknowns == 0;
  return {Status::iteration_limit,
          placed ? ending::Plain::no_slow_state : ending::Plain::no_light_state};
}

bool HeatSearch::speaks_of_more(const Branch& branch) {
  if (branch.raised == Raised::load) return true;
  if (branch.raised == Raised::supply) return false;
  Part of(s_, branch.raised);
  of.take(branch.carried);  // its film belongs to that speed
  const Friction friction = friction_of(s_.model, s_.point, s_.film);
  of.take(1.0);
  const bool rubs = std::abs(friction.asperity) > std::abs(friction.viscous);
  return s_.point.load.unknowns == 0 || !rubs;
}

Verdict HeatSearch::ended(const Branch& branch, const MarchEnd& after) {
  const bool ran_away = after.left_bounds && !s_.cost.spent();
  const bool lost = branch.end == BranchEnd::lost;
  const bool proves = speaks_of_more(branch);
  note_limit(s_, branch, proves && (shows_none_beyond(s_, branch) || ran_away));
  Verdict v = lost && ran_away ? ran_away_from(s_, branch, after) : branch_ended(s_, branch);
  if (!proves) v.status = Status::iteration_limit;
  if (lost && ran_away) return v;
  if (s_.cost.spent() && !level_.start) {  // what more load leads to was not seen
    v.status = Status::iteration_limit;
    v.cause = {{Status::iteration_limit, ending::Plain::given_up}};
  }
  return v;
}

Verdict HeatSearch::through_time() {
  back_to({cold_film_, cold_heat(s_.model, supply_temperature())});
  MarchOptions march;
  march.heat = options_of(Accuracy::way_point, true);
  MarchStand stand{s_.model.solids->uniform_state(supply_temperature())};
  const MarchEnd end = march_heat(s_, stand, march, control_);
  return end.verdict.good() ? iterate() : end.verdict;
}

}  // namespace shellback::bearing
