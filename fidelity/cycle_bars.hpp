#pragma once
/// A load cycle with the bars of its grid and of its steps in time.
#include <optional>

#include "bearing/over_time/cycle.hpp"

namespace shellback::fidelity {

/// Solves the cycle of the case and, if it converges, gives its quantities their bars: of the grid
/// from up to two coarser grids and, where fewer have the cycle, a finer one, each with steps of
/// the same error (grid_error.hpp, shared as those of steady states; the smallest film at an edge:
/// edge_error.hpp, too; summits that hardly touch: light_contact.hpp), of the steps from the
/// nearest coarser grid, or the own one, once more with steps that may err four times as much (or,
/// given ones, are half as long as the longest taken). The error of a step falls with the third
/// power of its length, and what steps change falls with the first of it where fronts of oil move
/// by cells (docs/decisions/058):
///   bar = 1.5 |f(4 tol) - f(tol)| / (4^(1/3) - 1),   given: 1.5 |f(dt) - f(dt/2)| 2           (1)
/// taken as a part of the value and shared as those of the grid; to extremes comes how far a
/// parabola through the instants around goes beyond what they were seen to be, to the smallest film
/// what a chosen step may err. 1.5 is the safety of the grid's bars. With walls that the bodies
/// would still change, as every search leaves them, temperatures and heat flows get besides
///   |change of the walls|,   |heat that the bodies would take then less what they took|        (2)
/// and all else, as a part of itself, by how much the mean change of the walls would change the
/// viscosity. Power is no better known than the torque in it.
/// Source: Richardson, textbook. Bars are not-a-number where no
/// coarser grid serves. Throws InputError as solve_cycle does.
[[nodiscard]] bearing::CycleResult solve_cycle_with_bars(const bearing::Case& c,
                                                         const bearing::SolveControl& control = {});

/// The cycle of the case, on its own grid, with the bars of its steps alone, `error_time`; nothing
/// where it, or that of other steps, is not found, or the grid cannot carry the supplies.
[[nodiscard]] std::optional<bearing::CycleResult> cycle_with_bars_of_steps(
    const bearing::Case& c, const bearing::SolveControl& control);

/// One of the bars of a quantity.
using BarOf = double& (*)(bearing::CycleQuantity&);

/// Where summits hardly touch over the cycle (light_contact.hpp): contact is as sure as the
/// smallest film, its friction, which is part of the whole, as the pressure.
void widen_bars_of_light_contact(const bearing::Case& c, bearing::CycleResult& r, BarOf bar);

/// That of the list of its quantities (quantities.hpp).
void bound_parts_of_friction(bearing::CycleResult& r);

/// How far a parabola through the extreme of `value` at time `at` [s] and the instants before and
/// behind it goes beyond it: what the steps have not looked at [unit of the value]. Zero beside a
/// jump and at either end of the cycle.
[[nodiscard]] double beyond_instants(const std::vector<bearing::CycleInstant>& all,
                                     double bearing::CycleInstant::*value, double at);

}  // namespace shellback::fidelity
