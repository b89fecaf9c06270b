#pragma once
/// Step 2 of tier `auto`: what each effect changes on the probe, and which are left out.
#include <array>
#include <vector>

#include "coupling/solve.hpp"
#include "fidelity/indicators.hpp"

namespace shellback::fidelity {

/// Which effects go on, and what leaving the others out may cost.
struct EffectChoice {
  std::vector<coupling::Effect> effects;  ///< with their changes on the probe
  coupling::Switches switches;            ///< those of the case, with what is left out set false
  double bar_friction = 0.0;              ///< relative, of the effects left out [-]
  double bar_h_min = 0.0;                 ///< [-]
  coupling::EquilibriumCost cost;
};

/// `probe`: converged solution of `c` with all its effects.
[[nodiscard]] EffectChoice choose_effects(const coupling::Case& c, const coupling::Solution& probe,
                                          const Indicators& numbers, double tolerance,
                                          const std::atomic<bool>* stop);

}  // namespace shellback::fidelity
