#pragma once
/// The heat of a bearing in lumps: friction power leaves with the oil, through the shell and
/// through the shaft.
///
///   P(T) = rho cp Q (T - T_supply) + sum of G (T - T_outside)            [W]          (1)
///
/// T is the mean film temperature; oil leaves at T. Textbook; everything that differs along or
/// around the bearing is left out.
#include <vector>

#include "bearing/case.hpp"

namespace shellback::fidelity {

/// One way for heat to leave.
struct HeatPath {
  double conductance = 0.0;  ///< G [W/K]
  double outside = 0.0;      ///< [K]
};

/// Ways through shell (half the film c/2k, layers and housing as cylinders, convection outside) and
/// shaft (half the film, two fins of the overhang's length), those of which the case has data. `k`
/// of the oil [W/(m K)].
[[nodiscard]] std::vector<HeatPath> solid_heat_paths(const bearing::Case& c, double k);

/// Flow that supply pressure drives through the film [m3/s]: each patch feeds the edges through
/// the film between (ours, a magnitude): p h^3/(12 eta) times (arc + s)/s to either side, s its
/// distance from that edge, h^3 its mean over the patch. `closest`: angle of the smallest gap,
/// `turned`: by how much the journal has turned with its drillings [rad].
[[nodiscard]] double pressure_fed_flow(const bearing::Case& c, double eps, double closest,
                                       double eta, double turned = 0.0);

}  // namespace shellback::fidelity
