#pragma once
/// The states of a running-in under way: how they are noted, kept and taken up again.
#include "bearing/over_time/kept_run.hpp"
#include "bearing/over_time/worn_bearing.hpp"

namespace shellback::bearing {

/// What a step errs, and what it makes of the errors before: of dV/dt = f(V) they change as f does.
struct StepError {
  double depth = 0.0;    ///< [m]
  double volume = 0.0;   ///< [m3]
  double carried = 1.0;  ///< rate of the volume at its end over that at its beginning [-]
};

/// Adds the state that the bearing is in at `t`, `step` [s] after the last one, with its wear [m];
/// `error`: of that step.
void note_state(const WornBearing& b, double t, double step, const StepError& error,
                const Field& wear, RunningInRun& run);

/// What has been found, for a tape: all but the last solution, which its bearing tells anew.
void members(Tape& tape, WornBearing& b, RunningInRun& run);

/// Keeps bearing, states and what `more` writes, if it is time or in any case.
template <class More>
void keep(KeptRun* kept, bool in_any_case, WornBearing& b, RunningInRun& run, More& more) {
  if (kept == nullptr || !(in_any_case || kept->due())) return;
  kept->keep([&](Tape& tape) {
    b.keep(tape);
    members(tape, b, run);
    tape(more);
  });
}

/// What `more` was when it was kept, after bearing and states; nothing was: as it is.
template <class More>
void take_up(KeptRun* kept, More& more) {
  static_cast<void>(take_up_noted(kept, [&](Tape& tape) { tape(more); }));
}

}  // namespace shellback::bearing
