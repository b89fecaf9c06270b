#pragma once
/// What a load cycle comes to: magnitudes, means, where the load vanishes.
///
/// Rows are those of load_cycle.hpp (its signs and units); between them lie straight lines, in
/// place of a spline as many as `as_lines` lays. Both components go along them: between directions
/// far apart the magnitude falls.
#include <cstddef>
#include <optional>

#include "bearing/case.hpp"

namespace shellback::bearing {

/// A load below the largest by more than this leaves the position of a journal without mass open.
inline constexpr double kVanishingLoad = 1e-6;  ///< six digits: as much as tables have [-]

struct CycleNumbers {
  double length = 0.0;         ///< the period; of a single event its last time [s]
  double largest = 0.0;        ///< magnitude of the load [N]
  double angle = 0.0;          ///< direction of the largest, 0 to 2 pi [rad]
  double at = 0.0;             ///< time of the largest [s]
  double smallest = 0.0;       ///< magnitude of the load [N]
  double mean = 0.0;           ///< over time, of the magnitude [N]
  double net = 0.0;            ///< magnitude of the load's mean over time [N]
  double mean_speed = 0.0;     ///< of the journal against the shell, with its sign [rad/s]
  double mean_sliding = 0.0;   ///< of its magnitude [rad/s]
  double largest_speed = 0.0;  ///< magnitude [rad/s]
};

/// Numbers of the lines; `omega`: speed where the cycle has none [rad/s]. The mean load is
/// the integral of the magnitude, exact on each line. Needs a row or more, as many loads as times.
[[nodiscard]] CycleNumbers cycle_numbers(const LoadCycle& cycle, double omega);

/// The largest load and its direction: what a case with a cycle holds as its operation's load.
[[nodiscard]] LoadGiven largest_load(const LoadCycle& cycle);

/// The row from which on, to the next one, the load falls below kVanishingLoad of the largest;
/// nothing if it never does. Behind the last row comes the first if the cycle repeats itself.
[[nodiscard]] std::optional<std::size_t> vanishing_load(const LoadCycle& cycle);

}  // namespace shellback::bearing
