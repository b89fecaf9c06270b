#pragma once
/// A load cycle as JSON; contract and units as in app/write_json.hpp.
#include <string>

#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

/// status, converged, [reason, place, cure], tier, title, `quantities` {name: {value, unit, [at
/// {value, unit}: of an extreme], [error, error_grid, error_time]}}, audit {mass, impulse, load},
/// `cycle`, `tolerance` {asked, met, bars} of a cycle that was found, limiters, warnings,
/// assumptions, grid, cost, provenance, changes, case.
///
/// `cycle`: `angle` (crank angle) or `time`, and over it every series as {unit, values}; closure,
/// cycles, steps, rejected_steps, period. A cycle that did not converge holds the instants that
/// were found.
[[nodiscard]] std::string cycle_json(const bearing::Case& c, const bearing::CycleResult& cycle);

}  // namespace shellback::app
