#pragma once
/// Results as JSON, for other programs. Binding keys; SI, each value with its unit beside it,
/// angles in degrees, temperatures in kelvin.
///
/// One result:
///   status, converged, [reason, place, cure: only if not converged], tier, title,
///   quantities {name: {value, unit, [error, error_grid, error_time, error_model: bars that are
///   known, the first their sum], [limit: where the grids lead to]}}, audit {mass, energy, load,
///   moment}, effects, limiters, warnings, assumptions, grid, cost, history, provenance.
/// A quantity that the tier does not know is absent. There is no NaN in JSON: an audit entry
/// that does not apply, and a value that is not a number in a failed solve, is null.
#include <string>

#include "app/study/sweep.hpp"
#include "bearing/result.hpp"

namespace shellback::app {

[[nodiscard]] std::string result_json(const bearing::Case& c, const bearing::Result& result);

/// status (that of the first result that failed, else "converged"), title, `results`: an array
/// of objects as above, `measured`, `friction_split` {from, to, unit, steps, rest} (null if not
/// both ends were computed), `T_calibrated` {value, unit} or null, provenance.
[[nodiscard]] std::string comparison_json(const bearing::Case& c,
                                          const bearing::Comparison& comparison);

/// The sweep: `axes` with their values, and `points`, curve after curve, each with its indices
/// `at` on the axes, status, quantities (only if converged), audit and cost.
[[nodiscard]] std::string sweep_json(const bearing::Case& subject, const study::Sweep& sweep);

}  // namespace shellback::app
