#include "fidelity/running_in_bars.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/bearing.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "core/bracketed_root.hpp"
#include "core/contract.hpp"
#include "core/round_off.hpp"
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
  if (!run.cycle) return part_hidden_at_edge(run.solution);
  const CycleFields& f = run.cycle->fields;
  const double least = run.states.back().h_min;
  return least > 0.0 ? edge_error(f.grid, f.h_min, f.in_supply) / least : 0.0;
}

/// Whether summits hardly touch at the end, where they have worn: share of the load, over a cycle
/// of the friction.
bool touches_lightly(const RunningInRun& run) {
  if (!run.cycle) return value_in(scalars(run.solution), "asperity_load_share") < kLight;
  return quantity_named(*run.cycle, "friction_torque_asperity")->quantity.size() <
         kLight * quantity_named(*run.cycle, "friction_torque")->quantity.size();
}

/// The case with the surface that it has at `state`.
Case as_worn(const Case& c, const RunningInState& state) {
  Case worn = c;
  worn.surfaces.shell = worn_surface(c, state.depth);
  return worn;
}

void widen_bars_of_light_contact(const Case& c, const RunningInRun& run, States& bars) {
  if (!c.surfaces.contact || !touches_lightly(run)) return;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const double open = left_open_by_film(*contact_of(as_worn(c, run.states[k])),
                                          run.states[k].h_min, bars[k].h_min);
    bars[k].p_asperity_max = larger(bars[k].p_asperity_max, open);
  }
}

/// Gap at which summits are pressed as hard as the limit of the wear, between that of `state` and
/// by how much its bar `open` leaves it lower [m].
double gap_at_limit(const Case& c, const RunningInState& state, double open) {
  const solid::AsperityContact contact = *contact_of(as_worn(c, state));
  const double limit = c.running_in->limit_pressure;
  return root_between([&](double h) { return contact.at(h).p - limit; }, state.h_min - open,
                      state.h_min, kRoundOff * state.h_min);
}

/// What could have worn by now if the gap had stood by `open` lower all the time [m].
double worn_by_now(const Case& c, const RunningInState& state, double open) {
  if (!c.running_in->duration) return INFINITY;
  const double speed =
      c.cycle ? cycle_numbers(*c.cycle, c.operation.omega).mean_sliding : c.operation.omega;
  const double p = contact_of(as_worn(c, state))->at(state.h_min - open).p;
  return c.running_in->wear_coefficient / hardness_of_shell(c) * std::abs(speed) *
         c.bearing.radius * std::max(0.0, p - c.running_in->limit_pressure) * state.t;
}

/// What hardly touches may wear on a finer grid whose film is lower by its bar: until it stands
/// where the limit of the wear does, if there is the time. Two grids on which nothing wears agree
/// on that, whatever the film.
void widen_bars_of_wear(const Case& c, const RunningInRun& run, States& bars) {
  if (!c.surfaces.contact || !touches_lightly(run)) return;
  const FilmGrid& g = run.cycle ? run.cycle->fields.grid : run.solution.model.domain.grid;
  const Field& gap = run.cycle ? run.cycle->fields.h_min : run.solution.film.gap.cell;
  for (std::size_t k = 1; k < bars.size(); ++k) {
    const double open = bars[k].h_min;
    if (!std::isfinite(open)) continue;
    const double stands = gap_at_limit(c, run.states[k], open) + open;
    const double most = worn_by_now(c, run.states[k], open);
    const auto left = [&](double h) { return std::clamp(stands - h, 0.0, most); };
    Field wear;
    for (const double h : gap) wear.push_back(left(h));
    bars[k].depth = larger(bars[k].depth, left(run.states[k].h_min));
    bars[k].volume = larger(bars[k].volume, area_integral(g, wear));
  }
}

enum class Of { grid, time };

void share(const RunningInRun& run, Of of, const LandError& lands, States& bars) {
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
  widen_by_lands(lands, kFollowedStates, size, bars);
  share_bars_of_states(kFollowedStates, size, is_part, bars);
}

/// Where the states that lead to state k begin: the new bearing, or the last one found anew.
std::size_t branch_of(const RunningInRun& run, std::size_t k) {
  while (k > 0 && !run.states[k].anew) --k;
  return k;
}

/// Part of what a value has changed since a former state that may be the errors of all steps so
/// far, and that state: the nearest before k in which the volume differs by as much as it errs, or
/// the first of the branch.
std::pair<double, std::size_t> part_of_change(const RunningInRun& run, std::size_t k) {
  const RunningInState& at = run.states[k];
  const double off = kSafety * at.volume_error;
  std::size_t from = k;
  for (const std::size_t first = branch_of(run, k); from > first;) {
    if (at.volume - run.states[--from].volume >= off) break;
  }
  const double worn = at.volume - run.states[from].volume;
  return {worn > off ? off / worn : off == 0.0 ? 0.0 : 1.0, from};
}

/// What the steps within the cycle of the case leave open, on its grid, over the larger of its
/// value there and that of `state` [-]; not a number: not known. Wear goes as the summits' friction
/// does.
RunningInState open_within_cycle(const Case& c, const RunningInState& state,
                                 const SolveControl& control) {
  const auto cycle = cycle_with_bars_of_steps(c, control);
  RunningInState part = unknown<RunningInState>(1, kFollowedStates).front();
  if (!cycle) return part;
  const auto of = [&](const char* name, double value) {
    const Quantity& q = quantity_named(*cycle, name)->quantity;
    const double size = std::max(q.size(), std::abs(value));
    return size > 0.0 ? std::min(q.error_time, furthest(c, q)) / size : 0.0;
  };
  part.depth = part.volume = of("friction_torque_asperity", 0.0);
  part.p_asperity_max = of("p_asperity_max", state.p_asperity_max);
  part.torque = of("friction_torque", state.torque);
  part.h_min = of("h_min", state.h_min);
  return part;
}

/// Of each state, between the new bearing and the last shape by what has worn, as `grid` tells.
void add_open_within_cycles(const Case& c, const Grid& grid, const RunningInRun& run,
                            const SolveControl& control, States& bars) {
  SolveControl within = control;  // of each cycle; kept is the running-in
  within.kept = nullptr;
  Case on = c;
  on.model.grid = grid;
  const RunningInState first = open_within_cycle(on, run.states.front(), within);
  on.bearing.wear = wear_table(run.grid, run.wear);
  on.surfaces.shell = worn_surface(c, run.states.back().depth);
  const RunningInState last = open_within_cycle(on, run.states.back(), within);
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const RunningInState& at = run.states[k];
    const double all = run.states.back().volume;
    const double worn = all > 0.0 ? at.volume / all : 0.0;
    for (const auto& q : kFollowedStates) {
      const double RunningInState::*value = q.value;
      const bool sum = value == &RunningInState::depth || value == &RunningInState::volume;
      const double to = sum ? 0.5 * worn : worn;  // what has worn has seen all parts so far
      const double part = (1.0 - to) * first.*value + to * last.*value;
      bars[k].*q.value += part * std::abs(at.*q.value);
    }
  }
}

/// Whether the errors of the volume may hide on which side of the change at m state k lies: before
/// it as volume, behind it as the time that the wear before takes for as much.
bool may_lie_behind(const RunningInRun& run, std::size_t k, std::size_t m) {
  const RunningInState &at = run.states[k], &change = run.states[m], &before = run.states[m - 1];
  const double off = kSafety * before.volume_error;
  if (k < m) return change.volume - at.volume <= off;
  return (at.t - change.t) * (change.volume - before.volume) <= off * change.step;
}

}  // namespace

void widen_by_errors_of_steps(const RunningInRun& run, States& bars) {
  for (std::size_t k = 1; k < bars.size(); ++k) {
    const RunningInState& at = run.states[k];
    const auto [part, from] = part_of_change(run, k);
    for (const auto& q : kFollowedStates) {
      const double by = part * std::abs(at.*q.value - run.states[from].*q.value);
      bars[k].*q.value = larger(bars[k].*q.value, by);
      for (std::size_t m = 1; m < run.states.size(); ++m) {
        if (!run.states[m].anew || !may_lie_behind(run, k, m)) continue;
        const double change = run.states[m].*q.value - run.states[m - 1].*q.value;
        bars[k].*q.value = larger(bars[k].*q.value, std::abs(change));
      }
    }
    bars[k].depth = larger(bars[k].depth, kSafety * at.depth_error);
    bars[k].volume = larger(bars[k].volume, kSafety * at.volume_error);
  }
}

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
    share(run, Of::grid, land_error(c), bars.grid);
    widen_bars_of_light_contact(c, run, bars.grid);
    widen_bars_of_wear(c, run, bars.grid);
    bars.time = States(run.states.size());  // a worn-in shape has no steps
    if (!steps.empty()) {
      bars.time = unknown<RunningInState>(run.states.size(), kFollowedStates);
      bars.time.front() = {};  // the new bearing
      std::size_t n = 1;
      add_bars_of_steps(coarse.usual.back().second, coarse.joined, run.states, 2.0, 1,
                        run.states.size() - 1, kFollowedStates, n, bars.time);
      widen_by_errors_of_steps(run, bars.time);
      share(run, Of::time, {}, bars.time);
    }
    if (run.cycle) {
      add_open_within_cycles(c, coarse.usual.back().first, run, control, bars.time);
    }
  }
  bars.interrupted = stopped(control);
  if (bars.interrupted) bars.grid = bars.time = {};
  return bars;
}

}  // namespace shellback::fidelity
