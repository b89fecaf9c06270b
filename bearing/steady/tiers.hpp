#pragma once
/// One tier on one grid: how a steady state comes about.
///
///   isothermal   newton -> through time (pseudo_time.hpp) -> along the load (follow.hpp)
///   lumped       the root of the heat balance over films of one temperature (lumped.hpp)
///   thd, tehd    the outer iteration over heat -> along load or speed -> through time with the
///                real heat capacities (heat_march.hpp), this on the asked grid alone
/// each arrow only where what stands before it does not arrive. What is said to have no steady
/// state has a turning point, a bound of the equations, or a trajectory that leaves every bound;
/// solve.cpp compares where that is on two grids.
#include "bearing/control.hpp"
#include "bearing/film/solution.hpp"
#include "bearing/steady/level.hpp"

namespace shellback::bearing {

/// Solves on the model's grid; `s.verdict` says how it ended, `s.limits` where a branch did.
void solve_on_grid(Solution& s, Tier tier, Level level, const SolveControl& control);

}  // namespace shellback::bearing
