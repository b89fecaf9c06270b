#include "validation/bench/scenes.hpp"

#include <cmath>

#include "core/constants.hpp"

namespace shellback::bench {
namespace {

using namespace bearing;

constexpr double kDegree = kPi / 180.0;
constexpr double kRpm = kPi / 30.0;  ///< [rad/s]

Case raimondi_boyd() {
  Case c;
  c.bearing = {0.05, 0.1, 100e-6, 293.15, {}};
  Supply line;
  line.kind = SupplyKind::axial_groove;
  line.angle = (270.0 + 50.5 + 180.0) * kDegree;
  line.length = c.bearing.width;
  line.temperature = 313.15;
  c.supplies = {line};
  c.operation.omega = 1000.0 * kRpm;
  c.operation.position = EccentricityGiven{0.6, 50.5 * kDegree, 270.0 * kDegree};
  c.oil.temperature = rheology::ConstantViscosity{0.01};
  c.model.tier = Tier::isothermal;
  return c;
}

Case plain_bearing() {
  Case c;
  c.bearing = {0.05, 0.08, 145e-6, 293.15, {}};
  Supply groove;
  groove.kind = SupplyKind::axial_groove;
  groove.angle = 90.0 * kDegree;
  groove.arc = 18.0 * kDegree;
  groove.length = 0.07;
  groove.pressure = 70e3;
  groove.temperature = 313.15;
  c.supplies = {groove};
  c.operation.omega = 2000.0 * kRpm;
  c.operation.position = LoadGiven{4e3, 270.0 * kDegree};
  c.oil.temperature = rheology::ReynoldsSlope{27.7e-3, 313.15, 0.0341};
  c.oil.conductivity = rheology::ConstantConductivity{0.13};
  c.oil_temperature = 321.15;
  const solid::Material bush{"bush", 250.0, 8800.0, 380.0, 110e9, 0.34, 1.8e-5};
  c.shell = Shell{{{bush, 0.05}}, {}, ConvectiveBack{80.0, 313.15}, 80.0};
  c.shaft = Shaft{{"shaft", 50.0, 7850.0, 460.0, 210e9, 0.3, 1.2e-5}, 0.1, 80.0, 313.15};
  return c;
}

Case ks_rig() {
  Case c;
  c.bearing = {0.0239, 0.0172, 23.9e-6, 373.15, {}};
  Supply hole;
  hole.angle = 90.0 * kDegree;
  hole.diameter = 5e-3;
  hole.pressure = 1e5;
  hole.temperature = 373.15;
  c.supplies = {hole};
  c.operation.omega = 3000.0 * kRpm;
  c.operation.position = LoadGiven{8e3, 270.0 * kDegree};
  c.oil.temperature = rheology::Vogel{0.09521e-3, 896.4, 110.0};
  c.oil.pressure = rheology::Barus{9.5e-9};
  c.oil.shear = rheology::Cross{0.5, 4.5e-8, 0.457};
  c.oil.density = rheology::ConstantDensity{832.5};
  c.oil.heat_capacity = rheology::ConstantHeatCapacity{2083.0};
  c.oil_temperature = 373.15;
  const solid::Material steel{"steel", 50.0, 7850.0, 460.0, 210e9, 0.3, 11e-6};
  const solid::Material aluminium{"aluminium", 160.0, 2700.0, 900.0, 70e9, 0.33, 23e-6};
  const solid::Material lining{"AlSn20", 180.0, 3110.0, 760.0, 62e9, 0.33, 24e-6};
  c.shell = Shell{{{lining, 0.3e-3}, {steel, 1.7e-3}},
                  Housing{aluminium, 0.04, HousingSupport::held},
                  ConvectiveBack{500.0, 363.15},
                  50.0};
  c.shaft = Shaft{steel, 0.0, 0.0, 363.15};
  c.surfaces.shell = {0.34e-6, 12.0, 0.28e-6, 0.39e-6};
  c.surfaces.shaft = {0.20e-6, 4.0, 0.13e-6, 0.21e-6};
  c.surfaces.contact = solid::ContactParameters{0.001, 53.3e9, 0.02, solid::ContactIntegral::exact};
  return c;
}

}  // namespace

Case scene(const std::string& name, std::array<int, 2> grid) {
  Case c = name == "raimondi-boyd"       ? raimondi_boyd()
           : name == "thd-plain-bearing" ? plain_bearing()
                                         : ks_rig();
  c.model.grid = grid;
  return c;
}

LoadCycle pulse_over_two_turns(double omega, double pulse) {
  constexpr int kRows = 144;
  LoadCycle cycle;
  cycle.crank_speed = omega;
  cycle.period = 4.0 * kPi / omega;
  cycle.interpolation = LoadInterpolation::periodic_spline;
  cycle.journal_mass = 1.0;
  for (int k = 0; k < kRows; ++k) {
    const double angle = 4.0 * kPi * k / kRows;
    const double from = angle - 2.0 * kPi;
    cycle.t.push_back(angle / omega);
    cycle.x.push_back(0.15 * pulse * std::cos(angle));
    cycle.y.push_back(0.15 * pulse * std::sin(angle) - pulse * std::exp(-10.0 * from * from));
  }
  return cycle;
}

}  // namespace shellback::bench
