#pragma once
/// Step of tier `auto`: how many nodes across the film the tolerance needs.
#include <vector>

#include "coupling/solve.hpp"

namespace shellback::fidelity {

/// Most nodes that are chosen; a case may give more.
inline constexpr int kMostAutoNodes = 9;

struct NodeChoice {
  int nodes = 0;  ///< across the film; 0: nothing chosen
  /// Change of each quantity by two more nodes than these, on the probe's grid.
  std::vector<coupling::Quantity> left;
  bool known = true;  ///< false: two more nodes gave no solution on the probe's grid
  coupling::EquilibriumCost cost;
};

/// Adds nodes across the film, two at a time, until two more change friction torque and smallest
/// film by less than a tenth of the tolerance; `probe`, converged, is left with the nodes chosen.
/// Temperatures across the film converge spectrally (textbook), so that the last change is of the
/// size of what is left; finer grids can make it a third more. `given`: the nodes are those of the
/// case, and only judged. Does nothing where the film's temperature is not resolved by such nodes.
[[nodiscard]] NodeChoice choose_nodes(coupling::Solution& probe, coupling::Tier tier,
                                      double tolerance, bool given,
                                      const coupling::SolveControl& control);

}  // namespace shellback::fidelity
