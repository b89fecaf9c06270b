#include "fidelity/auto_effects.hpp"

#include <cmath>

#include "fidelity/frozen_film.hpp"

namespace shellback::fidelity {
namespace {

using namespace coupling;

constexpr double kNegligible = 0.1;  ///< share of the tolerance that one effect left out may change
constexpr double kFeedback = 2.0;    ///< whole change over the direct one that is reckoned with [-]

struct Scalars {
  double friction;
  double h_min;
};

Scalars scalars(const Solution& s) {
  const Friction f = friction_of(s.model, s.film);
  return {f.viscous + f.asperity, s.film.least.h};
}

void add(const EquilibriumCost& from, EquilibriumCost& to) {
  to.factorizations += from.factorizations;
  to.newton_iterations += from.newton_iterations;
}

/// The effect of each name in the list of indicators, taken out.
Frozen without(const std::string& name) {
  Frozen f;
  if (name == "heating") f.heating = false;
  if (name == "temperature across the film") f.across = false;
  if (name == "elastic deformation") f.elastic = false;
  if (name == "thermal deformation") f.growth = false;
  if (name == "viscosity with pressure") f.pressure = false;
  if (name == "shear thinning") f.shear = false;
  if (name == "roughness and contact") f.roughness = false;
  return f;
}

/// True if the number itself says that there is nothing to probe.
bool absent(const Effect& e) {
  return e.name == "roughness and contact" ? std::isinf(e.indicator) : e.indicator == 0.0;
}

/// Switches the effect off where the user has not decided. False: it cannot be left out.
bool leave_out(const std::string& name, const Switches& given, Switches& to) {
  if (name == "elastic deformation" && !given.elastic_deformation) {
    to.elastic_deformation = false;
  } else if (name == "thermal deformation" && !given.thermal_deformation) {
    to.thermal_deformation = false;
  } else if (name == "viscosity with pressure" && !given.pressure_dependence) {
    to.pressure_dependence = false;
  } else if (name == "shear thinning" && !given.shear_thinning) {
    to.shear_thinning = false;
  } else if (name == "roughness and contact" && !given.flow_factors && !given.asperity_contact) {
    to.flow_factors = false;
    to.asperity_contact = false;
  } else {
    return false;
  }
  return true;
}

}  // namespace

EffectChoice choose_effects(const Case& c, const Solution& probe, const Indicators& numbers,
                            double tolerance, const std::atomic<bool>* stop) {
  EffectChoice out;
  out.switches = c.model.switches;
  out.effects = effects(numbers, probe.model.physics);
  const std::array<int, 2> grid{probe.model.scene.grid.nt, probe.model.scene.grid.full_nz()};
  const Scalars with = scalars(probe);
  for (Effect& e : out.effects) {
    if (!e.included) continue;
    if (absent(e)) {
      e.change_in_friction = e.change_in_h_min = 0.0;
    } else {
      const Solution s = frozen_film(probe, grid, without(e.name), stop);
      add(s.cost, out.cost);
      if (!s.verdict.good()) continue;  // the film does not stand without it
      const Scalars without_it = scalars(s);
      e.change_in_friction = 1.0 - without_it.friction / with.friction;
      e.change_in_h_min = 1.0 - without_it.h_min / with.h_min;
    }
    const double f = std::abs(e.change_in_friction);
    const double h = std::abs(e.change_in_h_min);
    if (!(f < kNegligible * tolerance) || !(h < kNegligible * tolerance)) continue;
    if (!leave_out(e.name, c.model.switches, out.switches)) continue;
    e.included = false;
    out.bar_friction += kFeedback * f;
    out.bar_h_min += kFeedback * h;
  }
  return out;
}

}  // namespace shellback::fidelity
