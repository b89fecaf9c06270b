#pragma once
/// The heat of a bearing in lumps: friction power leaves with the oil, through the shell and
/// through the shaft.
///
///   P(T) = rho cp Q (T - T_supply) + sum of G (T - T_outside)            [W]          (1)
///
/// T is the mean film temperature; oil leaves at T. G of the shell: half the film (c/2k), the
/// layers and the housing as cylinders, and the convection outside, in series; G of the shaft:
/// half the film and two fins of the overhang's length, in series. Textbook; everything that
/// differs along or around the bearing is left out.
#include <vector>

#include "coupling/case.hpp"

namespace shellback::fidelity {

/// One way for heat to leave.
struct HeatPath {
  double conductance = 0.0;  ///< G [W/K]
  double outside = 0.0;      ///< [K]
};

/// Ways through shell and shaft, those of which the case has data. `k` of the oil [W/(m K)].
[[nodiscard]] std::vector<HeatPath> solid_heat_paths(const coupling::Case& c, double k);

/// Flow that supply pressure drives through the film [m3/s]: each patch feeds the edges through
/// the film between (ours, a magnitude): p h^3/(12 eta) times 2 (w + s)/s, w the patch's extent
/// around, s its distance from the edge, h^3 the mean over the patch.
/// `centres` angle of the line of centres [rad].
[[nodiscard]] double pressure_fed_flow(const coupling::Case& c, double eps, double centres,
                                       double eta);

}  // namespace shellback::fidelity
