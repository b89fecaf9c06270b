#include "coupling/first_film.hpp"

#include <algorithm>
#include <cmath>

#include "core/largest.hpp"
#include "coupling/load_path.hpp"
#include "coupling/nested.hpp"
#include "coupling/position_path.hpp"
#include "coupling/solids.hpp"
#include "coupling/stepped_start.hpp"

namespace shellback::coupling {
namespace {

LoadTarget scaled(LoadTarget target, double part) {
  for (double& f : target.force) f *= part;
  return target;
}

/// Elastic film by continuation in the load: from the part of the load that a rigid isoviscous
/// film carries with an elastic opening of no more than a few gaps, in growing steps.
Verdict start_elastic(Solution& s, double T, const SolveControl& control) {
  constexpr double kMostOpening = 6.0;  // elastic opening over the smallest gap at the start [-]
  constexpr double kSmallestPart = 1e-4;
  constexpr double kSmallestRatio = 1.05;  // a step of the load below this is not worth taking
  double part = 1.0;
  while (true) {
    Verdict v =
        cold_rigid_film(s.model, scaled(s.target, part), T, true, s.film, s.cost, control.stop);
    if (!v.good()) return v;
    if (!evaluate(s.model, {}, 1e-3, s.film)) break;
    const Field opening = s.model.solids->compliance(s.film.film.p);
    const double most = largest(opening);
    const double gap = std::max(s.film.least.h, 0.0) + s.model.scene.rough.sigma;
    if (s.target.unknowns == 0 || most < kMostOpening * gap || part < kSmallestPart) break;
    part *= 0.25;
  }
  EquilibriumOptions loose;
  loose.film_tolerance = loose.load_tolerance = loose.elastic_tolerance = 1e-2;
  loose.viscosity_tolerance = 1e-2;
  loose.max_iterations = 40;
  double ratio = 3.0;
  while (true) {
    const bool last = part >= 1.0;
    const FilmEquilibrium before = s.film;
    const Verdict v =
        solve_equilibrium(s.model, scaled(s.target, part), s.heat.growth,
                          last ? EquilibriumOptions{} : loose, s.film, s.cost, control.stop);
    if (v.status == Status::interrupted) return v;
    if (v.good() && last) return v;
    if (!v.good()) {
      const double reached = part / ratio;  // the load of `before`
      ratio = std::sqrt(ratio);
      if (ratio < kSmallestRatio || reached < kSmallestPart) return v;
      s.film = before;
      part = reached;
    }
    part = std::min(1.0, part * ratio);
  }
}

/// First equilibrium at one temperature, from cold.
Verdict at_once(Solution& s, double T, const SolveControl& control) {
  if (s.model.physics.elastic) return start_elastic(s, T, control);
  if (s.film_end > 0.0) {
    s.film = cold_start(s.model, T);
    return follow_load(s.model, s.target, s.heat.growth, {}, s.film, s.cost, control.stop,
                       s.film_end);
  }
  Verdict v = cold_rigid_film(s.model, s.target, T, false, s.film, s.cost, control.stop);
  if (!v.good()) return v;
  return solve_equilibrium(s.model, s.target, s.heat.growth, {}, s.film, s.cost, control.stop);
}

}  // namespace

Verdict first_film(Solution& s, double T, const SolveControl& control) {
  const Verdict v = at_once(s, T, control);
  const Methods& by = s.model.input.model.methods;
  const bool other = by.cavitation != CavitationMethod::active_set ||
                     by.elastic != ElasticMethod::newton;  // shown as they are, without our help
  if (v.good() || v.status == Status::interrupted || other) return v;
  if (s.target.unknowns == 0 && s.model.physics.elastic) {
    return follow_position(s.model, s.target, T, {}, s.film, s.cost, control.stop);
  }
  // What rigid surfaces do not carry, elastic ones may.
  const bool proven = v.status == Status::no_steady_state && !s.model.physics.elastic;
  if (proven || s.target.unknowns == 0) return v;
  return stepped_start(s, T, control);
}

}  // namespace shellback::coupling
