#pragma once
/// Bars of a running-in, at each of its states (bars_over_time.hpp): of up to two coarser grids,
/// to which comes for the smallest film what edge_error.hpp tells of the end, as a part of itself;
/// and of the steps, which are of second order (running_in.hpp). A worn-in shape has no steps.
/// Three threads at most.
#include "bearing/over_time/running_in.hpp"
#include "fidelity/bars_over_time.hpp"

namespace shellback::fidelity {

using RunningInBars = BarsOverTime<bearing::RunningInState>;

/// Bars of `run` as it was made by run_in(); none, if it has one state or none.
[[nodiscard]] RunningInBars running_in_bars(const bearing::Case& c,
                                            const bearing::RunningInRun& run,
                                            const bearing::SolveControl& control = {});

}  // namespace shellback::fidelity
