#pragma once
/// A case over a grid of values of its keys, on several threads.
///
/// Along the first axis each point is solved from the one before it (continuation); the values of
/// the other axes give independent curves. Where there are more threads than curves, a curve is cut
/// into pieces, each with a cold start of its own; so the number of threads moves a result within
/// the tolerance of the solvers, not beyond it.
#include <atomic>
#include <functional>
#include <vector>

#include "coupling/solve.hpp"
#include "study/axis.hpp"

namespace shellback::study {

/// A place on the grid of axes.
struct Position {
  double along = 0.0;       ///< index on the first axis; a fraction lies between two values
  std::vector<int> across;  ///< indices on the others
};

/// The judged case at a position. Throws InputError. Called from several threads at once.
using CaseAt = std::function<coupling::Case(const Position&)>;

/// From where the last try of a point began.
enum class Start {
  none,       ///< not tried: the sweep was interrupted before
  cold,       ///< from nothing
  neighbour,  ///< from the point beside it on its curve
  between,    ///< from the neighbour by way of points between the two
};
[[nodiscard]] const char* to_string(Start start);

/// One point of the grid.
struct SweepPoint {
  Start start = Start::none;
  int tries = 0;            ///< solves that were begun for it
  double wall_s = 0.0;      ///< all tries together
  coupling::Result result;  ///< without fields and history; quantities only if converged

  [[nodiscard]] bool tried() const { return start != Start::none; }
  [[nodiscard]] bool good() const { return tried() && result.verdict.good(); }
};

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

struct SweepProgress {
  int done = 0;  ///< points with a result
  int failed = 0;
  int total = 0;
};

/// Called from several threads at once.
using SolveAlone =
    std::function<coupling::Result(const coupling::Case&, const coupling::SolveControl&)>;
using SumUp = std::function<coupling::Result(const coupling::Solution&, coupling::Tier,
                                             const coupling::SolveControl&)>;

struct SweepOptions {
  int threads = 1;
  std::function<void(const SweepProgress&)>
      progress{};                           ///< may be empty; never called twice at once
  const std::atomic<bool>* stop = nullptr;  ///< set from outside: end soon
  /// Solves a point whose tier (estimate, auto) has no film to go on from; empty: such a tier is
  /// bad input.
  SolveAlone solve_alone{};
  SumUp sum_up{};  ///< a solution's result; empty: coupling::summarize
};

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
