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

/// No bar of time is left shorter than what the steps' own estimates sum to, times 1.5: what steps
/// twice as long change passes through zero, and one step has no other to be judged by. What is no
/// wear itself has changed with the volume; so near to a change of states that the errors of the
/// volume may hide it, by all of that. `bars`: one for each state.
void widen_by_errors_of_steps(const bearing::RunningInRun& run,
                              std::vector<bearing::RunningInState>& bars);

}  // namespace shellback::fidelity
