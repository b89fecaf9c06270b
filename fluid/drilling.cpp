/// Mouths of drillings that turn with the journal; declared in supply.hpp.
#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "fluid/supply.hpp"

namespace shellback::fluid {
namespace {

/// One mouth over the grid.
class Placing {
 public:
  Placing(const FilmGrid& g, const SupplyPatch& s, const SupplyMap& supply, const Field& K)
      : g_(g), s_(s), supply_(supply), K_(K), radius_(0.5 * std::max(s.length, cell_diagonal(g))) {}

  /// G of cell (i, j).
  [[nodiscard]] double conductance(int i, int j) const {
    const double x = along(i);
    const double z = g_.z[j] - s_.z;
    const bool within = inside(x, z);
    double sum = 0.0;
    const auto link = [&](double other_x, double other_z, double width, int other) {
      if (supply_.cell[other] >= 0) return;  // a groove stands there, whatever the mouth does
      const double d = std::abs(other_x - x) + std::abs(other_z - z);
      if (within) {
        sum += width / (kShortestReach * d);
      } else if (inside(other_x, other_z)) {
        const bool axial = other_x == x;
        const double across = axial ? x : z;
        const double off = std::abs(axial ? z : x);
        const double reach = off - std::sqrt(radius_ * radius_ - across * across);
        sum += width * (1.0 / std::max(reach, kShortestReach * d) - 1.0 / d);
      }
    };
    for (const int other : {g_.previous(i), g_.next(i)}) {
      link(x + way(i, other), z, g_.dz[j], g_.index(other, j));
    }
    const double round = g_.radius * g_.dphi[i];
    if (j > 0) link(x, g_.z[j - 1] - s_.z, round, g_.index(i, j - 1));
    if (j + 1 < g_.nz) link(x, g_.z[j + 1] - s_.z, round, g_.index(i, j + 1));
    return sum * K_[g_.index(i, j)];
  }

 private:
  [[nodiscard]] bool inside(double x, double z) const { return x * x + z * z < radius_ * radius_; }
  [[nodiscard]] double along(int i) const {
    return g_.radius * std::remainder(g_.phi[i] - s_.phi, 2.0 * kPi);
  }
  /// From the unknown of line i to that of its neighbour [m].
  [[nodiscard]] double way(int i, int other) const {
    return g_.radius * std::remainder(g_.phi[other] - g_.phi[i], 2.0 * kPi);
  }

  const FilmGrid& g_;
  const SupplyPatch& s_;
  const SupplyMap& supply_;
  const Field& K_;
  double radius_;
};

}  // namespace

double cell_diagonal(const FilmGrid& g) {
  const double round = g.radius * *std::max_element(g.dphi.begin(), g.dphi.end());
  return std::hypot(round, *std::max_element(g.dz.begin(), g.dz.end()));
}

void place_mouths(const FilmGrid& g, const Field& K, SupplyMap& supply) {
  supply.mouths.clear();
  std::vector<int> at(g.cells(), -1);
  for (int k = 0; k < static_cast<int>(supply.patches.size()); ++k) {
    if (!supply.patches[k].moving) continue;
    const Placing placing(g, supply.patches[k], supply, K);
    for (int c = 0; c < g.cells(); ++c) {
      if (supply.cell[c] >= 0) continue;
      const double G = placing.conductance(c / g.nz, c % g.nz);
      if (!(G > 0.0)) continue;
      if (at[c] < 0) {
        at[c] = static_cast<int>(supply.mouths.size());
        supply.mouths.push_back({c, k, G});
      } else if (G > supply.mouths[at[c]].conductance) {
        supply.mouths[at[c]] = {c, k, G};
      }
    }
  }
}

}  // namespace shellback::fluid
