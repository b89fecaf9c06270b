#include "app/indicators.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/physics.hpp"
#include "fidelity/indicators.hpp"
#include "rheology/shear.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::app {
namespace {

using namespace bearing;

/// Limits between the three weights; `small` above `large`: small numbers matter.
struct Limits {
  double negligible;
  double important;
};

Weight weigh(double value, const Limits& limits) {
  const bool rising = limits.negligible < limits.important;
  if (rising ? value < limits.negligible : value > limits.negligible) return Weight::negligible;
  if (rising ? value > limits.important : value < limits.important) return Weight::important;
  return Weight::between;
}

struct Advice {
  const char* negligible;
  const char* between;
  const char* important;
};

Indicator make(const char* effect, const char* formula, double value, const Limits& limits,
               const Advice& advice) {
  const Weight weight = weigh(value, limits);
  const char* words = weight == Weight::negligible ? advice.negligible
                      : weight == Weight::between  ? advice.between
                                                   : advice.important;
  return {effect, formula, value, weight, words};
}

void add_thermal(const Case& subject, const Derived& d, std::vector<Indicator>& list) {
  const double c = subject.bearing.radial_clearance;
  list.push_back(make(
      "heating of the film", "beta dT", d.beta * d.heat_per_pass, {0.02, 0.3},
      {"isothermal is enough", "an effective temperature will do", "take the tier thd or tehd"}));
  list.push_back(make("temperature across the film", "Nahme: beta eta U^2/k",
                      d.beta * d.eta * d.speed * d.speed / d.k, {0.05, 0.2},
                      {"uniform across the film", "shows across the film",
                       "must be resolved across the film (thd, tehd)"}));
  const double peclet = d.rho * d.cp * d.speed * c * c / (d.k * subject.bearing.radius);
  list.push_back(make(
      "convection against conduction", "rho cp U c^2/(k R)", peclet, {0.2, 50.0},
      {"the walls rule the film's temperature", "flow and walls both rule the film's temperature",
       "the flow rules; the film's core is nearly adiabatic"}));
}

/// Of tier auto, which chooses: no.
bool is_elastic(const Case& subject) {
  const Tier tier = subject.model.tier;
  const bool solves = tier != Tier::estimate && tier != Tier::automatic;
  return solves && physics_of(subject, tier).elastic;
}

/// Not where deformation alone keeps the surfaces apart.
bool known_film(const Derived& d) { return d.rigid_film && d.h_min > 0.0; }

void add_solid(const Case& subject, const Derived& d, std::vector<Indicator>& list) {
  if (!subject.shell) return;
  if (known_film(d)) {
    list.push_back(
        make("elastic deformation", "C p_max/h_min, C of layers and a held ring",
             fidelity::bore_compliance(subject) * d.p_max / d.h_min, {0.03, 0.1},
             {"rigid surfaces will do", "elastic deformation shows",
              is_elastic(subject) ? "elastic deformation matters; the tier has it"
                                  : "take the tier tehd, or switch elastic_deformation on"}));
  }
  if (!subject.shaft) return;  // how they differ is not known
  list.push_back(make("thermal deformation", "alpha (T - T_ref) R/c",
                      fidelity::thermal_opening(subject, d.T), {0.02, 0.05},
                      {"the clearance stays", "the clearance changes a little",
                       "the clearance changes: take the tier tehd"}));
}

void add_oil(const Case& subject, const Derived& d, std::vector<Indicator>& list) {
  const double alpha = rheology::pressure_slope(subject.oil, d.T, 0.0);
  if (alpha > 0.0 && known_film(d)) {
    list.push_back(make("viscosity and pressure", "alpha p_max", alpha * d.p_max, {0.05, 0.1},
                        {"pressure dependence is negligible", "pressure dependence shows",
                         "pressure dependence matters"}));
  }
  if (!std::holds_alternative<rheology::NoShearThinning>(subject.oil.shear) && known_film(d)) {
    const double rate = d.speed / d.h_min;
    const double loss = 1.0 - rheology::shear_factor(subject.oil.shear, rate).value;
    list.push_back(make("shear thinning", "viscosity lost at U/h_min", loss, {0.02, 0.05},
                        {"Newtonian", "shear thinning shows", "shear thinning matters"}));
  }
}

/// Way over which a supply's pressure falls to the side, from its rim to the land's end [m]: as
/// from a circle of its width around, s ln(1 + land/s), s half of that; the land where it is long
/// around (textbook: flow from a circle into a plane).
double way_of_fed_oil(const Case& subject, const Supply& supply) {
  const Supply mouth = bearing::enclosed(supply, subject.bearing.radius);
  const double land = 0.5 * subject.bearing.width - std::abs(supply.z) - 0.5 * mouth.length;
  const double s = 0.5 * mouth.arc * subject.bearing.radius;
  if (!(land > 0.0) || !(s > 0.0) || goes_all_round(supply)) return land;
  return s * std::log1p(land / s);
}

/// Largest head of oil pressed out of a supply, in a gap of the clearance, over the pressure that
/// drives it [-]; bearing/film/fed_flow.hpp has that of the film.
double fed_head(const Case& subject, const Derived& d) {
  double most = 0.0;
  for (const Supply& supply : subject.supplies) {
    const double way = way_of_fed_oil(subject, supply);
    if (!(supply.pressure > 0.0) || !(way > 0.0)) continue;
    const double c = subject.bearing.radial_clearance;
    const double u = c * c * supply.pressure / (12.0 * d.eta * way);
    most = std::max(most, 0.5 * d.rho * u * u / supply.pressure);
  }
  return most;
}

void add_flow(const Case& subject, const Derived& d, std::vector<Indicator>& list) {
  const double c = subject.bearing.radial_clearance;
  if (d.lambda) {
    list.push_back(make("roughness and contact", "h_min/sigma", *d.lambda, {6.0, 4.0},
                        {"full film", "surfaces come near",
                         "mixed friction is likely: flow "
                         "factors and contact matter"}));
  }
  const double inertia = d.rho * std::abs(subject.operation.omega) * c * c / d.eta;
  list.push_back(
      make("inertia of the oil", "rho omega c^2/eta", inertia, {0.3, 1.0},
           {"negligible", "shows, and is not modelled", "matters, and is not modelled"}));
  if (const double part = fed_head(subject, d); part > 0.0) {
    list.push_back(make("inertia of the fed oil", "(rho u^2/2)/p of supplies, u = c^2 p/(12 eta L)",
                        part, {0.02, 0.1},
                        {"negligible", "shows, and is not modelled",
                         "the film feeds more than the bearing would"}));
  }
  list.push_back(make(
      "turbulence", "Re/(41.2 sqrt(R/c))", d.reynolds / d.reynolds_limit, {0.5, 1.0},
      {"laminar", "laminar, near the limit", "vortices or turbulence, which are not modelled"}));
}

}  // namespace

std::vector<Indicator> indicators(const Case& subject, const Derived& derived) {
  std::vector<Indicator> list;
  add_thermal(subject, derived, list);
  add_solid(subject, derived, list);
  add_oil(subject, derived, list);
  add_flow(subject, derived, list);
  return list;
}

}  // namespace shellback::app
