#pragma once
/// Tier `auto` over a load cycle: the cheapest physics, grid and steps in time whose estimated
/// error on the mean friction torque and the smallest film of the cycle meets the tolerance of the
/// case.
///
/// 0. The estimate by mobility (estimate_cycle.hpp), if its bars meet the tolerance and the case
///    gives no grid.
/// 1. On a coarse grid the cycle is solved in the richest tier that the case has data for, and in
///    the cheaper ones from tier isothermal on. The first whose difference from the richest
///    in torque and film, times 1.75 (the bar of the physics left out, left_out.hpp), is no more
///    than half the tolerance is taken. Where the richest is not found no bar can be given: the
///    tolerance is then not met, and the result says why.
/// 2. In that tier the cycle is solved with the bars of its grid and steps (cycle_bars.hpp). Where
///    they exceed the tolerance the grid is refined to what tolerance.hpp (1) expects to do, and
///    the steps so that their bar, of order 1/3 in the error of one of them, is a quarter of it; up
///    to 400 x 50 cells and three times. Grid and steps given in the case are kept.
/// What a case has no data for (walls) is in no bar; the result says so.
#include "bearing/over_time/cycle.hpp"

namespace shellback::fidelity {

/// Solves the cycle of the case as tier `auto`, whatever `model.tier` says. Does not throw for lack
/// of convergence.
[[nodiscard]] bearing::CycleResult solve_auto_cycle(const bearing::Case& c,
                                                    const bearing::SolveControl& control = {});

/// The cycle in the tier that its case names: `estimate` (estimate_cycle.hpp), `auto` or one with
/// bars (cycle_bars.hpp).
[[nodiscard]] bearing::CycleResult solve_cycle_case(const bearing::Case& c,
                                                    const bearing::SolveControl& control = {});

}  // namespace shellback::fidelity
