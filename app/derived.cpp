#include "app/derived.hpp"

#include <array>
#include <cmath>

#include "bearing/steady/solve.hpp"
#include "bearing/told_ranges.hpp"
#include "core/constants.hpp"
#include "rheology/density.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::app {
namespace {

using namespace bearing;

/// Whether the shell-back temperature is known, and with it the equivalent one.
bool back_known(const Case& subject) {
  if (subject.measured.shell_back_temperature) return true;
  return subject.shell && std::holds_alternative<PrescribedBack>(subject.shell->back);
}

void set_temperature(const Case& subject, Derived& d) {
  d.T = equivalent_temperature(subject);
  if (back_known(subject)) {
    d.T_source = "equivalent: T_supply + kappa (T_back - T_supply)";
    if (subject.oil_temperature) d.T_source += ", which takes the place of oil.temperature";
  } else if (subject.oil_temperature) {
    d.T_source = "oil.temperature";
  } else {
    d.T_source = "that of the supplied oil; the film will be warmer";
  }
}

void set_oil(const Case& subject, Derived& d) {
  d.eta = rheology::viscosity(subject.oil, d.T, 0.0);
  d.rho = rheology::density(subject.oil, d.T, 0.0).rho;
  d.cp = rheology::heat_capacity(subject.oil, d.T).cp;
  d.k = rheology::conductivity(subject.oil, d.T, 0.0).k;
  d.beta = 0.0 - rheology::viscosity_slopes(subject.oil, d.T, 0.0, 0.0).dln_dT;  // no minus zero
}

void set_load(const Case& subject, Derived& d) {
  const Bearing& b = subject.bearing;
  const double aspect = b.width / (2.0 * b.radius);
  const double omega = std::abs(subject.operation.omega);
  const double unit = d.eta * omega / (d.clearance_ratio * d.clearance_ratio);  // p at So = 1
  if (const auto* load = std::get_if<LoadGiven>(&subject.operation.position)) {
    d.load_given = true;
    d.specific_load = load->force / (2.0 * b.radius * b.width);
    d.so = d.specific_load / unit;
    d.eccentricity_ratio = estimated_eccentricity(d.so, aspect);
  } else {
    d.eccentricity_ratio = std::get<EccentricityGiven>(subject.operation.position).ratio;
    d.rigid_film = d.eccentricity_ratio < 1.0;
    d.so = d.rigid_film ? estimated_sommerfeld(d.eccentricity_ratio, aspect) : NAN;
    d.specific_load = d.so * unit;
  }
  d.h_min = b.radial_clearance * (1.0 - d.eccentricity_ratio);
  const auto* place = std::get_if<EccentricityGiven>(&subject.operation.position);
  const auto* tilt = std::get_if<TiltGiven>(&subject.operation.alignment);
  if (place != nullptr && tilt != nullptr) {
    const double e = b.radial_clearance * place->ratio;
    const double angle = place->direction(subject.operation.omega);
    for (const double z : {-0.5 * b.width, 0.5 * b.width}) {
      const double x = e * std::cos(angle) + tilt->about_y * z;
      const double y = e * std::sin(angle) - tilt->about_x * z;
      d.h_min = std::min(d.h_min, b.radial_clearance - std::hypot(x, y));
    }
  }
  d.p_max = d.specific_load / estimated_pressure_ratio(d.eccentricity_ratio);
}

}  // namespace

double estimated_sommerfeld(double eps, double b) {
  if (eps <= 0.0) return 0.0;
  const double r = 1.0 - eps * eps;
  const double so_short = b * b * eps * std::sqrt(16.0 * eps * eps + kPi * kPi * r) / (2.0 * r * r);
  const double so_long =
      3.0 * eps * std::sqrt(kPi * kPi * r + 4.0 * eps * eps) / ((2.0 + eps * eps) * r);
  return 1.0 / (1.0 / so_short + 1.0 / so_long);
}

double estimated_eccentricity(double so, double b) {
  constexpr int kHalvings = 60;  // to round-off
  double low = 0.0;
  double high = 1.0;
  for (int k = 0; k < kHalvings; ++k) {
    const double eps = 0.5 * (low + high);
    (eps < 1.0 && estimated_sommerfeld(eps, b) < so ? low : high) = eps;
  }
  return low;
}

double estimated_pressure_ratio(double eps) {
  constexpr std::array<double, 7> kEps{0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.97};
  constexpr std::array<double, 7> kRatio{0.523, 0.506, 0.441, 0.365, 0.267, 0.206, 0.126};
  if (eps <= kEps.front()) return kRatio.front();
  for (std::size_t k = 1; k < kEps.size(); ++k) {
    if (eps > kEps[k]) continue;
    const double part = (eps - kEps[k - 1]) / (kEps[k] - kEps[k - 1]);
    return kRatio[k - 1] + part * (kRatio[k] - kRatio[k - 1]);
  }
  return kRatio.back();
}

Derived derive(const Case& subject) {
  const Bearing& b = subject.bearing;
  const double R = b.radius;
  const double c = b.radial_clearance;
  const double omega = std::abs(subject.operation.omega);
  Derived d;
  set_temperature(subject, d);
  set_oil(subject, d);
  d.speed = omega * R;
  d.clearance_ratio = c / R;
  set_load(subject, d);
  d.reynolds = d.rho * d.speed * c / d.eta;
  d.reynolds_limit = kTaylor * std::sqrt(R / c);
  d.petroff_torque = 2.0 * kPi * d.eta * omega * R * R * R * b.width / c;
  d.petroff_power = d.petroff_torque * omega;
  d.heat_per_pass = 4.0 * kPi * d.eta * omega * (R / c) * (R / c) / (d.rho * d.cp);
  const double sigma = bearing::combined_roughness(subject.surfaces);
  if (sigma > 0.0) d.lambda = d.h_min / sigma;
  return d;
}

}  // namespace shellback::app
