#pragma once
/// A case over a grid of values of its keys, on several threads.
///
/// Along the first axis each point is solved from the one before it (continuation); the values of
/// the other axes give independent curves. Where there are more threads than curves, a curve is cut
/// into pieces, each with a cold start of its own; so the number of threads moves a result within
/// the tolerance of the solvers, not beyond it.
#include <functional>
#include <vector>

#include "app/study/axis.hpp"
#include "app/study/sweep_point.hpp"

namespace shellback::study {

/// A place on the grid of axes.
struct Position {
  double along = 0.0;       ///< index on the first axis; a fraction lies between two values
  std::vector<int> across;  ///< indices on the others
};

/// The judged case at a position. Throws InputError. Called from several threads at once.
using CaseAt = std::function<bearing::Case(const Position&)>;

struct Sweep {
  std::vector<Axis> axes;
  std::vector<SweepPoint> points;  ///< the first axis slowest, the last fastest
  bool interrupted = false;
  int threads = 1;
  double wall_s = 0.0;

  /// Curves: combinations of values of all axes but the first.
  [[nodiscard]] int curves() const;
  /// Points of one curve stand this far apart: point k of curve c is points[k * curves() + c].
  [[nodiscard]] const SweepPoint& at(int along, int curve) const;
  [[nodiscard]] int count_good() const;
  /// Tried to the end, without a solution.
  [[nodiscard]] int count_failed() const;
};

/// Indices on all axes but the first of one curve.
[[nodiscard]] std::vector<int> across(const std::vector<Axis>& axes, int curve);

/// Solves every point in the tier of its case. First reads and judges all cases: bad input is
/// thrown (InputError) before any work. A point that cannot be solved carries its verdict; the
/// others are solved all the same. `axes` must not be empty, nor any of them.
[[nodiscard]] Sweep run_sweep(std::vector<Axis> axes, const CaseAt& case_at,
                              const SweepOptions& options = {});

/// Pieces into which each of `curves` curves of `points` points is cut for `threads` threads: as
/// few as keep all threads busy, none shorter than six points (a cold start costs as much as two
/// or three warm ones).
[[nodiscard]] int pieces_per_curve(int curves, int points, int threads);

}  // namespace shellback::study
