#pragma once
/// Tier `auto`: the cheapest physics and the coarsest grid whose estimated error on friction torque
/// and smallest film meets the tolerance of the case.
///
/// 1. The tier `estimate`: if its bars meet the tolerance, it is the answer.
/// 2. A probe on the coarsest grid: all physics that the case has data for and the user has not
///    switched off. On it the nodes across the film are chosen (auto_nodes.hpp), and each effect is
///    taken out of the film in turn, temperatures held (frozen_film.hpp): its change. Effects whose
///    change is a small part of the tolerance are left out from there on, and twice their changes
///    are the bar of the model.
/// 3. Full solutions on finer and finer grids, each started from the one before, and the film alone
///    on more cells around, until the bar of the grid (grid_limit.hpp) and that of the model are
///    within the tolerance for both quantities; round holes as rectangles (rectangular_holes.hpp).
///    Tolerances below 0.5 % go on to 800 x 100 cells itself, unless what is left does not depend
///    on the grid. Where no two of these grids give a solution, 400 x
///    50 cells (below 0.5 % 800 x 100) are solved as they are, with the usual bars
///    (grid_error.hpp).
/// Quantities are estimates of what 800 x 100 cells give; their bars also hold what those lack to
/// the limit of fine grids. If the user has given a grid, they are that grid's, and the bars hold
/// the distance to the limit. Fields and audit are those of the finest full solution. What the
/// case gives (switches, grid, nodes) is not touched. Missing data of shell or shaft end the ladder
/// at tier lumped: the heat that the solids would take is then uncertain, by the part kUnknownHeat
/// of the temperature rise.
#include "coupling/result.hpp"
#include "coupling/solve.hpp"

namespace shellback::fidelity {

/// Solves the case as tier `auto`, whatever `model.tier` says. Does not throw for lack of
/// convergence.
[[nodiscard]] coupling::Result solve_auto(const coupling::Case& c,
                                          const coupling::SolveControl& control = {});

}  // namespace shellback::fidelity
