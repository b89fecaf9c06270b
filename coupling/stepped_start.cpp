#include "coupling/stepped_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/constants.hpp"
#include "coupling/nested.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::coupling {
namespace {

constexpr double kLightest = 1e-3;          ///< part of the load with which the way begins [-]
constexpr std::array kFast{1e1, 1e2, 1e3};  ///< times the speed, where light loads are none [-]
constexpr double kFirstStep = 0.2;          ///< of the way [-]
constexpr double kShortestStep = 1e-3;      ///< below it the way ends [-]
constexpr const char* kLight = "a light load";
constexpr double kNearBarusLimit = 3.0;  ///< alpha p from which the pressure law is to blame [-]

/// Part of the way at which the scene has `target`, the tilt `psi` and so many times its speed.
struct Waypoint {
  LoadTarget target;
  std::array<double, 2> psi;
  double faster = 1.0;
};
using Way = std::function<Waypoint(double)>;

Verdict solve_at(Solution& s, const Waypoint& at, const SolveControl& control) {
  if (at.target.unknowns < 4) {
    s.film.position.q[2] = at.psi[0];
    s.film.position.q[3] = at.psi[1];
  }
  const double speed = s.model.scene.speed;
  s.model.scene.speed *= at.faster;
  const Verdict v = newton_equilibrium(s.model, at.target, {}, {}, s.film, s.cost, control.stop);
  s.model.scene.speed = speed;
  return v;
}

/// Follows the way from a solved state at 0; `reached` is the part that was solved.
Verdict follow(Solution& s, const Way& way, const SolveControl& control, double& reached) {
  reached = 0.0;
  FilmEquilibrium solved = s.film;
  Verdict verdict;
  for (double step = kFirstStep; reached < 1.0;) {
    const double next = std::min(1.0, reached + step);
    verdict = solve_at(s, way(next), control);
    if (verdict.good()) {
      reached = next;
      solved = s.film;
      step *= 2.0;
      continue;
    }
    s.film = solved;
    if (verdict.status == Status::interrupted || step < kShortestStep) return verdict;
    step *= 0.25;
  }
  return {};
}

/// `begun`: where the way began; `carried`: where it ends.
Verdict end_of_the_way(const Solution& s, const std::string& begun, const std::string& carried,
                       const Verdict& last) {
  const auto& p = s.film.film.p;
  const auto peak = std::max_element(p.begin(), p.end());
  const int cell = static_cast<int>(peak - p.begin());
  const double alpha = rheology::pressure_slope(s.model.oil, s.film.columns.T_mean[cell], *peak);
  const bool law = !s.model.physics.elastic && alpha * *peak > kNearBarusLimit;
  Verdict v{Status::no_steady_state, "", fluid::place_of(s.model.scene.grid, cell),
            "lower the load or the tilt, feed more oil, or give contact data"};
  const bool thin = thinner_than_a_molecule(s.model, s.film);
  v.reason = fmt::format(
      "followed from {}, the steady film ends at {} (smallest gap {:.3g} um{}, alpha p_max "
      "{:.1f}); beyond it: {}",
      begun, carried, s.film.least.h * 1e6, thin ? ", less than a molecule of oil" : "",
      alpha * *peak, last.reason);
  if (law) {
    v.reason = fmt::format(
        "followed from {}, the film carries no more than {}: with rigid surfaces and "
        "viscosity rising with pressure (alpha p_max {:.1f}) its pressure grows without bound",
        begun, carried, alpha * *peak);
    v.cure = "switch on elastic deformation, use the Roelands law, or lower the load";
  }
  if (thin) {
    v.cure = "give roughness and contact data, switch on elastic deformation, or lower the load";
    return v;
  }
  // Steps that fail for another reason do not show that there is no film elsewhere.
  if (!law && last.status != Status::no_steady_state) v.status = Status::iteration_limit;
  return v;
}

/// From a high speed under the whole load, where supply pressure leaves no light load to begin
/// with.
Verdict from_high_speed(Solution& s, double T, const Waypoint& whole, const SolveControl& control,
                        const Verdict& none) {
  for (const double fast : kFast) {
    const Way by_speed = [&](double part) {
      Waypoint at = whole;
      at.faster = std::pow(fast, 1.0 - part);
      return at;
    };
    s.film = cold_start(s.model, T);
    Verdict v = solve_at(s, by_speed(0.0), control);
    if (v.status == Status::interrupted) return v;
    if (!v.good()) continue;
    double reached = 0.0;
    v = follow(s, by_speed, control, reached);
    if (v.good() || v.status == Status::interrupted) return v;
    const double rpm = std::abs(s.model.input.operation.omega) * 30.0 / kPi;
    return end_of_the_way(s, "a high speed",
                          fmt::format("{:.4g} rpm, {:.4g} rpm being asked for",
                                      rpm * std::pow(fast, 1.0 - reached), rpm),
                          v);
  }
  return none;
}

}  // namespace

Verdict stepped_start(Solution& s, double T, const SolveControl& control) {
  const LoadTarget goal = s.target;
  const auto tilt = first_position(s.model.input, s.model.clearance);
  const std::array<double, 2> psi{tilt.psi_x(), tilt.psi_y()};
  const Way by_load = [&](double part) {
    Waypoint at{goal, {0.0, 0.0}};
    for (double& f : at.target.force) f *= std::pow(kLightest, 1.0 - part);
    at.target.force[2] = at.target.force[3] = 0.0;
    return at;
  };
  const Way by_tilt = [&](double part) {
    Waypoint at{goal, {part * psi[0], part * psi[1]}};
    at.target.force[2] *= part;
    at.target.force[3] *= part;
    return at;
  };
  s.film = cold_start(s.model, T);
  Verdict v = solve_at(s, by_load(0.0), control);
  if (v.status == Status::interrupted) return v;
  if (!v.good()) return from_high_speed(s, T, {goal, psi}, control, v);
  double reached = 0.0;
  v = follow(s, by_load, control, reached);
  if (v.status == Status::interrupted) return v;
  if (!v.good()) {
    const double carried = goal.scale() * std::pow(kLightest, 1.0 - reached);
    return end_of_the_way(s, kLight, fmt::format("{:.4g} N of {:.4g} N", carried, goal.scale()), v);
  }
  const bool tilted =
      psi[0] != 0.0 || psi[1] != 0.0 || goal.force[2] != 0.0 || goal.force[3] != 0.0;
  if (!tilted) return v;
  v = follow(s, by_tilt, control, reached);
  if (v.good() || v.status == Status::interrupted) return v;
  return end_of_the_way(s, kLight, fmt::format("{:.3g} of the tilt or moment", reached), v);
}

}  // namespace shellback::coupling
