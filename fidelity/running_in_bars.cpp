#include "fidelity/running_in_bars.hpp"

#include <cmath>

#include "bearing/bearing.hpp"
#include "core/contract.hpp"
#include "fidelity/cycle_bars.hpp"
#include "fidelity/edge_error.hpp"
#include "fidelity/light_contact.hpp"
#include "fidelity/quantities.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

using States = std::vector<RunningInState>;

/// In these steps, or, where there are none, as the case says; nothing where the grid cannot carry
/// the supplies.
States on_grid(Case c, const Grid& grid, const std::vector<double>& steps,
               const SolveControl& control) {
  c.model.grid = grid;
  try {
    const RunningInRun run = run_in(c, c.model.tier, control, {}, steps);
    return steps.empty() && !run.verdict.good() ? States{} : run.states;
  } catch (const InputError&) {
    return {};
  }
}

/// What the edge hides of the smallest film at the end, as a part of it [-].
double hidden_at_edge(const RunningInRun& run) {
  const double least = run.states.back().h_min;
  if (!(least > 0.0)) return 0.0;
  if (run.cycle) {
    const CycleFields& f = run.cycle->fields;
    return edge_error(f.grid, f.h_min, f.in_supply) / least;
  }
  const FilmEquilibrium& film = run.solution.film;
  return edge_error(run.solution.model.domain.grid, film.gap.cell, film.least) / least;
}

/// Whether summits hardly touch at the end, where they have worn: share of the load, over a cycle
/// of the friction.
bool touches_lightly(const RunningInRun& run) {
  if (!run.cycle) return value_in(scalars(run.solution), "asperity_load_share") < kLight;
  return named(*run.cycle, "friction_torque_asperity")->quantity.size() <
         kLight * named(*run.cycle, "friction_torque")->quantity.size();
}

void widen_bars_of_light_contact(const Case& c, const RunningInRun& run, States& bars) {
  if (!c.surfaces.contact || !touches_lightly(run)) return;
  Case worn = c;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    worn.surfaces.shell = worn_surface(c, run.states[k].depth);
    const double open = left_open_by_film(*contact_of(worn), run.states[k].h_min, bars[k].h_min);
    bars[k].p_asperity_max = larger(bars[k].p_asperity_max, open);
  }
}

enum class Of { grid, time };

void share(const RunningInRun& run, Of of, States& bars) {
  const auto size = [&](std::size_t k, const Followed<RunningInState>& q) {
    return std::abs(run.states[k].*q.value);
  };
  // What has worn is the contact's doing: where next to nothing touches, neither of them tells how
  // well a grid knows the film. Steps err in the wear first of all.
  const bool light = touches_lightly(run);
  const auto is_part = [of, light](const Followed<RunningInState>& q) {
    const double RunningInState::*value = q.value;
    const bool worn = value == &RunningInState::depth || value == &RunningInState::volume;
    return of == Of::grid && (worn || (light && value == &RunningInState::p_asperity_max));
  };
  share_bars_of_states(kFollowedStates, size, is_part, bars);
}

/// No bar of time is shorter than what the steps' own estimates sum to: what steps twice as long
/// change passes through zero, and one step has no other to be judged by. What is no wear itself
/// moves with its volume as it did over the last two steps (the last of all may be a sliver).
void widen_by_errors_of_steps(const RunningInRun& run, States& bars) {
  for (std::size_t k = 1; k < bars.size(); ++k) {
    const RunningInState &at = run.states[k], &before = run.states[k > 1 ? k - 2 : 0];
    const double worn = at.volume - before.volume;
    const double moved = worn > 0.0 ? kSafety * at.volume_error / worn : 0.0;
    for (const auto& q : kFollowedStates) {
      const double by =
          at.anew || run.states[k - 1].anew ? 0.0 : moved * std::abs(at.*q.value - before.*q.value);
      bars[k].*q.value = larger(bars[k].*q.value, by);
    }
    bars[k].depth = larger(bars[k].depth, kSafety * at.depth_error);
    bars[k].volume = larger(bars[k].volume, kSafety * at.volume_error);
  }
}

/// By the steps, of its size [-].
double part_left_open(const CycleQuantity& q) {
  const double size = q.quantity.size();
  return size > 0.0 ? q.quantity.error_time / size : 0.0;
}

/// What the steps within a cycle leave open of each value, as a part of it [-]: of the new bearing
/// and of the last shape the larger, on a grid that is solved in any case. Wear goes as the
/// summits' friction does. Not a number: not known.
RunningInState open_of_cycles(const Case& c, const Grid& grid, const RunningInRun& run,
                              const SolveControl& control) {
  Case on = c, worn = c;
  on.model.grid = worn.model.grid = grid;
  worn.bearing.wear = wear_table(run.grid, run.wear);
  worn.surfaces.shell = worn_surface(c, run.states.back().depth);
  RunningInState most;
  for (const Case* shape : {&on, &worn}) {
    const auto cycle = cycle_with_bars_of_steps(*shape, control);
    const auto widen = [&](double RunningInState::*value, const char* name) {
      most.*value = larger(most.*value, cycle ? part_left_open(*named(*cycle, name)) : NAN);
    };
    widen(&RunningInState::depth, "friction_torque_asperity");
    widen(&RunningInState::volume, "friction_torque_asperity");
    widen(&RunningInState::p_asperity_max, "p_asperity_max");
    widen(&RunningInState::torque, "friction_torque");
    widen(&RunningInState::h_min, "h_min");
  }
  return most;
}

void add_open_of_cycles(const RunningInState& part, const RunningInRun& run, States& bars) {
  for (std::size_t k = 0; k < bars.size(); ++k) {
    for (const auto& q : kFollowedStates) {
      bars[k].*q.value += part.*q.value * std::abs(run.states[k].*q.value);
    }
  }
}

}  // namespace

RunningInBars running_in_bars(const Case& c, const RunningInRun& run, const SolveControl& control) {
  RunningInBars bars;
  if (run.states.size() < 2) return bars;
  bars.tried = true;
  std::vector<double> steps;
  for (std::size_t k = 1; k < run.states.size() && c.running_in->duration; ++k) {
    steps.push_back(run.states[k].step);
  }
  const auto coarse =
      coarse_runs<RunningInState>(nearest_coarse_grids(c), !steps.empty(), control,
                                  [&](const Grid& grid, bool join, const SolveControl& within) {
                                    return on_grid(c, grid, join ? joined(steps) : steps, within);
                                  });
  if (!coarse.usual.empty()) {
    bars.grid =
        bars_of_grids(coarse.usual, run.states, c.model.grid, hidden_at_edge(run), kFollowedStates);
    share(run, Of::grid, bars.grid);
    widen_bars_of_light_contact(c, run, bars.grid);
    bars.time = States(run.states.size());  // a worn-in shape has no steps
    if (!steps.empty()) {
      bars.time = unknown<RunningInState>(run.states.size(), kFollowedStates);
      bars.time.front() = {};  // the new bearing
      std::size_t n = 1;
      add_bars_of_steps(coarse.usual.back().second, coarse.joined, run.states, 2.0, 1,
                        run.states.size() - 1, kFollowedStates, n, bars.time);
      widen_by_errors_of_steps(run, bars.time);
      share(run, Of::time, bars.time);
    }
    if (run.cycle) {
      add_open_of_cycles(open_of_cycles(c, coarse.usual.back().first, run, control), run,
                         bars.time);
    }
  }
  bars.interrupted = stopped(control);
  if (bars.interrupted) bars.grid = bars.time = {};
  return bars;
}

}  // namespace shellback::fidelity
