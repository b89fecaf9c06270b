#include "validation/honesty/population_parts.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::validation {

using namespace bearing;

namespace {

constexpr double kDegree = kPi / 180.0;

/// Textbook properties, as in data/materials.toml.
const solid::Material kSteel{"steel", 50.0, 7850.0, 460.0, 210e9, 0.3, 11e-6};
const solid::Material kLining{"AlSn20", 180.0, 3110.0, 760.0, 62e9, 0.33, 24e-6};
const solid::Material kAluminium{"aluminium", 160.0, 2700.0, 900.0, 70e9, 0.33, 23e-6};
const solid::Material kBronze{"bronze", 60.0, 8800.0, 375.0, 110e9, 0.34, 18e-6};
const solid::Material kPolymer{"polymer", 0.3, 1450.0, 1000.0, 2e9, 0.4, 40e-6};

/// Viscosity at 40 degC [Pa s] and slope [1/K] of mineral oils ISO VG 22 to 150, textbook.
struct MineralOil {
  double eta40;
  double beta;
};
constexpr MineralOil kMineral[] = {{0.019, 0.031}, {0.0277, 0.0341}, {0.040, 0.036},
                                   {0.058, 0.039}, {0.086, 0.042},   {0.13, 0.045}};

rheology::PressureLaw draw_pressure_law(Draw& d) {
  const double u = d.unit();
  if (u < 0.25) return rheology::NoPressureEffect{};
  if (u < 0.7) return rheology::Barus{d.between(8e-9, 22e-9)};
  return rheology::Roelands{d.between(0.4, 0.65)};
}

rheology::ShearLaw draw_shear_law(Draw& d) {
  if (d.chance(0.5)) return rheology::NoShearThinning{};
  return rheology::Cross{d.between(0.4, 0.8), d.log_between(1e-8, 2e-7), d.between(0.4, 0.7)};
}

Supply draw_supply(Draw& d, const Bearing& b, SupplyKind kind) {
  Supply s;
  s.kind = kind;
  if (kind == SupplyKind::hole) {
    s.diameter = std::min(d.between(0.06, 0.16) * 2.0 * b.radius, 0.5 * b.width);
    s.length = s.diameter;
    s.arc = s.diameter / b.radius;
    if (d.chance(0.15)) s.z = d.between(-0.5, 0.5) * 0.8 * (b.width - s.length);
  } else if (kind == SupplyKind::axial_groove) {
    s.arc = d.chance(0.15) ? 0.0 : d.between(6.0, 30.0) * kDegree;
    s.length = b.width * d.between(0.4, 0.9);
  } else {
    s.arc = d.chance(0.5) ? 2.0 * kPi : 180.0 * kDegree;
    s.length = b.width * d.between(0.08, 0.25);
  }
  s.depth = d.log_between(0.2e-3, 3e-3);
  return s;
}

}  // namespace

rheology::Oil draw_oil(Draw& d, double& T_supply) {
  rheology::Oil oil;
  const int kind = d.index(4);
  if (kind == 0) {
    oil.name = "constant";
    oil.temperature = rheology::ConstantViscosity{d.log_between(0.005, 0.08)};
    T_supply = kZeroCelsius + d.between(30.0, 90.0);
  } else if (kind == 1) {
    oil.name = "multigrade";
    oil.temperature = rheology::Vogel{d.between(0.08, 0.16) * 1e-3, 896.4, 110.0};
    T_supply = kZeroCelsius + d.between(40.0, 120.0);
  } else {
    const MineralOil& m = kMineral[d.index(6)];
    oil.name = "mineral";
    oil.temperature = rheology::ReynoldsSlope{m.eta40, 40.0 + kZeroCelsius, m.beta};
    T_supply = kZeroCelsius + d.between(30.0, 70.0);
  }
  oil.pressure = draw_pressure_law(d);
  if (kind != 0) oil.shear = draw_shear_law(d);
  oil.density = rheology::ConstantDensity{d.between(820.0, 900.0)};
  oil.conductivity = rheology::ConstantConductivity{d.between(0.125, 0.15)};
  oil.heat_capacity = rheology::ConstantHeatCapacity{d.between(1850.0, 2200.0)};
  return oil;
}

std::vector<Supply> draw_supplies(Draw& d, const Bearing& b, double load_angle, double T_supply) {
  const double u = d.unit();
  const SupplyKind kind = u < 0.4   ? SupplyKind::hole
                          : u < 0.8 ? SupplyKind::axial_groove
                                    : SupplyKind::circumferential_groove;
  Supply first = draw_supply(d, b, kind);
  first.angle =
      d.chance(0.85) ? load_angle + kPi + d.between(-0.5, 0.5) * kPi : d.between(0.0, 2.0 * kPi);
  first.pressure = d.log_between(0.2e5, 6e5);
  first.temperature = T_supply;
  std::vector<Supply> list{first};
  if (kind != SupplyKind::circumferential_groove && d.chance(0.3)) {
    Supply second = first;
    second.angle += d.chance(0.6) ? kPi : d.between(0.4, 1.0) * kPi;
    list.push_back(second);
  }
  for (Supply& s : list) s.angle -= 2.0 * kPi * std::floor(s.angle / (2.0 * kPi));
  return list;
}

Surfaces draw_surfaces(Draw& d, const Bearing& b) {
  const double least = std::min(0.2e-6, 0.01 * b.radial_clearance);
  const double most = std::min(1.0e-6, 0.04 * b.radial_clearance);
  Surfaces s;
  for (solid::RoughSurface* side : {&s.shell, &s.shaft}) {
    side->roughness = d.log_between(least, most);
    side->orientation = d.chance(0.4) ? 1.0 : d.log_between(1.0 / 9.0, 9.0);
    side->summit_roughness = side->roughness * d.between(0.6, 0.9);
    side->summit_height = side->roughness * d.between(0.8, 1.2);
  }
  if (d.chance(0.85)) {
    s.contact = solid::ContactParameters{d.log_between(3e-4, 3e-3), d.between(30e9, 115e9),
                                         d.between(0.02, 0.15), solid::ContactIntegral::exact};
  }
  return s;
}

Shell draw_shell(Draw& d, const Bearing& b, double T_supply) {
  Shell s;
  const double wall = b.radius * d.between(0.08, 0.5);
  const int kind = d.index(4);
  const double lining = std::min(d.between(0.2e-3, 0.6e-3), 0.3 * wall);
  if (kind == 0) s.layers = {{kSteel, wall}};
  if (kind == 1) s.layers = {{kLining, lining}, {kSteel, wall - lining}};
  if (kind == 2) s.layers = {{kBronze, wall}};
  if (kind == 3) {
    const double soft = d.between(0.02e-3, 0.2e-3);
    s.layers = {{kPolymer, soft}, {kSteel, wall - soft}};
  }
  if (d.chance(0.6)) {
    Housing h;
    h.material = d.chance(0.5) ? kSteel : kAluminium;
    h.outer_radius = (b.radius + wall) * d.between(1.2, 2.5);
    const double u = d.unit();
    h.support = u < 0.45   ? HousingSupport::held
                : u < 0.75 ? HousingSupport::free
                           : HousingSupport::clamped;
    s.housing = h;
  }
  if (d.chance(0.15)) {
    s.back = PrescribedBack{T_supply + d.between(-10.0, 15.0)};
  } else {
    s.back = ConvectiveBack{d.log_between(20.0, 1000.0), T_supply - d.between(0.0, 40.0)};
  }
  s.end_heat_transfer = d.log_between(10.0, 200.0);
  return s;
}

Shaft draw_shaft(Draw& d, const Bearing& b, double T_supply) {
  return {kSteel, d.chance(0.2) ? 0.0 : 2.0 * b.radius * d.between(0.2, 2.0),
          d.log_between(10.0, 200.0), T_supply - d.between(0.0, 30.0)};
}

void draw_fit(Draw& d, Case& c, double T_supply) {
  constexpr double kMostLost = 0.25;  // of the clearance [-]
  const double cold = kZeroCelsius + 20.0;
  const double loss = kAluminium.expansion * (T_supply - cold) * c.bearing.radius;
  const bool fits = loss < kMostLost * c.bearing.radial_clearance;
  c.bearing.reference_temperature = d.chance(0.5) && fits ? cold : T_supply;
}

}  // namespace shellback::validation
