#pragma once
/// What is not known of the heat where a case has no data of shell and shaft.
#include <atomic>
#include <cmath>

#include "coupling/solve.hpp"

namespace shellback::fidelity {

/// Part of the film's temperature rise that heat into unknown walls may take or recirculation may
/// add: in random cases the lumped balance was off by less in 9 of 10 (docs/auto-tier.md) [-].
inline constexpr double kUnknownHeat = 0.5;

/// Relative bars of the two quantities that the tolerance is for.
struct Bars {
  double friction = INFINITY;
  double h_min = INFINITY;
  [[nodiscard]] bool within(double tolerance) const {
    return friction <= tolerance && h_min <= tolerance;
  }
  [[nodiscard]] double largest() const { return std::max(friction, h_min); }
};

/// Changes of a lumped film whose temperature rise is kUnknownHeat of it higher and lower; infinite
/// where that film does not stand. `cost` is added to.
[[nodiscard]] Bars unknown_heat(const coupling::Solution& lumped, coupling::EquilibriumCost& cost,
                                const std::atomic<bool>* stop);

}  // namespace shellback::fidelity
