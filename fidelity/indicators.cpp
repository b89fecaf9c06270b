#include "fidelity/indicators.hpp"

#include <algorithm>
#include <cmath>

#include "rheology/density.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {
namespace {

using namespace coupling;

double thermal_growth(const Case& c, const Estimate& e) {
  if (!c.shell || !c.shaft) return 0.0;
  const double shell = c.shell->housing ? c.shell->housing->material.expansion
                                        : c.shell->layers[0].material.expansion;
  const double warm = e.T - c.bearing.reference_temperature;
  const double expansion =
      std::max(std::abs(shell - c.shaft->material.expansion), 0.3 * c.shaft->material.expansion);
  return expansion * std::abs(warm) * c.bearing.radius / c.bearing.radial_clearance;
}

}  // namespace

double bore_compliance(const Case& c) {
  const Shell& shell = *c.shell;
  const double a = c.bearing.radius;
  double b = a;
  for (const ShellLayer& layer : shell.layers) b += layer.thickness;
  const solid::Material& m = shell.housing ? shell.housing->material : shell.layers[0].material;
  if (shell.housing) b = shell.housing->outer_radius;
  const double nu = m.poisson_ratio;
  return (1.0 + nu) * (b * b - a * a) /
         (a * m.youngs_modulus * (1.0 / (1.0 - 2.0 * nu) + b * b / (a * a)));
}

Indicators indicators(const Case& c, const Estimate& e) {
  const double U = std::abs(c.operation.omega) * c.bearing.radius;
  const double gap = c.bearing.radial_clearance;
  const auto slopes = rheology::viscosity_slopes(c.oil, e.T, 0.0, 0.0);
  const double h = std::max(e.h_min, 1e-9);
  Indicators n;
  n.heating = -slopes.dln_dT * std::abs(e.rise);
  n.across = -slopes.dln_dT * e.eta * U * U / rheology::conductivity(c.oil, e.T, 0.0).k;
  if (c.shell) n.elastic = bore_compliance(c) * e.p_max / h;
  n.thermal = thermal_growth(c, e);
  n.pressure = rheology::pressure_slope(c.oil, e.T, 0.0) * e.p_max;
  n.shear = 1.0 - rheology::viscosity_slopes(c.oil, e.T, 0.0, U / h).eta / slopes.eta;
  n.lambda = e.lambda;
  const double reynolds = rheology::density(c.oil, e.T, 0.0).rho * U * gap / e.eta;
  n.turbulence = reynolds / (41.2 * std::sqrt(c.bearing.radius / gap));
  return n;
}

std::vector<Effect> effects(const Indicators& n, const Physics& has) {
  return {
      {"heating", has.film_energy, n.heating,
       "beta dT of the oil flow; below 0.02 none, above 0.3 resolve it"},
      {"temperature across the film", has.film_energy, n.across,
       "Nahme number; below 0.05 none, above 0.2 resolve it"},
      {"elastic deformation", has.elastic, n.elastic,
       "opening of a ring over smallest film; below 0.03 none, above 0.1 model it"},
      {"thermal deformation", has.growth, n.thermal,
       "growth of the clearance over clearance; above 0.05 model it"},
      {"viscosity with pressure", has.pressure_dependence, n.pressure,
       "alpha p_max; below 0.05 none, above 0.1 model it, above 10 use Roelands"},
      {"shear thinning", has.shear_thinning, n.shear,
       "loss of viscosity at the smallest film; below 0.02 none, above 0.05 model it"},
      {"roughness and contact", has.contact || has.flow_factors, n.lambda,
       "smallest film over roughness; above 6 none, below 4 model it"},
      {"turbulence and Taylor vortices", false, n.turbulence,
       "Reynolds number over 41.2 sqrt(R/c); above 1 the laminar film is left"},
  };
}

}  // namespace shellback::fidelity
