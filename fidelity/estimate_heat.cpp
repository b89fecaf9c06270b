#include "fidelity/estimate_heat.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::fidelity {
namespace {

using namespace coupling;

/// Resistance of a cylindrical layer per length [m K/W].
double layer_resistance(double inner, double outer, double k) {
  return std::log(outer / inner) / (2.0 * kPi * k);
}

HeatPath shell_path(const Case& c, double film) {
  const Shell& shell = *c.shell;
  double r = c.bearing.radius;
  double resistance = film;
  for (const ShellLayer& layer : shell.layers) {
    resistance += layer_resistance(r, r + layer.thickness, layer.material.conductivity);
    r += layer.thickness;
  }
  if (const auto* back = std::get_if<PrescribedBack>(&shell.back)) {
    return {c.bearing.width / resistance, back->temperature};
  }
  const auto& back = std::get<ConvectiveBack>(shell.back);
  if (shell.housing) {
    const double outer = shell.housing->outer_radius;
    resistance += layer_resistance(r, outer, shell.housing->material.conductivity);
    r = outer;
  }
  if (!(back.heat_transfer > 0.0)) return {0.0, back.ambient};
  resistance += 1.0 / (2.0 * kPi * r * back.heat_transfer);
  return {c.bearing.width / resistance, back.ambient};
}

HeatPath shaft_path(const Case& c, double film) {
  const Shaft& shaft = *c.shaft;
  const double R = c.bearing.radius;
  if (!(shaft.overhang > 0.0) || !(shaft.heat_transfer > 0.0)) return {0.0, shaft.ambient};
  const double m = std::sqrt(2.0 * shaft.heat_transfer / (shaft.material.conductivity * R));
  const double fins =
      2.0 * shaft.material.conductivity * kPi * R * R * m * std::tanh(m * shaft.overhang);
  return {1.0 / (film / c.bearing.width + 1.0 / fins), shaft.ambient};
}

}  // namespace

std::vector<HeatPath> solid_heat_paths(const Case& c, double k) {
  const double half_film = 0.5 * c.bearing.radial_clearance / (k * 2.0 * kPi * c.bearing.radius);
  std::vector<HeatPath> paths;
  if (c.shell) paths.push_back(shell_path(c, half_film));
  if (c.shaft) paths.push_back(shaft_path(c, half_film));
  return paths;
}

double pressure_fed_flow(const Case& c, double eps, double centres, double eta) {
  constexpr int kPoints = 16;         // around a patch
  constexpr double kLeastWay = 0.02;  // shortest way to the edge over the width [-]
  const Bearing& b = c.bearing;
  double flow = 0.0;
  for (const Supply& s : c.supplies) {
    const bool hole = s.kind == SupplyKind::hole;
    const double arc = hole ? s.diameter / b.radius : s.arc;
    const double length = hole ? s.diameter : s.length;
    double h3 = 0.0;  // the smallest gap lies at the line of centres
    for (int k = 0; k < kPoints; ++k) {
      const double phi = s.angle + arc * ((k + 0.5) / kPoints - 0.5);
      h3 += std::pow(b.radial_clearance * (1.0 - eps * std::cos(phi - centres)), 3) / kPoints;
    }
    for (const double side : {1.0, -1.0}) {
      const double way = std::max(0.5 * (b.width - length) + side * s.z, kLeastWay * b.width);
      const double wide = std::min(arc * b.radius + way, 2.0 * kPi * b.radius);
      flow += std::max(s.pressure, 0.0) * h3 / (12.0 * eta) * wide / way;
    }
  }
  return flow;
}

}  // namespace shellback::fidelity
