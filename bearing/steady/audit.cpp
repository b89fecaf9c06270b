#include "bearing/steady/audit.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::bearing {
namespace {

/// Where next to nothing passes, what is lost is round-off of what goes round: 2e-16 of it is 2e-9
/// of this part.
constexpr double kPasses = 1e-7;

double mass(const Solution& s) {
  const auto flows = fluid::oil_flows(s.point.scene, s.film.flow);
  const double round = kPasses * fluid::flow_scale(s.film.flow);
  const double scale = std::max({std::abs(flows.supply), std::abs(flows.side), round});
  return scale > 0.0 ? std::abs(flows.supply - flows.side - flows.stored) / scale : 0.0;
}

double energy(const Solution& s, const Friction& f) {
  if (!s.model.physics.film_energy || !s.heat.known()) return NAN;
  const double twice = s.model.domain.grid.multiplicity();
  const auto& b = s.heat.balance;
  const double power = f.torque() * s.point.omega();
  // The walls' share as the solids took it up (asperity heat included), not as the film gave it.
  const double gone = twice * (b.carried_out - b.carried_in) + s.heat.solids.shell.heat_in +
                      s.heat.solids.shaft.heat_in;
  const double round = kPasses * twice * (std::abs(b.carried_out) + std::abs(b.carried_in));
  return std::abs(power + pump_power(s.model, s.point, s.film) - gone) /
         std::max(std::abs(power), round);
}

double load(const Solution& s) {
  if (s.point.load.unknowns == 0) return NAN;
  return std::hypot(s.film.force[0] - s.point.load.force[0],
                    s.film.force[1] - s.point.load.force[1]) /
         s.point.load.scale();
}

/// - int p dhT/dphi dA over the film, the mean gap hT as the film equation has it at the faces.
double pressure_moment(const BearingModel& m, const OperatingPoint& point,
                       const FilmEquilibrium& f) {
  const fluid::FilmScene& scene = point.scene;
  const FilmGrid& g = scene.grid;
  const Field& profile = m.profile;
  const auto mean_gap = [&](int face, int side) {
    const double h = f.gap.phi_face[face] + (profile.empty() ? 0.0 : profile[side]);
    return fluid::gap_flow(scene.rough, h).average_gap;
  };
  double sum = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      const int east = g.index(g.next(i), j);
      sum -= f.film.p[k] * (mean_gap(east, k) - mean_gap(k, k)) * g.dz[j];
      if (profile.empty()) continue;
      const double p_face = fluid::face_pressure(scene, f.film, f.flow, k, east);
      sum -= p_face * (mean_gap(east, east) - mean_gap(east, k)) * g.dz[j];
    }
  }
  return sum * g.radius * g.multiplicity();
}

double moment(const Solution& s, const Friction& f) {
  return std::abs(moment_imbalance(s.model, s.point, s.film, f)) /
         std::max(std::abs(f.torque()), 1e-300);
}

}  // namespace

double moment_imbalance(const BearingModel& m, const OperatingPoint& point,
                        const FilmEquilibrium& f, const Friction& friction) {
  return friction.viscous - friction.viscous_shell - pressure_moment(m, point, f);
}

Audit audit_of(const Solution& s, const Friction& f) {
  return {mass(s), energy(s, f), load(s), moment(s, f)};
}

}  // namespace shellback::bearing
