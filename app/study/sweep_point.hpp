#pragma once
/// One point of a sweep, and how the points are solved.
#include <atomic>
#include <functional>

#include "bearing/steady/solve.hpp"

namespace shellback::study {

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
  int tries = 0;           ///< solves that were begun for it
  double wall_s = 0.0;     ///< all tries together
  bearing::Result result;  ///< without fields and history; quantities only if converged

  [[nodiscard]] bool tried() const { return start != Start::none; }
  [[nodiscard]] bool good() const { return tried() && result.verdict.good(); }
};

struct SweepProgress {
  int done = 0;  ///< points with a result
  int failed = 0;
  int total = 0;
};

/// Point k of Sweep::points. Called from several threads at once.
using SolveAlone =
    std::function<bearing::Result(int k, const bearing::Case&, const bearing::SolveControl&)>;
using SumUp = std::function<bearing::Result(const bearing::Solution&, bearing::Tier,
                                            const bearing::SolveControl&)>;

struct SweepOptions {
  int threads = 1;
  std::function<void(const SweepProgress&)>
      progress{};                           ///< may be empty; never called twice at once
  const std::atomic<bool>* stop = nullptr;  ///< set from outside: end soon
  /// Solves a point whose tier (estimate, auto) has no film to go on from; empty: such a tier is
  /// bad input.
  SolveAlone solve_alone{};
  SumUp sum_up{};  ///< a solution's result; empty: bearing::summarize
};

}  // namespace shellback::study
