#pragma once
/// The same load cycle in several tiers, and what caused the difference in mean friction.
///
/// The split goes from isothermal cycles at the equivalent temperature to the full ones as in
/// compare.hpp, each step a periodic state of its own:
///   1 viscosity level      one temperature, but the mean of the full cycle's oil
///   2 viscosity variation  film temperatures solved, walls held where the full cycle has them
///   3 clearance            their thermal deformation as well
///   4 elasticity           elastic deformation as well: the full cycle (absent where the case has
///                          the isothermal film elastic, too)
#include <functional>

#include "bearing/over_time/cycle.hpp"

namespace shellback::bearing {

struct CycleComparison {
  Comparison sums;  ///< quantities of each tier, split, calibrated temperature
  std::vector<CycleResult> cycles;
};

/// How a cycle is solved in the tier of its case: solve_cycle, or with bars.
using SolveCycle = std::function<CycleResult(const Case&)>;

[[nodiscard]] CycleComparison compare_cycles(const Case& c, const std::vector<Tier>& tiers,
                                             const SolveControl& control, const SolveCycle& solve);

}  // namespace shellback::bearing
