/// Mouths of drillings that turn with the journal; declared in supply.hpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constants.hpp"
#include "core/round_off.hpp"
#include "fluid/supply.hpp"

namespace shellback::fluid {
namespace {

/// Which mouth holds a cell: of those that reach over it, as widened ones on coarse grids may
/// together, that whose middle is the nearest; of equally near ones that of the higher pressure.
/// None is asked which comes first in the case.
class Held {
 public:
  explicit Held(int cells)
      : owner_(cells, -1), distance_(cells, std::numeric_limits<double>::infinity()) {}

  void take(int cell, int patch, double distance, const std::vector<SupplyPatch>& patches) {
    const bool nearer = distance < (1.0 - kRoundOff) * distance_[cell];
    const bool as_near = distance <= (1.0 + kRoundOff) * distance_[cell];
    const bool higher =
        as_near && patches[patch].pressure > patches[std::max(owner_[cell], 0)].pressure;
    if (nearer || higher) owner_[cell] = patch, distance_[cell] = distance;
  }
  [[nodiscard]] int by(int cell) const { return owner_[cell]; }  ///< -1: by none

 private:
  std::vector<int> owner_;
  Field distance_;  ///< [m]
};

/// One mouth over the grid.
class Placing {
 public:
  Placing(const FilmGrid& g, int patch, const SupplyMap& supply, const Field& K)
      : g_(g),
        s_(supply.patches[patch]),
        patch_(patch),
        supply_(supply),
        K_(K),
        radius_(0.5 * std::max(s_.length, cell_diagonal(g))) {}

  /// Takes the cells that the mouth reaches over.
  void take(Held& held) const {
    for (int c = 0; c < g_.cells(); ++c) {
      const double x = along(c / g_.nz), z = g_.z[c % g_.nz] - s_.z;
      if (inside(x, z)) held.take(c, patch_, std::hypot(x, z), supply_.patches);
    }
  }

  /// G of cell (i, j): of its links to cells that this mouth holds, or of all of them if it is one
  /// of these.
  [[nodiscard]] double conductance(int i, int j, const Held& held) const {
    const double x = along(i);
    const double z = g_.z[j] - s_.z;
    const int holder = held.by(g_.index(i, j));
    if (holder >= 0 && holder != patch_) return 0.0;
    double sum = 0.0;
    const auto link = [&](double other_x, double other_z, double width, int other) {
      if (supply_.cell[other] >= 0) return;  // a groove stands there, whatever the mouth does
      const double d = std::abs(other_x - x) + std::abs(other_z - z);
      if (holder == patch_) {
        sum += width / (kShortestReach * d);
      } else if (held.by(other) == patch_) {
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
  int patch_;
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
  Held held(g.cells());
  const auto each = [&](const auto& visit) {
    for (int k = 0; k < static_cast<int>(supply.patches.size()); ++k) {
      if (supply.patches[k].moving) visit(k, Placing(g, k, supply, K));
    }
  };
  each([&](int, const Placing& mouth) { mouth.take(held); });
  each([&](int k, const Placing& mouth) {
    for (int c = 0; c < g.cells(); ++c) {
      if (supply.cell[c] >= 0) continue;
      const double G = mouth.conductance(c / g.nz, c % g.nz, held);
      if (G > 0.0) supply.mouths.push_back({c, k, G});
    }
  });
}

}  // namespace shellback::fluid
