#pragma once
/// A grid of the sequence on which a tier is solved.

namespace shellback::bearing {

/// How a grid is begun.
struct Level {
  bool warm = false;    ///< from the state that is there; else from cold
  bool coarse = false;  ///< its solution is not told: known as well as a finer grid needs
  bool start = false;   ///< of a finer grid: nothing is asked beyond where a branch turns back
};

/// Of the work that is left: most that a coarse grid may take, and a film from cold before a branch
/// is followed to it. The verdict is that of the last grid and of the branch, which are not to go
/// without a try for want of a start (docs/decisions/022) [-].
inline constexpr double kForStarts = 0.5;

}  // namespace shellback::bearing
