#pragma once
/// The effects that a solve may have or lack, and the error bar of those left out.
///
/// The full physics of the case is solved on a coarse grid, effect by effect, each from the
/// solution before; the difference from the tier's own solution on the same coarse grid stands for
/// that on the fine one (docs/decisions/011). Stronger than the one residual evaluation of methods
/// 7.3, since the coarse system is solved to the end, and no dearer than a few of its Newton steps.
#include <string>
#include <vector>

#include "bearing/steady/solve.hpp"

namespace shellback::fidelity {

/// The change by what is left out times this is the bar [-]; table in docs/decisions/011.
inline constexpr double kModelSafety = 1.75;

/// What an effect needs of a case, and how it is switched.
struct EffectRule {
  struct Part {
    bool bearing::Physics::*has;
    std::optional<bool> bearing::Switches::*wish;  ///< null: a matter of the tier
    bool (*data)(const bearing::Case&);            ///< the case has what it needs
  };
  bearing::EffectKind effect;
  std::vector<Part> parts;
};

/// In the order in which they are added. Heating by one temperature is none of them, but the step
/// from tier isothermal to lumped.
[[nodiscard]] const std::vector<EffectRule>& effect_rules();

/// The same physics without the effect.
[[nodiscard]] bearing::Physics without(bearing::EffectKind effect, bearing::Physics physics);

/// Switches an effect off where `given` leaves it open. False: it cannot be left out.
[[nodiscard]] bool switch_off(bearing::EffectKind effect, const bearing::Switches& given,
                              bearing::Switches& switches);

/// True if the case has what the heat in shell and shaft needs: both, and a way out for the heat.
[[nodiscard]] bool knows_its_walls(const bearing::Case& c);

/// One more effect than the step before.
struct PhysicsStep {
  bearing::EffectKind effect;
  bearing::Case input;  ///< the case with tier and switches set for it
};

/// Effects that the tier (with the case's own switches) leaves out and the case has data for, each
/// step with all before it. The last is the fullest physics; empty: the tier is that already.
[[nodiscard]] std::vector<PhysicsStep> richer_physics(const bearing::Case& c, bearing::Tier tier);

/// Effects that nothing can be said about, since the case lacks data of shell or shaft.
[[nodiscard]] std::vector<bearing::EffectKind> unknown_effects(const bearing::Case& c);

/// What one effect changes on the coarse grid, relative [-]; NaN: not known.
struct EffectChange {
  bearing::EffectKind effect;
  double friction = 0.0;
  double h_min = 0.0;
};

struct ModelError {
  /// Change of each quantity from the tier to the full physics, on the coarse grid.
  std::vector<bearing::Quantity> change;
  /// Root of the sum of squares of what the effects change one by one: more than the whole where
  /// they undo one another.
  std::vector<bearing::Quantity> one_by_one;
  std::vector<EffectChange> effects;         ///< of the effects left out
  std::vector<bearing::EffectKind> unknown;  ///< effects for which the case has no data
  std::vector<bearing::EffectKind> failed;   ///< effects whose coarse solve gave nothing
  bool complete = false;  ///< the full physics was reached (and `change` is filled)
  bool richest = false;   ///< the tier is the full physics already
};

/// From the coarse solution, in the tier that its case names, to the full physics of the case. All
/// its searches together cost no more than one on the coarse grid may (`bearing::price_of_search`).
[[nodiscard]] ModelError model_error(const bearing::Solution& coarse,
                                     const bearing::SolveControl& control);

}  // namespace shellback::fidelity
