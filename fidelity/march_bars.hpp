#pragma once
/// Bars of a warm-up or a course, at each of its instants (bars_over_time.hpp): of up to two
/// coarser grids, to which comes for the smallest film of a load that stands still what
/// edge_error.hpp tells of the end, as a part of itself; and of the steps, which are of second
/// order under a steady load (heat_march.hpp) and of first over cycles (march_over_cycles.hpp), to
/// which comes what the steps within a cycle leave open, as those of `run` on the nearest coarser
/// grid. Within an instant they share a least length (share_bars_of_states()), and no temperature
/// and no heat is known better than the torque that makes it. Where no film is left, the time of
/// that has bars of its own: from marches on the same grids in steps of their own, and in some
/// twice as long; not known where the film of one of them lasts. Three threads at most.
#include <cmath>

#include "bearing/over_time/course.hpp"
#include "fidelity/bars_over_time.hpp"

namespace shellback::fidelity {

/// Of the time at which no film is left, half-widths [s]; not a number: not known.
struct EndBars {
  double grid = NAN;
  double time = NAN;
};

struct MarchBars : BarsOverTime<bearing::Instant> {
  EndBars end;  ///< of marches that left their bounds, under a steady load
};

/// Bars of `run` as it was made by run_course(); none, if it has no instant.
[[nodiscard]] MarchBars march_bars(const std::vector<bearing::Stretch>& stretches,
                                   const bearing::WarmUpOptions& options,
                                   const bearing::CourseRun& run,
                                   const bearing::SolveControl& control = {});

/// Bars of `run` as it was made by warm_up(); none, if it has no instant.
[[nodiscard]] MarchBars march_bars(const bearing::Case& c, const bearing::WarmUpOptions& options,
                                   const bearing::WarmUp& run,
                                   const bearing::SolveControl& control = {});

}  // namespace shellback::fidelity
