#pragma once
/// Tier `auto` on its coarsest grid: nodes across the film, effects, and what is not known of the
/// heat. A probe is a converged solution in the tier that its case names. `cost` is added to.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fidelity/grid_sequence.hpp"
#include "fidelity/tolerance.hpp"

namespace shellback::fidelity {

/// Part of the tolerance that an effect left out or a node less may change; below it nothing
/// decides [-].
inline constexpr double kNegligible = 0.1;

struct NodeChoice {
  int nodes = 0;  ///< across the film; 0: nothing chosen
  /// Change of each quantity by two more nodes than these, on the probe's grid.
  std::vector<bearing::Quantity> left;
  bool known = true;  ///< false: two more nodes gave no solution on the probe's grid
};

/// Adds nodes across the film, two at a time, until two more change friction torque and smallest
/// film by less than a tenth of the tolerance; `probe` is left with the nodes chosen.
/// Temperatures across the film converge spectrally (textbook), so that the last change is of the
/// size of what is left. `given`: the nodes are those of the case, and only judged. Does nothing
/// where the film's temperature is not resolved by such nodes.
[[nodiscard]] NodeChoice choose_nodes(bearing::Solution& probe, double tolerance, bool given,
                                      const bearing::SolveControl& control,
                                      bearing::EquilibriumCost& cost);

/// Which effects go on, and what leaving the others out may cost.
struct EffectChoice {
  std::vector<bearing::Effect> effects;  ///< with their changes on the probe
  bearing::Switches switches;            ///< those of the case, with what is left out set false
  Bars left_out{0.0, 0.0};               ///< of the effects left out
  /// The same of every quantity of the film, as parts of its natural size; empty: none is left out.
  std::vector<std::pair<std::string, double>> left{};
  /// Bar of a quantity, over its natural size [-]. Of temperatures and heats, which are held, those
  /// of torque and side flow together.
  [[nodiscard]] double left_of(const std::string& name) const;
};

/// What each effect of the probe changes, one taken out of the film after the other
/// (held_film.hpp); those that change less than a tenth of the tolerance, and that the case does
/// not ask for, are left out.
[[nodiscard]] EffectChoice choose_effects(const bearing::Solution& probe, double tolerance,
                                          const std::atomic<bool>* stop,
                                          bearing::EquilibriumCost& cost);

/// Changes of a lumped film whose temperature rise is half of it higher and lower; infinite where
/// that film does not stand: what heat into unknown walls or recirculation may do.
[[nodiscard]] Bars unknown_heat(const bearing::Solution& lumped, const std::atomic<bool>* stop,
                                bearing::EquilibriumCost& cost);

/// Adds factorisations and Newton iterations.
void add(const bearing::EquilibriumCost& from, bearing::EquilibriumCost& to);

}  // namespace shellback::fidelity
