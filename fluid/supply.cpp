#include "fluid/supply.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::fluid {
namespace {

constexpr double kRoundOff = 1e-9;  ///< relative slack when a cell lies on the edge of a patch [-]

/// a - b brought to [-pi, pi].
double angle_between(double a, double b) { return std::remainder(a - b, 2.0 * kPi); }

bool inside(const FilmGrid& g, const SupplyPatch& s, int i, int j) {
  const double dx = angle_between(g.phi[i], s.phi);
  const double dz = g.z[j] - s.z;
  if (s.round) {
    const double x = dx / (0.5 * s.arc);
    const double z = dz / (0.5 * s.length);
    return x * x + z * z <= 1.0;
  }
  const bool round_all = s.arc >= 2.0 * kPi * (1.0 - kRoundOff);
  return (round_all || std::abs(dx) <= 0.5 * s.arc * (1.0 + kRoundOff)) &&
         std::abs(dz) <= 0.5 * s.length * (1.0 + kRoundOff);
}

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

void mark_line(const FilmGrid& g, const SupplyPatch& s, int patch, SupplyMap& map) {
  int face = nearest(g.phi_face, s.phi, true);
  if (face == g.nt) face = 0;
  for (int j = 0; j < g.nz; ++j) {
    if (std::abs(g.z[j] - s.z) > 0.5 * s.length * (1.0 + kRoundOff)) continue;
    claim(map.line, g.index(face, j), patch);
    map.has_lines = true;
  }
}

}  // namespace

std::vector<double> phi_edges(const std::vector<SupplyPatch>& patches) {
  std::vector<double> edges;
  for (const auto& s : patches) {
    if (s.arc >= 2.0 * kPi * (1.0 - kRoundOff)) continue;
    edges.push_back(s.phi - 0.5 * s.arc);
    if (s.arc > 0.0) edges.push_back(s.phi + 0.5 * s.arc);
  }
  return edges;
}

std::vector<double> z_edges(const std::vector<SupplyPatch>& patches) {
  std::vector<double> edges;
  for (const auto& s : patches) {
    edges.push_back(s.z - 0.5 * s.length);
    edges.push_back(s.z + 0.5 * s.length);
  }
  return edges;
}

SupplyMap map_supplies(const FilmGrid& g, const std::vector<SupplyPatch>& patches) {
  SupplyMap map;
  map.patches = patches;
  map.cell.assign(g.cells(), -1);
  map.line.assign(g.cells(), -1);
  for (int k = 0; k < static_cast<int>(patches.size()); ++k) {
    const SupplyPatch& s = patches[k];
    if (s.arc == 0.0) {
      mark_line(g, s, k, map);
      continue;
    }
    bool any = false;
    for (int i = 0; i < g.nt; ++i) {
      for (int j = 0; j < g.nz; ++j) {
        if (!inside(g, s, i, j)) continue;
        claim(map.cell, g.index(i, j), k);
        any = true;
      }
    }
    if (!any) {  // finer than the grid: the cell nearest to its middle stands for it
      const int i = nearest(g.phi, s.phi, true);
      const int j = nearest(g.z, g.half ? std::abs(s.z) : s.z, false);
      claim(map.cell, g.index(i, j), k);
    }
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
  return map;
}

}  // namespace shellback::fluid
