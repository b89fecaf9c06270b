#include "bearing/steady/effects.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/film/fed_flow.hpp"
#include "bearing/told_ranges.hpp"
#include "core/largest.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {
namespace {

/// Mean state at which the numbers are taken.
struct Probe {
  double T;      ///< film temperature [K]
  double eta;    ///< viscosity there, low shear [Pa s]
  double beta;   ///< -d ln eta / dT [1/K]
  double rate;   ///< U over the smallest film, or a tenth of the clearance, if that is more [1/s]
  double slope;  ///< part of the viscosity that is lost at `rate` [-]
  double p_max;
  double h_min;  ///< or the roughness, if that is more [m]
};

Probe probe(const Solution& s) {
  const BearingModel& m = s.model;
  Probe p{};
  for (const double T : s.film.columns.T_mean) p.T += T;
  p.T /= static_cast<double>(s.film.columns.T_mean.size());
  p.rate = std::abs(s.point.scene.speed) / std::max(s.film.least.h, 0.1 * m.clearance);
  const auto v = rheology::viscosity_slopes(m.input.oil, p.T, 0.0, p.rate);
  p.eta = rheology::viscosity(m.input.oil, p.T, 0.0);
  p.beta = -v.dln_dT;
  p.slope = 1.0 - v.eta / p.eta;
  p.p_max = largest(s.film.film.p);
  p.h_min = std::max({s.film.least.h, m.domain.rough.sigma, kMolecule});
  return p;
}

/// Combined, of all the surface or, if that is more, of the summits alone [m].
double largest_roughness(const Surfaces& of) {
  return std::max(
      combined_roughness(of),
      of.contact ? std::hypot(of.shell.summit_roughness, of.shaft.summit_roughness) : 0.0);
}

double temperature_rise(const Solution& s, const Friction& f, const Probe& p) {
  const double flow = fluid::oil_flows(s.point.scene, s.film.flow).side;
  const double cp = rheology::heat_capacity(s.model.oil, p.T).cp;
  const double power = std::abs(f.torque() * s.point.omega());
  return flow > 0.0 ? power / (flow * cp) : INFINITY;
}

}  // namespace

std::vector<Effect> effects_of(const Solution& s, const Friction& f, Tier tier) {
  const BearingModel& m = s.model;
  const Physics& has = m.physics;
  const Probe p = probe(s);
  const double U = s.point.scene.speed;
  const double k = rheology::conductivity(m.oil, p.T, 0.0).k;
  const double alpha = rheology::pressure_slope(m.input.oil, p.T, 0.0);
  const double sigma = largest_roughness(m.input.surfaces);
  const note::NotLaminar film = reynolds_number(m.input, U, p.T);
  return {
      {EffectKind::heating, has.film_energy || tier == Tier::lumped,
       p.beta * temperature_rise(s, f, p)},
      {EffectKind::temperature_across_film, has.film_energy, p.beta * p.eta * U * U / k},
      {EffectKind::elastic_deformation, has.elastic,
       has.elastic ? largest(s.film.elastic) / p.h_min : NAN},
      {EffectKind::thermal_deformation, has.thermal_deformation,
       has.thermal_deformation ? largest_magnitude(s.heat.thermal_deformation) / m.clearance : NAN},
      {EffectKind::viscosity_with_pressure, has.pressure_dependence, alpha * p.p_max},
      {EffectKind::shear_thinning, has.shear_thinning, p.slope},
      {EffectKind::roughness_and_contact, has.contact || has.flow_factors,
       sigma > 0.0 ? s.film.least.h / sigma : INFINITY},
      {EffectKind::turbulence, false, film.reynolds / film.limit},
      {EffectKind::film_inertia, false, reduced_reynolds(m.input, film)},
      {EffectKind::inertia_of_fed_oil, false, fed_flow(s.point.scene, s.film).part},
  };
}

}  // namespace shellback::bearing
