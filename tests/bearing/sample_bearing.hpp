#pragma once
/// Cases for the tests of bearing/, made directly, and the few helpers that they share.
#include <cmath>
#include <limits>
#include <random>

#include "bearing/case.hpp"
#include "bearing/steady/solve.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::bearing::tests {

inline constexpr double kDegree = kPi / 180.0;
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

[[nodiscard]] inline solid::Material steel() {
  return {"steel", 50.0, 7850.0, 460.0, 210e9, 0.3, 11e-6};
}
[[nodiscard]] inline solid::Material aluminium() {
  return {"aluminium", 160.0, 2700.0, 900.0, 70e9, 0.33, 23e-6};
}

/// Journal of 50 mm x 25 mm, 30 um clearance, 2000 rpm, fed along a line at the widest gap;
/// isoviscous, smooth, isothermal, 2 kN.
[[nodiscard]] inline Case plain_case() {
  Case c;
  c.title = "plain";
  c.bearing = {0.025, 0.025, 30e-6, 293.15, {}};
  Supply line;
  line.kind = SupplyKind::axial_groove;
  line.angle = 90.0 * kDegree;
  line.length = 0.025;
  line.temperature = 313.15;
  c.supplies = {line};
  c.operation.omega = 2000.0 * kPi / 30.0;
  c.operation.position = LoadGiven{2e3, 270.0 * kDegree};
  c.oil.temperature = rheology::ConstantViscosity{0.015};
  c.oil_temperature = 313.15;
  c.model.tier = Tier::isothermal;
  c.model.grid = {48, 9};
  return c;
}

/// The same, fed at 2 bar by a hole in place of the line.
[[nodiscard]] inline Case hole_case() {
  Case c = plain_case();
  Supply hole;
  hole.angle = 90.0 * kDegree;
  hole.diameter = 4e-3;
  hole.pressure = 2e5;
  hole.temperature = 313.15;
  c.supplies = {hole};
  return c;
}

/// Plain, with walls and an oil that knows heat: steel shell and shaft, cooled outside.
[[nodiscard]] inline Case warm_case() {
  Case c = plain_case();
  c.supplies[0].arc = 20.0 * kDegree;
  c.supplies[0].length = 0.02;
  c.supplies[0].pressure = 1e5;
  c.oil.temperature = rheology::ReynoldsSlope{0.03, 313.15, 0.035};
  c.shell = Shell{{{steel(), 5e-3}},
                  Housing{aluminium(), 0.06, HousingSupport::held},
                  ConvectiveBack{200.0, 303.15},
                  50.0};
  c.shaft = Shaft{steel(), 0.05, 100.0, 303.15};
  c.model.tier = Tier::thd;
  return c;
}

/// Test bearing of the KS rig as cases/ks-rig-test-bearing.toml has it: 8 kN, 3000 rpm, 0W20.
[[nodiscard]] inline Case rig_case() {
  Case c;
  c.title = "rig";
  c.bearing = {0.0239, 0.0172, 23.9e-6, 373.15, {}};
  Supply hole;
  hole.angle = 90.0 * kDegree;
  hole.diameter = 5e-3;
  hole.pressure = 1e5;
  hole.temperature = 373.15;
  c.supplies = {hole};
  c.operation.omega = 3000.0 * kPi / 30.0;
  c.operation.position = LoadGiven{8e3, 270.0 * kDegree};
  c.oil = {"0W20",
           rheology::Vogel{0.09521e-3, 896.4, 110.0},
           rheology::Barus{9.5e-9},
           rheology::Cross{0.5, 4.5e-8, 0.457},
           rheology::ConstantDensity{832.5},
           rheology::ConstantConductivity{0.14},
           rheology::ConstantHeatCapacity{2083.0},
           {},
           {}};
  c.oil_temperature = 373.15;
  const solid::Material lining{"AlSn20", 180.0, 3110.0, 760.0, 62e9, 0.33, 24e-6};
  c.shell = Shell{{{lining, 0.3e-3}, {steel(), 1.7e-3}},
                  Housing{aluminium(), 0.04, HousingSupport::held},
                  ConvectiveBack{500.0, 363.15},
                  50.0};
  c.shaft = Shaft{steel(), 0.0, 0.0, 363.15};
  c.surfaces.shell = {0.34e-6, 12.0, 0.28e-6, 0.39e-6};
  c.surfaces.shaft = {0.20e-6, 4.0, 0.13e-6, 0.21e-6};
  c.surfaces.contact = solid::ContactParameters{0.001, 53.3e9, 0.02, solid::ContactIntegral::exact};
  c.model.tier = Tier::tehd;
  c.model.grid = {100, 13};
  return c;
}

/// The rig's edges made soft: a shaft that ends with the bearing, even cells. Its surfaces touch
/// from about 15 kN on and carry heat up to some 20 kN on few cells.
inline void soften_edges(Case& c) {
  c.shaft->elastic_overhang = 0.0;
  c.model.axial_spacing = AxialSpacing::even;
}

/// Plain bearing with one axial groove as cases/thd-plain-bearing.toml has it: 4 kN, 2000 rpm.
[[nodiscard]] inline Case grooved_case() {
  Case c;
  c.title = "grooved";
  c.bearing = {0.05, 0.08, 145e-6, 293.15, {}};
  Supply groove;
  groove.kind = SupplyKind::axial_groove;
  groove.angle = 90.0 * kDegree;
  groove.arc = 18.0 * kDegree;
  groove.length = 0.07;
  groove.pressure = 70e3;
  groove.temperature = 313.15;
  c.supplies = {groove};
  c.operation.omega = 2000.0 * kPi / 30.0;
  c.operation.position = LoadGiven{4e3, 270.0 * kDegree};
  c.oil.temperature = rheology::ReynoldsSlope{27.7e-3, 313.15, 0.0341};
  c.oil.conductivity = rheology::ConstantConductivity{0.13};
  c.oil_temperature = 321.15;
  const solid::Material bush{"bush", 250.0, 8800.0, 380.0, 110e9, 0.34, 1.8e-5};
  c.shell = Shell{{{bush, 0.05}}, {}, ConvectiveBack{80.0, 313.15}, 80.0};
  c.shaft = Shaft{{"shaft", 50.0, 7850.0, 460.0, 210e9, 0.3, 1.2e-5}, 0.1, 80.0, 313.15};
  c.model.tier = Tier::thd;
  c.model.grid = {100, 13};
  return c;
}

/// Given position: eccentricity ratio and attitude [rad] about a load line at 270 degrees.
inline void place_journal(Case& c, double ratio, double attitude) {
  c.operation.position = EccentricityGiven{ratio, attitude, 270.0 * kDegree};
}
inline void set_load(Case& c, double force) {
  c.operation.position = LoadGiven{force, 270.0 * kDegree};
}

/// Torque on the journal [N m].
[[nodiscard]] inline double torque_of(const Solution& s) {
  return friction_of(s.model, s.point, s.film).torque();
}

/// The load asked for where a bound of the reduced pressure forbids it [N]; other endings: none.
[[nodiscard]] inline double load_beyond_bound(const Verdict& v) {
  const auto* film = v.as<ending::BeyondPressureBound>();
  const auto* branch = v.as<ending::BranchEnded>();
  if (branch && branch->end == ending::BranchEnd::unbounded) return branch->carried.whole;
  return film ? film->wanted : NAN;
}

[[nodiscard]] inline double largest_difference(const Field& a, const Field& b) {
  double m = a.size() == b.size() ? 0.0 : INFINITY;
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) m = larger(m, std::abs(a[k] - b[k]));
  return m;
}

[[nodiscard]] inline Field random_field(std::size_t size, unsigned seed, double low, double high) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(low, high);
  Field f(size);
  for (double& x : f) x = uniform(engine);
  return f;
}

}  // namespace shellback::bearing::tests
