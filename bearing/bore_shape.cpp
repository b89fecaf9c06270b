#include "bearing/bore_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/between.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

/// Bilinear value of the profile table, periodic in phi, constant beyond its axial ends.
double table_at(const Profile& p, double phi, double z) {
  const Between around = between_around(p.phi, phi), along = shellback::between(p.z, z);
  const auto m = static_cast<int>(p.z.size());
  const auto line = [&](int k) {
    const double *row = p.height.data() + k * m, v = along.weight;
    return (1.0 - v) * row[along.left] + v * row[along.right];
  };
  return (1.0 - around.weight) * line(around.left) + around.weight * line(around.right);
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

fluid::ShapeBeside shape_beside_faces(const FilmGrid& g, const fluid::Gap& shape) {
  fluid::ShapeBeside beside;
  if (shape.cell.empty()) return beside;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j <= g.nz; ++j) {
      const double face = shape.z_face[i * (g.nz + 1) + j];
      beside.below.push_back(j == 0 ? 0.0 : shape.cell[g.index(i, j - 1)] - face);
      beside.above.push_back(j == g.nz ? 0.0 : shape.cell[g.index(i, j)] - face);
    }
  }
  return beside;
}

namespace {

/// Cell of x, the faces rising.
int cell_of(const std::vector<double>& face, double x) {
  const auto above = std::upper_bound(face.begin() + 1, face.end() - 1, x);
  return static_cast<int>(above - face.begin()) - 1;
}

/// How far f lies from the straight line between the middle of x's cell and its face beside x.
template <class F>
double off_line(const F& f, double x, double middle, double low, double high) {
  const double face = x < middle ? low : high;
  const double part = face == middle ? 0.0 : (x - middle) / (face - middle);
  return std::abs(f(x) - ((1.0 - part) * f(middle) + part * f(face)));
}

void look_at(const Bearing& b, const FilmGrid& g, double phi, double z, MissedShape& worst) {
  if (g.half) z = std::abs(z);
  if (std::abs(z) > 0.5 * b.width) return;
  const double first = g.phi_face.front();
  phi -= 2.0 * kPi * std::floor((phi - first) / (2.0 * kPi));
  const int i = cell_of(g.phi_face, phi);
  const int j = cell_of(g.z_face, z);
  const double along = off_line([&](double x) { return shape_at(b, phi, x); }, z, g.z[j],
                                g.z_face[j], g.z_face[j + 1]);
  const double around = off_line([&](double x) { return shape_at(b, x, z); }, phi, g.phi[i],
                                 g.phi_face[i], g.phi_face[i + 1]);
  const double depth = std::max(along, around);
  if (depth > worst.depth) worst = {depth, phi, z};
}

void look_at_table(const Bearing& b, const FilmGrid& g, const Profile& table, MissedShape& worst) {
  for (const double phi : table.phi) {
    for (const double z : table.z) look_at(b, g, phi, z, worst);
  }
}

/// Integrals of a table and of its magnitude over the width [m2 rad], by trapezia between its
/// points.
std::array<double, 2> volume_of(const Profile& p, double width) {
  std::vector<double> z{-0.5 * width, 0.5 * width};
  for (const double at : p.z) {
    if (std::abs(at) < 0.5 * width) z.push_back(at);
  }
  std::sort(z.begin(), z.end());
  std::array<double, 2> sum{};
  const std::size_t n = p.phi.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = n > 1 ? std::remainder(p.phi[(i + 1) % n] - p.phi[i], 2.0 * kPi) : 0.0;
    const double arc = turn > 0.0 ? turn : turn + 2.0 * kPi;
    for (const double phi : {p.phi[i], p.phi[(i + 1) % n]}) {
      for (std::size_t k = 0; k + 1 < z.size(); ++k) {
        for (const double at : {z[k], z[k + 1]}) {
          const double part = 0.25 * arc * (z[k + 1] - z[k]) * table_at(p, phi, at);
          sum[0] += part;
          sum[1] += std::abs(part);
        }
      }
    }
  }
  return sum;
}

}  // namespace

MissedShape missed_shape(const Bearing& b, const FilmGrid& g) {
  MissedShape worst;
  if (b.shape) look_at_table(b, g, *b.shape, worst);
  if (b.wear) look_at_table(b, g, *b.wear, worst);
  for (const auto& opening : {b.edge_relief, b.chamfer}) {
    MissedShape at_foot = worst;
    if (opening) look_at(b, g, g.phi.front(), 0.5 * b.width - opening->length, at_foot);
    if (at_foot.depth > worst.depth) worst = {at_foot.depth, NAN, at_foot.z};  // all round
  }
  return worst;
}

double missed_profile(const Bearing& b, const FilmGrid& g) {
  if (!b.profile) return 0.0;
  const auto [volume, size] = volume_of(*b.profile, b.width);
  const Field cells = profile_of_cells(b, g);
  double on_grid = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      on_grid += cells[g.index(i, j)] * g.area(i, j) / g.radius * g.multiplicity();
    }
  }
  return size > 0.0 ? std::abs(on_grid - volume) / size : 0.0;
}

std::vector<double> room_around(const Bearing& b, int n) {
  constexpr int kAlong = 32;
  std::vector<double> room(n, b.radial_clearance);
  if (!b.profile && !b.shape && !b.wear && !b.edge_relief && !b.chamfer) return room;
  std::vector<double> narrowest(n, std::numeric_limits<double>::infinity());
  for (int i = 0; i < n; ++i) {
    const double phi = 2.0 * kPi * i / n;
    for (int j = 0; j <= kAlong; ++j) {
      const double z = (static_cast<double>(j) / kAlong - 0.5) * b.width;
      const double profile = b.profile ? table_at(*b.profile, phi, z) : 0.0;
      narrowest[i] = std::min(narrowest[i], b.radial_clearance + profile + shape_at(b, phi, z));
    }
  }
  for (int k = 0; k < n; ++k) {
    room[k] = narrowest[k];
    for (int i = 0; i < n; ++i) {
      const double towards = std::cos(2.0 * kPi * (i - k) / n);
      if (towards > kRoundOff) room[k] = std::min(room[k], narrowest[i] / towards);
    }
  }
  return room;
}

bool bore_is_symmetric(const Bearing& b) {
  return (!b.profile || table_is_symmetric(*b.profile)) &&
         (!b.shape || table_is_symmetric(*b.shape)) && (!b.wear || table_is_symmetric(*b.wear));
}

}  // namespace shellback::bearing
