#include "bearing/film/effect_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/told_ranges.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

/// Combined, of all the surface or, if that is more, of the summits alone [m].
double largest_roughness(const Surfaces& of) {
  return std::max(
      combined_roughness(of),
      of.contact ? std::hypot(of.shell.summit_roughness, of.shaft.summit_roughness) : 0.0);
}

}  // namespace

double yielding_film(const BearingModel& m, double h_min) {
  return std::max({h_min, m.domain.rough.sigma, kMolecule});
}

std::vector<Effect> effects_of(const BearingModel& m, const EffectNumbers& n, bool heated) {
  const Physics& has = m.physics;
  const double rate = std::abs(n.U) / std::max(n.h_min, 0.1 * m.clearance);
  const auto thinned = rheology::viscosity_slopes(m.input.oil, n.T, 0.0, rate);
  const double eta = rheology::viscosity(m.input.oil, n.T, 0.0);
  const double beta = -thinned.dln_dT;
  const double k = rheology::conductivity(m.oil, n.T, 0.0).k;
  const double alpha = rheology::pressure_slope(m.input.oil, n.T, 0.0);
  const double sigma = largest_roughness(m.input.surfaces);
  const note::NotLaminar film = reynolds_number(m.input, n.U, n.T);
  return {
      {EffectKind::heating, heated, beta * n.rise},
      {EffectKind::temperature_across_film, has.film_energy, beta * eta * n.U * n.U / k},
      {EffectKind::elastic_deformation, has.elastic, n.opening},
      {EffectKind::thermal_deformation, has.thermal_deformation, n.widening / m.clearance},
      {EffectKind::viscosity_with_pressure, has.pressure_dependence, alpha * n.p_max},
      {EffectKind::shear_thinning, has.shear_thinning, 1.0 - thinned.eta / eta},
      {EffectKind::roughness_and_contact, has.contact || has.flow_factors,
       sigma > 0.0 ? n.h_min / sigma : INFINITY},
      {EffectKind::turbulence, false, film.reynolds / film.limit},
      {EffectKind::film_inertia, false, reduced_reynolds(m.input, film)},
      {EffectKind::inertia_of_fed_oil, false, n.fed},
  };
}

}  // namespace shellback::bearing
