#pragma once
/// One tier on one grid: isothermal film, heat balance of the whole bearing, or film and heat
/// resolved.
#include "coupling/first_film.hpp"
#include "coupling/heat_path.hpp"

namespace shellback::coupling {

/// How a grid is begun.
struct Level {
  bool warm = false;               ///< from the state that is there; else from cold
  const NearPath* near = nullptr;  ///< path of a coarser grid
  double tolerance = 0.0;          ///< of the thermal loop; 0: its own
};

/// Solves on the model's grid, from the state that is there or from cold.
void solve_level(Solution& s, Tier tier, const Level& level, const SolveControl& control);

}  // namespace shellback::coupling
