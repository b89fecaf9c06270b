#pragma once
/// One result as an HDF5 file (format 1).
///
///   /             attributes: format, format_version, title, tier, status, converged (1 or 0),
///                 reason, place, cure
///   /quantities   attributes: each scalar under its name (SI, as the solver gives it) and its
///                 unit under <name>_unit
///   /audit        attributes mass, energy, load, moment [-]; NaN: does not apply
///   /cost         attributes wall_s, setup_s, factorizations, newton_iterations,
///                 outer_iterations
///   /grid         attributes radius [m], width [m]; datasets phi, dphi, phi_face [rad],
///                 z, dz, z_face [m], s [-] (y/h of the film temperatures), r [m] (of T_solid)
///   /fields       datasets [nt][nz]: p, p_asperity, theta, h, supplied, T_mean,
///                 T_shell_surface, T_shell_back, tau_journal, tau_shell, elastic, thermal
///                 deformation; T [nt][nz][ns]; T_shaft [nz]; T_solid [nt][nr]
///   /history      datasets stage (text), residual, friction_torque, h_min: one per iteration
///   /effects      datasets name, included, indicator, meaning
///   /limiters     datasets what, count
///   /notes        datasets warnings, assumptions (text)
///   /case         dataset verbatim (the case file's text, one string), attribute path
///   /provenance   attributes version, git, input, input_fnv1a64, library_<name>
///
/// Every dataset has `units` and `long_name`; a field also names the coordinates of its axes in
/// `axes`. Fields that the tier does not have are absent. If the solve did not converge,
/// `converged` is 0 and every field carries the attribute `state` saying so.
#include <string>

#include "bearing/result.hpp"

namespace shellback::app {

/// The bytes of the file. Throws FileError if the library cannot make them.
[[nodiscard]] std::string result_hdf5(const bearing::Case& c, const bearing::Result& result);

}  // namespace shellback::app
