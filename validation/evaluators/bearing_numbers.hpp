#pragma once
/// The dimensionless numbers in which tables of journal bearings are written.
#include <map>
#include <string>

#include "bearing/steady/solve.hpp"

namespace shellback::validation {

/// Adds to `value`, for a film of one viscosity eta (at the film's temperature, ambient pressure):
///   sommerfeld         S = (R/c)^2 eta N L D/W, N in rev/s [-]
///   load_number        So = W psi^2/(L D eta omega), psi = c/R [-]; S = 1/(2 pi So)
///   friction_number    f R/c = M/(W c) [-]
///   side_flow_number   Q_s/(R c N L) [-]
///   side_flow_per_R3   Q_s/(R^3 psi omega) [-]
///   inlet_flow_number  Q/(R c N L) through the supply line at which the film begins [-]
///   side_flow_share    Q_s/Q [-]
///   mean_over_peak     W/(L D p_max) [-]
///   K_xx ... B_yy      stiffness c K/W and damping c |omega| B/W in load axes [-]
///   whirl_speed_number, whirl_frequency_ratio   omega sqrt(c m/W) at the threshold, nu/omega [-]
/// Flows through a supply line only with one; K, B and whirl only if model.coefficients is set.
/// Definitions: validation/data, headers.
void add_bearing_numbers(const bearing::Solution& solution, std::map<std::string, double>& value);

}  // namespace shellback::validation
