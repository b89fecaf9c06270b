#include "fidelity/lumped_heat.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;

/// Resistance of a cylindrical layer per length [m K/W].
double layer(double inner, double outer, const solid::Material& m) {
  return std::log(outer / inner) / (2.0 * kPi * m.conductivity);
}

HeatPath shell_path(const Case& c, double film) {
  const Shell& shell = *c.shell;
  double r = c.bearing.radius, resistance = film;
  for (const ShellLayer& l : shell.layers) {
    resistance += layer(r, r + l.thickness, l.material);
    r += l.thickness;
  }
  if (const auto* back = std::get_if<PrescribedBack>(&shell.back)) {
    return {c.bearing.width / resistance, back->temperature};
  }
  if (shell.housing) {
    const double joint = shell.housing->joint_conductance;
    if (joint > 0.0) resistance += 1.0 / (2.0 * kPi * r * joint);
    resistance += layer(r, shell.housing->outer_radius, shell.housing->material);
    r = shell.housing->outer_radius;
  }
  const auto& back = std::get<ConvectiveBack>(shell.back);
  if (!(back.heat_transfer > 0.0)) return {0.0, back.ambient};
  resistance += 1.0 / (2.0 * kPi * r * back.heat_transfer);
  return {c.bearing.width / resistance, back.ambient};
}

HeatPath shaft_path(const Case& c, double film) {
  const Shaft& shaft = *c.shaft;
  const double R = c.bearing.radius, k = shaft.material.conductivity;
  if (!(shaft.overhang > 0.0) || !(shaft.heat_transfer > 0.0)) return {0.0, shaft.ambient};
  const double m = std::sqrt(2.0 * shaft.heat_transfer / (k * R));
  const double fins = 2.0 * k * kPi * R * R * m * std::tanh(m * shaft.overhang);
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

double pressure_fed_flow(const Case& c, double eps, double closest, double eta, double turned) {
  const Bearing& b = c.bearing;
  double flow = 0.0;
  for (const Supply& s : c.supplies) {
    const bool drilled = s.kind == SupplyKind::drilling;
    const bool hole = drilled || s.kind == SupplyKind::hole;
    const double middle = s.angle + (drilled ? turned : 0.0);
    const double around = hole ? s.diameter : s.arc * b.radius;
    const double length = hole ? s.diameter : s.length;
    double h3 = 0.0;
    constexpr int kPoints = 16;  // around
    for (int k = 0; k < kPoints; ++k) {
      const double phi = middle + around / b.radius * ((k + 0.5) / kPoints - 0.5);
      const double h = b.radial_clearance * (1.0 - eps * std::cos(phi - closest));
      h3 += h * h * h / kPoints;
    }
    for (const double z : {s.z, -s.z}) {
      const double way = std::max(0.5 * (b.width - length) + z, 0.02 * b.width);
      const double wide = std::min(around + way, 2.0 * kPi * b.radius);
      flow += std::max(s.pressure, 0.0) * h3 / (12.0 * eta) * wide / way;
    }
  }
  return flow;
}

}  // namespace shellback::fidelity
