#include "bearing/film/pseudo_time.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/film/film_verdicts.hpp"
#include "bearing/film/newton.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"
#include "core/step_control.hpp"

namespace shellback::bearing {
namespace {

constexpr double kFirst = 1e-2;   ///< first step, in radians of turn [-]
constexpr double kLongest = 1e5;  ///< step after which nothing moves any more [rad]
constexpr int kQuick = 6;         ///< iterations after which the next step is longer

/// Part of the flows by which a film's residual is measured that the journal carries [-]. What
/// sinks moves little of the oil that a supply drives through a slow bearing, and yet it moves. 1
/// at rest.
double carried_part(const fluid::FilmFlow& flow) {
  double carried = 0.0;
  for (const fluid::FaceFlow& f : flow.phi) carried = larger(carried, std::abs(f.couette));
  const double all = fluid::flow_scale(flow);
  return carried > 0.0 && carried < all ? carried / all : 1.0;
}

/// Steps are counted in `unit`: the time of a radian of turn, or another [s].
Verdict march_in_time(const FilmTask& task, double unit, FilmEquilibrium& s,
                      EquilibriumCost& cost) {
  const auto& [model, point, thermal_deformation, options, stop, memory] = task;
  if (!evaluate(model, point, thermal_deformation, kWayPoint, s)) return no_film(task, s);
  OperatingPoint moving = point;
  EquilibriumOptions within = options;
  const auto content = [&] { return fluid::oil_content(point.scene, s.gap, s.oil, s.film); };
  double turn = kFirst;
  Field held = content();  // at the beginning of the step, however often it is tried
  for (int step = 0; turn < kLongest; ++step) {
    moving.scene.storage = {turn * unit, held};
    within.film_tolerance = options.film_tolerance * carried_part(s.flow);
    const State before = s;
    const int spent = cost.newton_iterations;
    const Verdict v = newton({model, moving, thermal_deformation, within, stop, memory}, s, cost);
    const bool ended = v.status == Status::interrupted || v.status == Status::invalid_number;
    if (ended || cost.spent()) return v;
    if (step == kMostIterations) {
      return {Status::iteration_limit, ending::NotAtRest{step, s.least.h}, s.least.place()};
    }
    if (v.good()) {
      if (point.load.unknowns > 0 && thinner_than_a_molecule(model, s)) {
        const bool resolved = closing_is_resolved(model, s);
        return {resolved ? Status::no_steady_state : Status::iteration_limit,
                ending::NotAtRest{0, s.least.h, !resolved}, s.least.place()};
      }
      held = content();
      if (cost.newton_iterations - spent <= kQuick) turn /= kStepShorter;
    } else {
      static_cast<State&>(s) = before;
      turn *= kStepShorter;
      if (turn < kStepShortest * kFirst) return v;
    }
  }
  return {};
}

/// As loose as will do on the way.
FilmTask on_the_way(FilmTask task) {
  EquilibriumOptions& o = task.options;
  o.film_tolerance = o.load_tolerance = o.elastic_tolerance = o.viscosity_tolerance = kWayPoint;
  // In a given gap a supply that nearly chokes moves fronts by less than that of the largest flow.
  o.least_iterations = task.point.load.unknowns == 0 ? 1 : 0;
  o.max_iterations = kMostOfWayPoint;
  return task;
}

}  // namespace

Verdict march_to_steady(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost) {
  const Verdict v = march_in_time(on_the_way(task), 1.0 / std::abs(task.point.omega()), s, cost);
  return v.good() ? newton(task, s, cost) : v;
}

namespace {

/// True if a journal that is free to move starts deeper in the shell than asperities reach.
bool starts_inside(const FilmTask& task, FilmEquilibrium& s) {
  if (task.point.load.unknowns == 0) return false;
  const BearingModel& model = task.model;
  s.gap = gap_at(model, s.position, sum(task.thermal_deformation, s.elastic));
  s.least = fluid::smallest_gap(model.domain.grid, s.gap, model.profile, model.supply);
  return s.least.h < -kSummits * model.domain.rough.sigma;
}

/// At rest in the middle of the clearance, in a full film.
void put_in_the_middle(const OperatingPoint& point, FilmEquilibrium& s) {
  s.film = fluid::cold_film(point.scene);
  for (int k = 0; k < point.load.unknowns; ++k) s.position.q[k] = 0.0;
  std::fill(s.elastic.begin(), s.elastic.end(), 0.0);
}

}  // namespace

Verdict come_to_rest(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost) {
  constexpr double kUnit = 10.0;  // the first step is a hundredth of it, the last a million s [s]
  // Gaps in contact hardly let oil pass: a little oil too much there is much pressure. Where
  // nothing flows the rate of shear is round-off, and thinning by it known no better.
  EquilibriumOptions steps;
  steps.viscosity_tolerance = task.options.viscosity_tolerance;
  steps.max_iterations = kMostOfWayPoint;
  put_in_the_middle(task.point, s);
  return march_in_time({task.model, task.point, task.thermal_deformation, steps, task.stop}, kUnit,
                       s, cost);
}

Verdict newton_or_through_time(const FilmTask& task, FilmEquilibrium& s, EquilibriumCost& cost) {
  if (!starts_inside(task, s)) {
    const Verdict v = newton(task, s, cost);
    const bool proven = task.point.load.unknowns == 0 && v.status == Status::no_steady_state;
    const bool ended = v.status == Status::interrupted || v.status == Status::invalid_number;
    if (v.good() || ended || proven || cost.spent()) return v;
  }
  put_in_the_middle(task.point, s);
  return march_to_steady(task, s, cost);
}

}  // namespace shellback::bearing
