#pragma once
/// A sweep as one HDF5 file (format 1).
///
///   /             attributes: format ("shellback sweep"), format_version, title, converged,
///                 failed, points (counts), interrupted (1 or 0), threads, wall_s,
///                 axes (keys, blank-separated, in the order of the dimensions)
///   /axes         per axis a dataset under its key: numbers with `units` as the user wrote them,
///                 or words; attribute spacing
///   /quantities   per quantity a dataset over all axes (SI, angles in deg); NaN: not solved, or
///                 not known in the tier of the point
///   /errors       the error bars of those quantities that have any
///   /audit        mass, energy, load, moment [-]
///   /cost         outer_iterations, newton_iterations, factorizations (of the try that
///                 converged), tries, wall_s (of all tries)
///   /state        status (0 converged, 1 iteration limit, 2 no steady state, 3 invalid number,
///                 4 interrupted, 5 not started), tier, start, reason
///   /case         dataset verbatim (the case file's text), attribute path
///   /provenance   as in the file of one result
///
/// Every dataset has `units` and `long_name`; those over the grid name its axes in `axes`.
#include <string>

#include "app/study/sweep.hpp"

namespace shellback::app {

/// The bytes of the file. Throws FileError if the library cannot make them.
[[nodiscard]] std::string sweep_hdf5(const bearing::Case& subject, const study::Sweep& sweep);

}  // namespace shellback::app
