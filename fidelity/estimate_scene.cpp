#include "fidelity/estimate_scene.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/physics.hpp"
#include "core/constants.hpp"
#include "fidelity/closed_forms.hpp"
#include "rheology/density.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

constexpr int kPoints = 180;  ///< around, of the contact's sum

/// Number and widths [m] of the parts of the surface that carry: two beside a groove all round.
std::pair<int, double> lands_of(const Case& c) {
  for (const Supply& s : c.supplies) {
    if (goes_all_round(s) && s.length < c.bearing.width)
      return {2, 0.5 * (c.bearing.width - s.length)};
  }
  return {1, c.bearing.width};
}

}  // namespace

EstimateScene::EstimateScene(const Case& c) : c_(c) {
  const auto [lands, width] = lands_of(c);
  land_ = width;
  width_ = lands * width;
  const Physics physics = physics_of(c, Tier::isothermal);
  oil_ = oil_of(c, physics);
  if (physics.contact) contact_ = contact_of(c);
}

bool EstimateScene::has_ring() const {
  return std::any_of(c_.supplies.begin(), c_.supplies.end(), goes_all_round);
}

double EstimateScene::viscosity(double eps, double T, double load, double omega) const {
  const double e2 = std::min(eps * eps, 0.999);  // the mean rate of a touching film is finite
  const double rate = omega / (psi() * std::sqrt(1.0 - e2));
  return rheology::viscosity_slopes(oil_, T, load / area(), rate).eta;
}

ContactSum EstimateScene::contact(double eps, double eta, double omega) const {
  ContactSum sum;
  if (!contact_) return sum;
  const double patch = c_.bearing.radius * width_ * 2.0 * kPi / kPoints;
  for (int k = 0; k < kPoints; ++k) {
    const double phi = 2.0 * kPi * k / kPoints;  // from the smallest gap
    const double h = c_.bearing.radial_clearance * (1.0 - eps * std::cos(phi));
    const double p = contact_->at(h).p;
    sum.load += p * std::cos(phi) * patch;
    sum.pressure = std::max(sum.pressure, p);
    const auto place = contact_->place(h, p, eta, omega * c_.bearing.radius);
    sum.torque += contact_->friction().stress(place).sum() * c_.bearing.radius * patch;
  }
  return sum;
}

double EstimateScene::contact_load(double eps) const {
  double load = 0.0;
  if (!contact_) return load;
  const double patch = c_.bearing.radius * width_ * 2.0 * kPi / kPoints;
  for (int k = 0; k <= kPoints / 2; ++k) {  // both halves alike
    const double phi = 2.0 * kPi * k / kPoints;
    const double p = contact_->at(c_.bearing.radial_clearance * (1.0 - eps * std::cos(phi))).p;
    load += p * std::cos(phi) * patch * (k == 0 || 2 * k == kPoints ? 1.0 : 2.0);
    if (p == 0.0) break;  // the gap widens from here on
  }
  return load;
}

double EstimateScene::couette(double eps, double fill, double eta, double omega) const {
  const double R = c_.bearing.radius;
  const bool filled = c_.model.cavitated_shear == CavitatedShear::filled;
  return (filled ? fill : 1.0) * couette_torque(eps) * eta * omega * R * R * width_ / psi();
}

double EstimateScene::heat_away(double T, double side_flow,
                                const std::vector<HeatPath>& paths) const {
  const double rho = rheology::density(oil_, T, 0.0).rho;
  const double cp = rheology::heat_capacity(oil_, T).cp;
  double out = rho * cp * side_flow * (T - mean_supply_temperature(c_));
  for (const HeatPath& path : paths) out += path.conductance * (T - path.outside);
  return out;
}

HeatWays heat_ways(const Case& c) {
  const double T_supply = mean_supply_temperature(c);
  HeatWays ways{solid_heat_paths(c, rheology::conductivity(c.oil, T_supply, 0.0).k), T_supply,
                T_supply};
  for (const HeatPath& path : ways.paths) {
    if (path.conductance > 0.0) ways.coldest = std::min(ways.coldest, path.outside);
    ways.warmest = std::max(ways.warmest, path.outside);
  }
  return ways;
}

}  // namespace shellback::fidelity
