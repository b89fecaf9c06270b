#include "surface/holes.hpp"

#include <Eigen/Sparse>
#include <array>
#include <cmath>

#include "core/contract.hpp"
#include "core/eigen.hpp"
#include "surface/sparse_spd.hpp"

namespace shellback::surface {

Holes holes_of(const HeightMap& map) {
  Holes holes;
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) {
      if (std::isfinite(map.at(i, j))) continue;
      if (holes.count++ == 0) holes.i = i, holes.j = j;
    }
  }
  return holes;
}

HeightMap fill_laplace(HeightMap map) {
  const Holes holes = holes_of(map);
  if (holes.count == 0) return map;
  if (holes.count == map.nx * map.ny) throw InputError("the map holds no height at all");
  std::vector<int> unknown(map.z.size(), -1);
  int n = 0;
  for (std::size_t c = 0; c < map.z.size(); ++c) {
    if (!std::isfinite(map.z[c])) unknown[c] = n++;
  }
  const double wx = map.dy / map.dx, wy = map.dx / map.dy;
  struct Side {
    int i, j;
    double weight;
  };
  const std::array<Side, 4> sides{{{-1, 0, wx}, {1, 0, wx}, {0, -1, wy}, {0, 1, wy}}};
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n);
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) {
      const int row = unknown[map.index(i, j)];
      if (row < 0) continue;
      for (const Side& side : sides) {
        const int a = i + side.i, b = j + side.j;
        if (a < 0 || b < 0 || a >= map.nx || b >= map.ny) continue;
        entries.emplace_back(row, row, side.weight);
        const int column = unknown[map.index(a, b)];
        if (column < 0) {
          rhs[row] += side.weight * map.at(a, b);
        } else {
          entries.emplace_back(row, column, -side.weight);
        }
      }
    }
  }
  const SparseSpd factor(n, entries);
  const Eigen::VectorXd z = factor.solve(rhs);
  for (std::size_t c = 0; c < map.z.size(); ++c) {
    if (unknown[c] >= 0) map.z[c] = z[unknown[c]];
  }
  return map;
}

}  // namespace shellback::surface
