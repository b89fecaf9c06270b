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

/// In series, either none: none [W/K].
double in_series(double conductance, double resistance) {
  return conductance > 0.0 ? 1.0 / (1.0 / conductance + resistance) : 0.0;
}

/// What goes into a ring from its inside where `beyond` leaves it outside [W/K]: radial conduction,
/// and the end faces, of which each gives off `ends` [W/(m2 K)] to the same surroundings.
double into_ring(const Case& c, double inner, double outer, const solid::Material& m, double ends,
                 double beyond) {
  constexpr int kParts = 16;  // second order: a fin is then known to a thousandth
  const double B = c.bearing.width;
  // The heat comes from all of the width: on the way to a face it passes a sixth of it.
  const double by_end = in_series(ends, B / (6.0 * m.conductivity));
  double conductance = beyond;
  for (int k = kParts; k-- > 0;) {
    const double a = inner + (outer - inner) * k / kParts,
                 b = inner + (outer - inner) * (k + 1) / kParts;
    const double half = 0.5 * layer(a, b, m) / B;
    conductance = in_series(conductance, half) + 2.0 * by_end * kPi * (b * b - a * a);
    conductance = in_series(conductance, half);
  }
  return conductance;
}

/// Layers, joint, housing and outside as rings; of a given back, whose ends are held by it, the
/// layers alone.
HeatPath shell_path(const Case& c, double film) {
  const Shell& shell = *c.shell;
  const double B = c.bearing.width, ends = shell.end_heat_transfer;
  double r = c.bearing.radius;
  for (const ShellLayer& l : shell.layers) r += l.thickness;
  double conductance = INFINITY, surroundings = 0.0;
  if (const auto* back = std::get_if<PrescribedBack>(&shell.back)) {
    surroundings = back->temperature;
  } else {
    const auto& open = std::get<ConvectiveBack>(shell.back);
    surroundings = open.ambient;
    const double outside = shell.housing ? shell.housing->outer_radius : r;
    conductance = 2.0 * kPi * outside * B * open.heat_transfer;
    if (shell.housing) {
      const double joint = shell.housing->joint_conductance;
      conductance = into_ring(c, r, outside, shell.housing->material, ends, conductance);
      if (joint > 0.0) conductance = in_series(conductance, 1.0 / (2.0 * kPi * r * B * joint));
    }
  }
  for (auto l = shell.layers.rbegin(); l != shell.layers.rend(); ++l) {
    conductance = into_ring(c, r - l->thickness, r, l->material, ends, conductance);
    r -= l->thickness;
  }
  return {in_series(conductance, film / B), surroundings};
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
  for (const Supply& given : c.supplies) {
    const Supply s = enclosed(given, b.radius);
    const double middle = s.angle + (s.kind == SupplyKind::drilling ? turned : 0.0);
    double h3 = 0.0;
    constexpr int kPoints = 16;  // around
    for (int k = 0; k < kPoints; ++k) {
      const double phi = middle + s.arc * ((k + 0.5) / kPoints - 0.5);
      const double h = b.radial_clearance * (1.0 - eps * std::cos(phi - closest));
      h3 += h * h * h / kPoints;
    }
    for (const double z : {s.z, -s.z}) {
      const double way = std::max(0.5 * (b.width - s.length) + z, 0.02 * b.width);
      const double wide = std::min(s.arc * b.radius + way, 2.0 * kPi * b.radius);
      flow += std::max(s.pressure, 0.0) * h3 / (12.0 * eta) * wide / way;
    }
  }
  return flow;
}

}  // namespace shellback::fidelity
