#include "bearing/steady/effects.hpp"

#include <cmath>

#include "bearing/film/effect_numbers.hpp"
#include "bearing/film/fed_flow.hpp"
#include "core/largest.hpp"
#include "rheology/heat.hpp"

namespace shellback::bearing {
namespace {

double temperature_rise(const Solution& s, const Friction& f, double T) {
  const double flow = fluid::oil_flows(s.point.scene, s.film.flow).side;
  const double cp = rheology::heat_capacity(s.model.oil, T).cp;
  const double power = std::abs(f.torque() * s.point.omega());
  return flow > 0.0 ? power / (flow * cp) : INFINITY;
}

}  // namespace

std::vector<Effect> effects_of(const Solution& s, const Friction& f, Tier tier) {
  const BearingModel& m = s.model;
  EffectNumbers n;
  for (const double T : s.film.columns.T_mean) n.T += T;
  n.T /= static_cast<double>(s.film.columns.T_mean.size());
  n.U = s.point.scene.speed;
  n.h_min = s.film.least.h;
  n.p_max = largest(s.film.film.p);
  n.rise = temperature_rise(s, f, n.T);
  n.fed = fed_flow(s.point.scene, s.film).part;
  if (m.physics.elastic) n.opening = largest(s.film.elastic) / yielding_film(m, n.h_min);
  if (m.physics.thermal_deformation) n.widening = largest_magnitude(s.heat.thermal_deformation);
  return effects_of(m, n, m.physics.film_energy || tier == Tier::lumped);
}

}  // namespace shellback::bearing
