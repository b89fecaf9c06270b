#include "bearing/bore_shape.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/round_off.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// Bilinear value of the profile table, periodic in phi, constant beyond its axial ends.
double table_at(const Profile& p, double phi, double z) {
  const int n = static_cast<int>(p.phi.size());
  const int m = static_cast<int>(p.z.size());
  const double turn = 2.0 * kPi;
  phi -= turn * std::floor((phi - p.phi.front()) / turn);
  const int right =
      static_cast<int>(std::upper_bound(p.phi.begin(), p.phi.end(), phi) - p.phi.begin());
  const int a = right - 1;
  const int b = right < n ? right : 0;
  const double end = right < n ? p.phi[right] : p.phi.front() + turn;
  const double u = n > 1 ? (phi - p.phi[a]) / (end - p.phi[a]) : 0.0;
  const int up = static_cast<int>(std::upper_bound(p.z.begin(), p.z.end(), z) - p.z.begin());
  const int lo = std::clamp(up - 1, 0, m - 1);
  const int hi = std::clamp(up, 0, m - 1);
  const double v = hi > lo ? (z - p.z[lo]) / (p.z[hi] - p.z[lo]) : 0.0;
  const auto line = [&](int k) {
    return (1.0 - v) * p.height[k * m + lo] + v * p.height[k * m + hi];
  };
  return (1.0 - u) * line(a) + u * line(b);
}

/// Way into the opening at an edge over its length; 0 outside [-].
double way_into(const EdgeOpening& e, const Bearing& b, double z) {
  return std::max(0.0, std::abs(z) - (0.5 * b.width - e.length)) / e.length;
}

bool table_is_symmetric(const Profile& p) {
  const double highest = largest_magnitude(p.height);
  for (const double phi : p.phi) {
    for (const double z : p.z) {
      if (std::abs(table_at(p, phi, z) - table_at(p, phi, -z)) > kRoundOff * highest) return false;
    }
  }
  return true;
}

}  // namespace

Field profile_of_cells(const Bearing& b, const FilmGrid& g) {
  if (!b.profile) return {};
  Field profile(g.cells());
  for (int k = 0; k < g.cells(); ++k) {
    profile[k] = table_at(*b.profile, g.phi[k / g.nz], g.z[k % g.nz]);
  }
  return profile;
}

double shape_at(const Bearing& b, double phi, double z) {
  double opening = b.shape ? table_at(*b.shape, phi, z) : 0.0;
  if (b.wear) opening += table_at(*b.wear, phi, z);
  if (b.edge_relief) opening += b.edge_relief->depth * std::pow(way_into(*b.edge_relief, b, z), 2);
  if (b.chamfer) opening += b.chamfer->depth * way_into(*b.chamfer, b, z);
  return opening;
}

fluid::Gap shape_of(const Bearing& b, const FilmGrid& g) {
  fluid::Gap shape;
  if (!b.shape && !b.wear && !b.edge_relief && !b.chamfer) return shape;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      shape.cell.push_back(shape_at(b, g.phi[i], g.z[j]));
      shape.phi_face.push_back(shape_at(b, g.phi_face[i], g.z[j]));
    }
    for (int j = 0; j <= g.nz; ++j) shape.z_face.push_back(shape_at(b, g.phi[i], g.z_face[j]));
  }
  return shape;
}

bool bore_is_symmetric(const Bearing& b) {
  return (!b.profile || table_is_symmetric(*b.profile)) &&
         (!b.shape || table_is_symmetric(*b.shape)) && (!b.wear || table_is_symmetric(*b.wear));
}

}  // namespace shellback::bearing
