#pragma once
/// Error bar of the physics left out, and what each effect does.
///
/// The full physics of the case is solved on a coarse grid, effect by effect, each from the
/// solution before; the difference from the tier's own solution on the same coarse grid stands for
/// that on the fine one (docs/decisions/011). Stronger than the one residual evaluation of
/// methods 7.3, since the coarse system is solved to the end, and no dearer than a few of its
/// Newton steps.
#include "fidelity/coarse_solution.hpp"

namespace shellback::fidelity {

/// What one effect changes on the coarse grid.
struct EffectChange {
  std::string effect;
  double friction = 0.0;  ///< relative change of the friction torque [-]; NaN: not known
  double h_min = 0.0;     ///< of the smallest film [-]
};

struct ModelError {
  /// Change of each quantity from the tier to the full physics, on the coarse grid.
  std::vector<coupling::Quantity> change;
  std::vector<EffectChange> effects;  ///< of the effects left out
  std::vector<std::string> unknown;   ///< effects for which the case has no data
  std::vector<std::string> failed;    ///< effects whose coarse solve gave nothing
  bool complete = false;              ///< the full physics was reached (and `change` is filled)
  bool richest = false;               ///< the tier is the full physics already
};

/// Climbs from `near` to the full physics of its case.
[[nodiscard]] ModelError model_error(const CoarseSolution& near,
                                     const coupling::SolveControl& control);

/// What each effect that is included does: the coarse solution with it against that without it.
[[nodiscard]] std::vector<EffectChange> effects_of_included(const CoarseSolution& near,
                                                            const coupling::SolveControl& control);

}  // namespace shellback::fidelity
