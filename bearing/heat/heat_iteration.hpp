#pragma once
/// The outer iteration over heat: node temperatures of the film and thermal deformation.
///
/// One iteration: viscosities from the temperatures -> film, position, elastic displacement in
/// equilibrium -> node flows and dissipation -> a few sweeps of the film energy -> heat into the
/// walls -> the solids' temperatures (Robin-coupled, storage of a time step included) and
/// deformation. Anderson acceleration (KINSOL); temperatures in units of 10 K, deformation in
/// clearances. One residual for the steady state and for a step in time.
#include "bearing/control.hpp"
#include "bearing/film/solution.hpp"
#include "bearing/heat/film_heat.hpp"
#include "core/fixed_point.hpp"

namespace shellback::bearing {

struct ThermalOptions {
  int anderson_depth = 6;
  int max_iterations = 50;
  double tolerance = 3e-4;  ///< largest change per iteration, in the units above [-]
  bool close = true;        ///< bring film and walls to balance at the end
  EquilibriumOptions film;
};

/// Starts from all temperatures at `T`.
[[nodiscard]] HeatState cold_heat(const BearingModel& model, double T);

/// Solves `s.point` from the film and the heat that `s` holds, which hold the last iteration
/// whatever the verdict. `step`: over which film and walls store heat; none: the steady state.
[[nodiscard]] Verdict solve_heat(Solution& s, const ThermalOptions& options,
                                 const SolveControl& control, const HeatStep* step = nullptr);

}  // namespace shellback::bearing
