#include "validation/calculix/ring.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::calculix {
namespace {

/// Sizes of one mesh.
struct Sizes {
  int layer;                   ///< bricks across the layer
  double thermal_deformation;  ///< of neighbouring bricks [-]
  double edge;                 ///< brick at an edge of the load over the layer's thickness [-]
  double edge_cap;             ///< but at most this [m]
  double z_cap;                ///< largest brick along z [m]
  double steel;                ///< first brick of the steel [m]
  double r_cap;                ///< largest brick in the steel [m]
  int pressed;                 ///< bricks around the sector under pressure
  int heated;                  ///< under heat
};
constexpr Sizes kCoarse{2, 2.5, 2.0, 0.4e-3, 1.2e-3, 0.6e-3, 8e-3, 6, 9};
constexpr Sizes kFine{4, 1.8, 0.6, 0.1e-3, 0.7e-3, 0.3e-3, 5e-3, 9, 15};

const Sizes& sizes(const Ring& ring) { return ring.fine ? kFine : kCoarse; }

/// Lines from `from` to `to` whose spacings grow from `first`, and from `last` backwards, to
/// at most `cap`.
std::vector<double> graded(double from, double to, double first, double last,
                           double thermal_deformation, double cap) {
  std::vector<double> front, back;
  double a = first, b = last, sum = 0.0;
  while (sum < to - from) {
    if (a <= b) {
      front.push_back(a);
      sum += a;
      a = std::min(thermal_deformation * a, cap);
    } else {
      back.push_back(b);
      sum += b;
      b = std::min(thermal_deformation * b, cap);
    }
  }
  front.insert(front.end(), back.rbegin(), back.rend());
  std::vector<double> lines{from};
  for (const double s : front) lines.push_back(lines.back() + s * (to - from) / sum);
  lines.back() = to;
  return lines;
}

void append(std::vector<double>& lines, const std::vector<double>& more) {
  lines.insert(lines.end(), more.begin() + (lines.empty() ? 0 : 1), more.end());
}

}  // namespace

double sector(Load load) { return load == Load::pressure ? 0.25 * kPi : kPi; }

double patch(double phi, double z) {
  return z < kPatchEnd ? kPressure * std::pow(std::cos(2.0 * phi), 8) : 0.0;
}

double uneven_heat(double r, double phi, double z) {
  const double depth = (r - kBore) / (kOuter - kBore), along = 2.0 * z / kWidth;
  return kHeating * 0.5 * (1.0 + std::cos(phi)) * (1.0 - 0.5 * depth) * (1.0 - 0.5 * along * along);
}

int layer_bricks(const Ring& ring) { return sizes(ring).layer; }

Lines mesh_lines(const Ring& ring) {
  const Sizes& s = sizes(ring);
  Lines lines;
  const double t = ring.thickness, interface = kBore + t;
  for (int m = 0; m <= s.layer; ++m) lines.r.push_back(kBore + t * m / s.layer);
  append(lines.r, graded(interface, kOuter, s.steel, s.r_cap, s.thermal_deformation, s.r_cap));
  const int around = ring.load == Load::pressure ? s.pressed : s.heated;
  for (int m = 0; m <= around; ++m) lines.phi.push_back(sector(ring.load) * m / around);
  const double edge = std::min(s.edge * t, s.edge_cap), end = 0.5 * kWidth;
  if (ring.load == Load::pressure) {
    append(lines.z, graded(0.0, kPatchEnd, s.z_cap, edge, s.thermal_deformation, s.z_cap));
    append(lines.z, graded(kPatchEnd, end, edge, edge, s.thermal_deformation, s.z_cap));
  } else {
    append(lines.z, graded(0.0, end, s.z_cap, edge, s.thermal_deformation, s.z_cap));
  }
  return lines;
}

}  // namespace shellback::calculix
