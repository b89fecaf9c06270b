#include "proof/auto_cases.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/constants.hpp"

namespace shellback::proof {
namespace {

using namespace coupling;

constexpr double kDegree = kPi / 180.0;

/// Numbers in [0, 1) that do not depend on the library's distributions.
class Dice {
 public:
  explicit Dice(int seed) : engine_(static_cast<std::uint64_t>(seed) * 7919U + 13U) {}
  double even(double low, double high) { return low + (high - low) * unit(); }
  double log_even(double low, double high) { return low * std::pow(high / low, unit()); }
  bool chance(double part) { return unit() < part; }

 private:
  double unit() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
  std::mt19937_64 engine_;
};

Supply supply(Dice& dice, const Bearing& b, double T, double load_angle) {
  Supply s;
  if (dice.chance(0.5)) {
    s.kind = SupplyKind::axial_groove;
    s.arc = dice.even(10.0, 30.0) * kDegree;
    s.length = b.width * dice.even(0.5, 0.85);
  } else {
    s.diameter = std::min(0.25 * b.radius, 0.3 * b.width);
  }
  s.angle = load_angle + kPi + dice.even(-40.0, 60.0) * kDegree;
  s.pressure = dice.log_even(0.2e5, 4e5);
  s.temperature = T;
  return s;
}

rheology::Oil oil(Dice& dice) {
  rheology::Oil o;
  o.name = "random";
  o.temperature = rheology::Vogel{0.095e-3 * dice.log_even(0.5, 3.0), 896.4, 110.0};
  o.density = rheology::ConstantDensity{850.0};
  if (dice.chance(0.7)) o.pressure = rheology::Barus{dice.even(8e-9, 20e-9)};
  if (dice.chance(0.4)) o.shear = rheology::Cross{0.5, 4.5e-8, 0.457};
  return o;
}

void add_walls(Dice& dice, double T, Case& c) {
  const double R = c.bearing.radius;
  const solid::Material steel{"steel", 50.0, 7850.0, 460.0, 210e9, 0.3, 11e-6};
  const solid::Material aluminium{"aluminium", 160.0, 2700.0, 900.0, 70e9, 0.33, 23e-6};
  const solid::Material lining{"AlSn", 180.0, 2900.0, 900.0, 70e9, 0.33, 24e-6};
  const auto& body = dice.chance(0.5) ? steel : aluminium;
  const double outer = R * dice.even(1.5, 2.2);
  const double transfer = dice.log_even(50.0, 1000.0);
  c.shell = Shell{{{lining, 0.012 * R}, {steel, 0.07 * R}},
                  Housing{body, outer, HousingSupport::held},
                  ConvectiveBack{transfer, T - dice.even(0.0, 30.0)},
                  50.0};
  const double overhang = dice.even(0.0, 2.0) * R;
  const double fin = dice.log_even(20.0, 200.0);
  c.shaft = Shaft{steel, overhang, fin, T - dice.even(0.0, 20.0)};
}

}  // namespace

Case auto_case(int seed) {
  Dice dice(seed);
  Case c;
  c.title = "random bearing " + std::to_string(seed);
  Bearing& b = c.bearing;
  b.radius = dice.log_even(0.01, 0.1);
  b.width = 2.0 * b.radius * dice.even(0.25, 1.0);
  b.radial_clearance = b.radius * dice.log_even(0.8e-3, 2e-3);
  const double T = kZeroCelsius + dice.even(40.0, 90.0);
  b.reference_temperature = T - dice.even(0.0, 30.0);
  const double load_angle = 270.0 * kDegree;
  c.supplies = {supply(dice, b, T, load_angle)};
  c.operation.omega = dice.log_even(0.5, 30.0) / b.radius;
  c.operation.position =
      LoadGiven{dice.log_even(0.2e6, 15e6) * 2.0 * b.radius * b.width, load_angle};
  c.oil = oil(dice);
  add_walls(dice, T, c);
  if (dice.chance(0.5)) {
    c.surfaces.shell = {0.34e-6, dice.chance(0.5) ? 1.0 : 6.0, 0.28e-6, 0.39e-6};
    c.surfaces.shaft = {0.20e-6, 1.0, 0.13e-6, 0.21e-6};
    c.surfaces.contact = solid::ContactParameters{0.001, 53.3e9, 0.02, {}};
  }
  c.model.tier = Tier::tehd;
  return c;
}

}  // namespace shellback::proof
