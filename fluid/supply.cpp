#include "fluid/supply.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback::fluid {
namespace {

/// a - b brought to [-pi, pi].
double angle_between(double a, double b) { return std::remainder(a - b, 2.0 * kPi); }

bool goes_all_round(const SupplyPatch& s) { return s.arc >= 2.0 * kPi * (1.0 - kRoundOff); }

void claim(std::vector<int>& owner, int k, int patch) {
  if (owner[k] >= 0 && owner[k] != patch) {
    throw InputError("two supply features overlap; move them apart or merge them into one");
  }
  owner[k] = patch;
}

int nearest(const std::vector<double>& x, double at, bool periodic) {
  int best = 0;
  const auto distance = [&](int k) {
    return std::abs(periodic ? angle_between(x[k], at) : x[k] - at);
  };
  for (int k = 1; k < static_cast<int>(x.size()); ++k) {
    if (distance(k) < distance(best)) best = k;
  }
  return best;
}

/// Cells of a round hole; one that is finer than the grid is the cell nearest to its middle.
void mark_hole(const FilmGrid& g, const SupplyPatch& s, int patch, SupplyMap& map) {
  bool any = false;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const double x = angle_between(g.phi[i], s.phi) / (0.5 * s.arc);
      const double z = (g.z[j] - s.z) / (0.5 * s.length);
      if (x * x + z * z > 1.0) continue;
      claim(map.cell, g.index(i, j), patch);
      any = true;
    }
  }
  if (any) return;
  const int j = nearest(g.z, g.half ? std::abs(s.z) : s.z, false);
  claim(map.cell, g.index(nearest(g.phi, s.phi, true), j), patch);
}

/// Rows of cells within a patch: at least the one nearest to its middle, where its edges have been
/// merged with those of others.
std::vector<int> rows_within(const FilmGrid& g, const SupplyPatch& s) {
  std::vector<int> rows;
  for (int j = 0; j < g.nz; ++j) {
    if (std::abs(g.z[j] - s.z) <= 0.5 * s.length * (1.0 + kRoundOff)) rows.push_back(j);
  }
  if (rows.empty()) rows.push_back(nearest(g.z, g.half ? std::abs(s.z) : s.z, false));
  return rows;
}

/// Columns and rows of cells within a groove, at least one either way.
void mark_groove(const FilmGrid& g, const SupplyPatch& s, int patch, SupplyMap& map) {
  std::vector<int> columns;
  for (int i = 0; i < g.nt; ++i) {
    const double away = std::abs(angle_between(g.phi[i], s.phi));
    if (goes_all_round(s) || away <= 0.5 * s.arc * (1.0 + kRoundOff)) columns.push_back(i);
  }
  if (columns.empty()) columns.push_back(nearest(g.phi, s.phi, true));
  const std::vector<int> rows = rows_within(g, s);
  for (const int i : columns) {
    for (const int j : rows) claim(map.cell, g.index(i, j), patch);
  }
}

void mark_line(const FilmGrid& g, const SupplyPatch& s, int patch, SupplyMap& map) {
  int face = nearest(g.phi_face, s.phi, true);
  if (face == g.nt) face = 0;
  for (const int j : rows_within(g, s)) claim(map.line, g.index(face, j), patch);
  map.has_lines = true;
}

/// Where the edge of a round hole cuts the link from a film unknown at distance `off` from the
/// hole's middle, measured along the link, `across` from it the other way: distance from the
/// unknown. All in radii. Negative: the link misses the circle.
double to_circle(double off, double across) {
  const double half_chord = 1.0 - across * across;
  return half_chord < 0.0 ? -1.0 : std::abs(off) - std::sqrt(half_chord);
}

/// Distances of film unknowns to the patches beside them.
class Reaches {
 public:
  Reaches(const FilmGrid& g, SupplyMap& map) : g_(g), map_(map) {}

  void measure() {
    map_.phi_reach.assign(g_.cells(), 0.0);
    map_.z_reach.assign(static_cast<std::size_t>(g_.nt) * (g_.nz + 1), 0.0);
    for (int i = 0; i < g_.nt; ++i) {
      const int west = g_.previous(i);
      for (int j = 0; j < g_.nz; ++j) {
        const double link = 0.5 * g_.radius * (g_.dphi[i] + g_.dphi[west]);
        map_.phi_reach[g_.index(i, j)] = between({i, j}, {west, j}, link, false);
        if (j == 0) continue;
        map_.z_reach[i * (g_.nz + 1) + j] =
            between({i, j}, {i, j - 1}, g_.z[j] - g_.z[j - 1], true);
      }
    }
  }

 private:
  struct Cell {
    int i, j;
  };
  [[nodiscard]] double between(Cell a, Cell b, double link, bool axial) const {
    const int patch_a = map_.cell[g_.index(a.i, a.j)], patch_b = map_.cell[g_.index(b.i, b.j)];
    if ((patch_a >= 0) == (patch_b >= 0)) return 0.0;
    const Cell film = patch_a >= 0 ? b : a;
    const SupplyPatch& s = map_.patches[std::max(patch_a, patch_b)];
    const double face =
        axial ? std::abs(g_.z[film.j] - g_.z_face[a.j]) : 0.5 * g_.radius * g_.dphi[film.i];
    if (!s.round) return face;
    const double x = angle_between(g_.phi[film.i], s.phi) / (0.5 * s.arc);
    const double z = (g_.z[film.j] - s.z) / (0.5 * s.length);
    const double reach =
        axial ? 0.5 * s.length * to_circle(z, x) : 0.5 * s.arc * g_.radius * to_circle(x, z);
    // A hole finer than the grid is a cell: its circle does not cut this link.
    return reach < 0.0 || reach > link ? face : std::max(reach, kShortestReach * link);
  }

  const FilmGrid& g_;
  SupplyMap& map_;
};

}  // namespace

namespace {

/// Edge of a strip that has cells of its own; those beside a hole begin as wide as it is.
GridEdge edge_of(const SupplyPatch& s, int patch, double at) {
  GridEdge e(at, patch);
  if (s.round) e.beside = s.length;
  return e;
}

}  // namespace

GridEdges phi_edges(const std::vector<SupplyPatch>& patches) {
  GridEdges edges;
  for (int k = 0; k < static_cast<int>(patches.size()); ++k) {
    const SupplyPatch& s = patches[k];
    if (s.moving || goes_all_round(s)) continue;
    edges.emplace_back(s.phi - 0.5 * s.arc, k);
    if (s.arc > 0.0) edges.emplace_back(s.phi + 0.5 * s.arc, k);
  }
  return edges;
}

GridEdges z_edges(const std::vector<SupplyPatch>& patches) {
  GridEdges edges;
  for (int k = 0; k < static_cast<int>(patches.size()); ++k) {
    const SupplyPatch& s = patches[k];
    if (s.moving) continue;
    edges.push_back(edge_of(s, k, s.z - 0.5 * s.length));
    edges.push_back(edge_of(s, k, s.z + 0.5 * s.length));
  }
  return edges;
}

namespace {

/// `touching` of the header, from the cells.
void find_touching(const FilmGrid& g, SupplyMap& map) {
  std::iota(map.touching.begin(), map.touching.end(), 0);
  const auto join = [&](int a, int b) {
    if (a < 0 || b < 0) return;
    const auto [first, other] = std::minmax(map.touching[a], map.touching[b]);
    const int low = first, high = other;
    std::replace(map.touching.begin(), map.touching.end(), high, low);
  };
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int here = map.cell[g.index(i, j)];
      join(here, map.cell[g.index(g.next(i), j)]);
      if (j + 1 < g.nz) join(here, map.cell[g.index(i, j + 1)]);
    }
  }
}

}  // namespace

Field in_supply(const SupplyMap& map) {
  Field in(map.cell.size());
  for (std::size_t c = 0; c < in.size(); ++c) in[c] = map.cell[c] >= 0 ? 1.0 : 0.0;
  return in;
}

std::vector<double> sum_over_touching(const std::vector<int>& touching,
                                      const std::vector<double>& of_patch) {
  std::vector<double> sum(touching.size(), 0.0);
  for (std::size_t k = 0; k < sum.size(); ++k) sum[touching[k]] += of_patch[k];
  return sum;
}

SupplyMap map_supplies(const FilmGrid& g, const std::vector<SupplyPatch>& patches) {
  SupplyMap map;
  map.patches = patches;
  map.cell.assign(g.cells(), -1);
  map.line.assign(g.cells(), -1);
  map.touching.resize(patches.size());
  for (int k = 0; k < static_cast<int>(patches.size()); ++k) {
    const SupplyPatch& s = patches[k];
    if (s.moving) continue;
    const auto mark = s.arc == 0.0 ? mark_line : s.round ? mark_hole : mark_groove;
    mark(g, s, k, map);
  }
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      if (map.line[k] < 0) continue;
      if (map.cell[k] >= 0 || map.cell[g.index(g.previous(i), j)] >= 0) {
        throw InputError("a supply line touches a groove or hole; move it or leave it out");
      }
    }
  }
  find_touching(g, map);
  Reaches(g, map).measure();
  return map;
}

}  // namespace shellback::fluid
