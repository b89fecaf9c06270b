#pragma once
/// A load cycle as HDF5; the layout of app/write_hdf5.hpp, with groups of its own:
///
///   /              format, title, tier, status, converged, reason, place, cure; period,
///                  crank_speed, cycles, closure, steps, rejected_steps
///   /quantities    name, name_unit; of an extreme name_at with its unit; name_error,
///                  name_error_grid, name_error_time if known
///   /audit, /cost, /limiters, /notes, /case, /provenance as there
///   /series        t, angle (of a cycle with a crank) and all that is followed over it
///   /grid          phi, z and their widths
///   /fields        p_max, p_asperity_max, h_min, friction_power over phi z
///   /frames        t, angle; p, theta, h over t phi z
#include <string>

#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

/// The bytes of the file. SI, kelvin, radians; the crank angle in degrees.
[[nodiscard]] std::string cycle_hdf5(const bearing::Case& c, const bearing::CycleResult& cycle);

}  // namespace shellback::app
