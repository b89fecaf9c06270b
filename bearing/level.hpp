#pragma once
/// A grid of the sequence on which a tier is solved.

namespace shellback::bearing {

/// How a grid is begun.
struct Level {
  bool warm = false;    ///< from the state that is there; else from cold
  bool coarse = false;  ///< its solution is not told: known as well as a finer grid needs
  bool start = false;   ///< of a finer grid: nothing is asked beyond where a branch turns back
};

}  // namespace shellback::bearing
