#pragma once
/// A bearing through a course of operations: speed, load and supply in steps, bodies carried over.
///
/// Each stretch holds the operation of its case for a time. Shell, housing and shaft go from the
/// end of one stretch into the next as they are; the film, which forgets within milliseconds,
/// begins anew. Heat balance and steps in time as in warm_up.hpp; over load cycles the step is at
/// most a sixteenth of the stretch, and what it leaves at the end some tenths of a per cent of
/// friction (decision 059).
#include <cstddef>

#include "bearing/over_time/warm_up.hpp"

namespace shellback::bearing {

/// One operation, held for a time.
struct Stretch {
  Case subject;
  double duration = 0.0;        ///< [s]
  std::vector<double> steps{};  ///< to be taken as they are [s]; empty: chosen
};

struct CourseRun {
  std::vector<Instant> instants;  ///< t from the beginning of the first stretch
  /// Index of the last instant of each stretch that was passed to its end.
  std::vector<std::size_t> ends;
  std::vector<std::vector<Note>> warnings;  ///< of the films at these (MarchEnd::warnings)
  MarchEnd end;       ///< not good: the last instant was the last that had a film
  Solution solution;  ///< at the end of the last stretch that was passed (over cycles its
                      ///< bearing alone)
  bool over_cycles = false;
  /// Largest |in - out - stored| over heat in or out at the ends of the stretches; over cycles of
  /// whole stretches, less what the last step of each is owed, which goes with it [-].
  [[nodiscard]] double imbalance_at_ends() const;
};

/// Passes the stretches one after the other in tier thd or tehd, bodies at `options.T_start` to
/// begin with; `options.end` is not looked at. Ends early where a stretch finds no film; what was
/// passed is kept. Throws InputError for other tiers, no stretch, a duration that is not positive,
/// a single event, or stretches that are not of one bearing (shell, shaft, geometry, grid).
[[nodiscard]] CourseRun run_course(const std::vector<Stretch>& stretches, Tier tier,
                                   const WarmUpOptions& options, const SolveControl& control = {});

}  // namespace shellback::bearing
