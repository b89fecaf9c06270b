#include "core/grid.hpp"

#include <cmath>

#include "core/between.hpp"

namespace shellback {

FilmGrid full_grid(const FilmGrid& grid) {
  if (!grid.half) return grid;
  FilmGrid g = grid;
  g.half = false;
  g.nz = grid.full_nz();
  const bool split_cell = grid.z[0] == 0.0;
  g.z_face.clear();
  for (int j = grid.nz; j >= 1; --j) g.z_face.push_back(-grid.z_face[j]);
  if (!split_cell) g.z_face.push_back(0.0);
  for (int j = 1; j <= grid.nz; ++j) g.z_face.push_back(grid.z_face[j]);
  g.z.clear();
  g.dz.clear();
  for (int j = 0; j < g.nz; ++j) {
    g.z.push_back(0.5 * (g.z_face[j] + g.z_face[j + 1]));
    g.dz.push_back(g.z_face[j + 1] - g.z_face[j]);
  }
  return g;
}

Field mirror_to_full(const FilmGrid& grid, const Field& half_field) {
  if (!grid.half) return half_field;
  const int nz = grid.full_nz();
  Field full(static_cast<std::size_t>(grid.nt) * nz);
  for (int i = 0; i < grid.nt; ++i) {
    for (int j = 0; j < grid.nz; ++j) {
      const double v = half_field[grid.index(i, j)];
      full[i * nz + (nz - grid.nz + j)] = v;
      full[i * nz + (grid.nz - 1 - j)] = v;
    }
  }
  return full;
}

Field per_cell(const FilmGrid& grid, Field per_area) {
  for (int c = 0; c < grid.cells(); ++c) per_area[c] *= grid.area(c);
  return per_area;
}

double area_integral(const FilmGrid& grid, const Field& field) {
  double sum = 0.0;
  for (int c = 0; c < grid.cells(); ++c) sum += field[c] * grid.area(c);
  return sum * grid.multiplicity();
}

double area_mean(const FilmGrid& grid, const Field& field) {
  double sum = 0.0;
  double area = 0.0;
  for (int c = 0; c < grid.cells(); ++c) {
    const double a = grid.area(c);
    sum += a * field[c];
    area += a;
  }
  return sum / area;
}

double axial_mean(const FilmGrid& grid, const std::vector<double>& of_rings) {
  double sum = 0.0;
  for (int j = 0; j < grid.nz; ++j) sum += of_rings[j] * grid.dz[j];
  return sum / (grid.z_face.back() - grid.z_face.front());
}

Field interpolate(const FilmGrid& from, const Field& field, const FilmGrid& to) {
  Field out(static_cast<std::size_t>(to.cells()));
  std::vector<Between> axial;
  for (const double z : to.z) axial.push_back(between(from.z, from.half ? std::abs(z) : z));
  for (int i = 0; i < to.nt; ++i) {
    const Between a = between_around(from.phi, to.phi[i]);
    for (int j = 0; j < to.nz; ++j) {
      const Between b = axial[j];
      const auto line = [&](int k) {
        return (1.0 - b.weight) * field[from.index(k, b.left)] +
               b.weight * field[from.index(k, b.right)];
      };
      out[to.index(i, j)] = (1.0 - a.weight) * line(a.left) + a.weight * line(a.right);
    }
  }
  return out;
}

}  // namespace shellback
