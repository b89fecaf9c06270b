#pragma once
/// Tier `auto`: the cheapest physics and the coarsest grid whose estimated error on friction torque
/// and smallest film meets the tolerance of the case.
///
/// Candidates, from the cheapest on; the first whose bars meet the tolerance is the answer:
/// 1. The tier `estimate`.
/// 2. Full solutions on finer and finer grids, each started from the one before, and the film alone
///    on more cells around: what 800 x 100 cells would give, and its bar (grid_error.hpp). All
///    physics that the case has data for and the user has not switched off; on the first grid the
///    nodes across the film are chosen and effects that change little left out (auto_probe.hpp).
///    Ends where what is left does not depend on the grid; only tolerances below 0.5 % go on to
///    800 x 100 cells itself.
/// 3. Where no two of these grids give a solution, or the case gives its grid, that grid (400 x 50,
///    below 0.5 % 800 x 100 cells) as it is, with the usual bars (grid_error.hpp).
/// Quantities of 2 are estimates of what 800 x 100 cells give; their bars also hold what those lack
/// to the limit of fine grids. Fields and audit are those of the finest full solution. What the
/// case gives (switches, grid, nodes) is not touched. Without data of shell or shaft the physics
/// ends at tier lumped; the heat that the solids would take is then uncertain.
#include "bearing/result.hpp"
#include "bearing/steady/solve.hpp"

namespace shellback::fidelity {

/// Tolerances below this are of the size of what extrapolation leaves to chance: grids go on to
/// 400 x 100 and 800 x 100 cells [-].
inline constexpr double kFineTolerance = 0.005;

/// Solves the case as tier `auto`, whatever `model.tier` says. Does not throw for lack of
/// convergence.
[[nodiscard]] bearing::Result solve_auto(const bearing::Case& c,
                                         const bearing::SolveControl& control = {});

}  // namespace shellback::fidelity
