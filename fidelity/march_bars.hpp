#pragma once
/// Bars of a warm-up or a course, at each of its instants.
///
/// The same steps are taken on up to two coarser grids; each instant has the bars that nested grids
/// give (grid_error.hpp), its smallest film besides what edge_error.hpp tells of the last one, as a
/// part of itself, where the load stands still. On the finest of these grids two steps each are
/// taken as one: what that changes of an instant leaves open
///   1.5 |f(2 dt) - f(dt)| / (2^n - 1)                                                        (1)
/// as a part of its value, n = 2 under a steady load (heat_march.hpp), 1 over cycles
/// (march_over_cycles.hpp); instants between two such steps have the larger of their bars. 1.5 is
/// the safety of the grid's bars. Source: Richardson, textbook.
#include "bearing/course.hpp"

namespace shellback::fidelity {

/// Half-widths in the units of the values that are followed (kFollowedInstants), one for each
/// instant; not a number: not known. Empty: no coarser grid serves, or it was interrupted.
struct MarchBars {
  std::vector<bearing::Instant> grid, time;
  bool interrupted = false;
};

/// Bars of `run` as it was made by run_course().
[[nodiscard]] MarchBars march_bars(const std::vector<bearing::Stretch>& stretches,
                                   const bearing::WarmUpOptions& options,
                                   const bearing::CourseRun& run,
                                   const bearing::SolveControl& control = {});

/// Bars of `run` as it was made by warm_up(); none, if it has no instant.
[[nodiscard]] MarchBars march_bars(const bearing::Case& c, const bearing::WarmUpOptions& options,
                                   const bearing::WarmUp& run,
                                   const bearing::SolveControl& control = {});

}  // namespace shellback::fidelity
