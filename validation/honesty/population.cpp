#include "validation/honesty/population.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "rheology/viscosity.hpp"
#include "validation/honesty/population_parts.hpp"

namespace shellback::validation {

using namespace bearing;

namespace {

constexpr double kTurn = 2.0 * kPi;

Bearing draw_bearing(Draw& d) {
  Bearing b;
  b.radius = 0.5 * d.log_between(0.020, 0.200);
  b.width = 2.0 * b.radius * d.between(0.2, 1.2);
  b.radial_clearance = b.radius * d.log_between(0.5e-3, 3e-3);
  return b;
}

/// Laminar, and no faster on the surface than plain bearings are run [rad/s].
double draw_speed(Draw& d, const Bearing& b, double nu) {
  constexpr double kFastest = 60.0;  // surface speed [m/s]
  constexpr double kLaminar = 0.8;   // of the critical Reynolds number [-]
  const double laminar =
      kLaminar * 41.2 * std::sqrt(b.radius / b.radial_clearance) * nu / b.radial_clearance;
  const double slowest = 50.0 * kTurn / 60.0;
  const double fastest = std::min(10000.0 * kTurn / 60.0, std::min(kFastest, laminar) / b.radius);
  const double omega = d.log_between(slowest, std::max(fastest, 1.5 * slowest));
  return d.chance(0.9) ? omega : -omega;
}

/// Range of the load over the projected area that the bearing can sensibly carry [Pa].
double draw_specific_load(Draw& d, const Bearing& b, double eta, double omega, bool rough) {
  constexpr double kLightest = 0.05e6;
  constexpr double kHeaviest = 60e6;
  const double ratio = b.radius / b.radial_clearance;
  const double unit = eta * std::abs(omega) * ratio * ratio;  // of Sommerfeld number 1
  const double low = std::clamp(0.02 * unit, kLightest, 0.2 * kHeaviest);
  const double high = std::clamp((rough ? 40.0 : 15.0) * unit, 2.0 * low, kHeaviest);
  return d.log_between(low, std::max(high, 2.0 * low));
}

void draw_position(Draw& d, Case& c, double specific_load) {
  const double angle = d.between(0.0, kTurn);
  const double force = specific_load * 2.0 * c.bearing.radius * c.bearing.width;
  if (d.chance(0.9)) {
    c.operation.position = LoadGiven{force, angle};
    return;
  }
  const double eps = d.between(0.1, 0.95);
  // About where a loaded journal goes: the attitude of the short bearing.
  const double attitude = std::atan2(kPi * std::sqrt(1.0 - eps * eps), 4.0 * eps);
  c.operation.position = EccentricityGiven{eps, d.between(0.8, 1.2) * attitude, angle};
}

double load_angle(const Case& c) {
  if (const auto* load = std::get_if<LoadGiven>(&c.operation.position)) return load->angle;
  return std::get<EccentricityGiven>(c.operation.position).load_angle;
}

/// In a fifth of the cases: a tilt up to a third of the clearance at the edges, or a small moment.
void draw_alignment(Draw& d, Case& c) {
  if (!d.chance(0.2)) return;
  const double angle = d.between(0.0, kTurn);
  const auto* load = std::get_if<LoadGiven>(&c.operation.position);
  if (load != nullptr && d.chance(0.25)) {
    const double moment = load->force * c.bearing.width * d.between(0.0, 0.04);
    c.operation.alignment = MomentGiven{moment * std::cos(angle), moment * std::sin(angle)};
    return;
  }
  const double tilt = 2.0 * c.bearing.radial_clearance / c.bearing.width * d.between(0.02, 0.33);
  c.operation.alignment = TiltGiven{tilt * std::cos(angle), tilt * std::sin(angle)};
}

}  // namespace

Case random_case(std::uint64_t seed) {
  Draw d(seed);
  Case c;
  c.title = "random " + std::to_string(seed);
  c.path = "random-" + std::to_string(seed);
  c.bearing = draw_bearing(d);
  double T_supply = 0.0;
  c.oil = draw_oil(d, T_supply);
  c.oil_temperature = T_supply + d.between(2.0, 25.0);
  const double eta = rheology::viscosity(c.oil, T_supply, 0.0);
  c.operation.omega = draw_speed(d, c.bearing, eta / 860.0);
  const bool rough = d.chance(0.5);
  draw_position(d, c, draw_specific_load(d, c.bearing, eta, c.operation.omega, rough));
  draw_alignment(d, c);
  c.supplies = draw_supplies(d, c.bearing, load_angle(c), T_supply);
  if (rough) c.surfaces = draw_surfaces(d, c.bearing);
  c.shell = draw_shell(d, c.bearing, T_supply);
  c.shaft = draw_shaft(d, c.bearing, T_supply);
  draw_fit(d, c, T_supply);
  c.model.edges = d.chance(0.15) ? Edges::dry : Edges::flooded;
  c.model.cavitation_pressure = d.chance(0.15) ? -d.between(0.0, 0.8e5) : 0.0;
  return c;
}

}  // namespace shellback::validation
