#include "bearing/over_time/running_in_states.hpp"

#include "bearing/over_time/solution_members.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {

void note_state(const WornBearing& b, double t, double step, const StepError& error,
                const Field& wear, RunningInRun& run) {
  const FilmGrid& g = b.model().domain.grid;
  RunningInState state;
  state.t = t;
  state.step = step;
  if (!run.states.empty()) {
    state.depth_error = error.carried * run.states.back().depth_error + error.depth;
    state.volume_error = error.carried * run.states.back().volume_error + error.volume;
  }
  state.depth = largest(wear);
  state.volume = area_integral(g, wear);
  b.tell(state, run);
  run.states.push_back(state);
  run.grid = full_grid(g);
  run.wear = mirror_to_full(g, wear);
}

void members(Tape& tape, WornBearing& b, RunningInRun& run) {
  tape(run.states, run.rejected_steps);
  if (!tape.reads() || run.states.empty()) return;
  RunningInState told;
  b.tell(told, run);
  run.grid = full_grid(b.model().domain.grid);
  run.wear = mirror_to_full(b.model().domain.grid, b.wear());
}

}  // namespace shellback::bearing
