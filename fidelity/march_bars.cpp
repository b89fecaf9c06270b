#include "fidelity/march_bars.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/contract.hpp"
#include "fidelity/cycle_bars.hpp"
#include "fidelity/edge_error.hpp"
#include "fidelity/quantities.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

using Instants = std::vector<Instant>;

constexpr double kOrder = 2.0;  ///< of the steps under a steady load (heat_march.hpp)

/// Indices of instants that end stretches, and of the last one.
std::vector<std::size_t> ends_of(const CourseRun& run) {
  std::vector<std::size_t> ends = run.ends;
  const std::size_t last = run.instants.size() - 1;
  if (ends.empty() || ends.back() != last) ends.push_back(last);
  return ends;
}

/// The stretches as far as they were passed, in the steps that were taken, or two of them as one.
std::vector<Stretch> as_taken(std::vector<Stretch> stretches, const CourseRun& run, Grid grid,
                              bool join) {
  const std::vector<std::size_t> ends = ends_of(run);
  stretches.resize(ends.size());
  std::size_t k = 0;
  for (std::size_t n = 0; n < ends.size(); ++n) {
    Stretch& s = stretches[n];
    s.subject.model.grid = grid;
    s.steps.clear();
    for (; k <= ends[n]; ++k) s.steps.push_back(run.instants[k].dt);
    if (join) s.steps = joined(s.steps);
    s.duration = 0.0;
    for (const double dt : s.steps) s.duration += dt;
  }
  return stretches;
}

/// What another grid or other steps give; nothing where the grid cannot carry the supplies.
Instants passed(const std::vector<Stretch>& stretches, const WarmUpOptions& options,
                const SolveControl& control) {
  try {
    return run_course(stretches, stretches.front().subject.model.tier, options, control).instants;
  } catch (const InputError&) {
    return {};
  }
}

Instants time_bars(const Instants& usual, const Instants& other, const CourseRun& run) {
  auto bars = unknown<Instant>(run.instants.size(), kFollowedInstants);
  std::size_t begin = 0, n = 0;
  for (const std::size_t end : ends_of(run)) {
    if (begin == end) {  // one step alone has no other to be judged by
      ++begin;
      ++n;
      continue;
    }
    add_bars_of_steps(usual, other, run.instants, run.over_cycles ? 1.0 : kOrder, begin, end,
                      kFollowedInstants, n, bars);
    begin = end + 1;
  }
  return bars;
}

/// Where values count from [K].
struct Begun {
  double walls, supply;
};

/// What a value has come to: walls since the start, the film above its supply, heat of all that is
/// made; a kelvin at least, as in natural_size().
double size_of(const Instant& now, const Begun& begun, const Followed<Instant>& q) {
  const double value = now.*q.value;
  const std::string_view unit = q.unit;
  if (unit == "W") return std::abs(now.heat_in);
  if (unit != "K") return std::abs(value);
  const double from = q.value == &Instant::T_film_max ? begun.supply : begun.walls;
  return std::max(std::abs(value - from), 1.0);
}

/// What of it friction may have made: walls warm from their start by oil of the supply's
/// temperature, too, and by friction no further than the film rises above that.
double rubbed_of(const Instant& now, const Begun& begun, const Followed<Instant>& q) {
  const double size = size_of(now, begun, q);
  const double rise = std::abs(now.T_film_max - begun.supply);
  return std::string_view(q.unit) == "K" ? std::min(size, std::max(rise, 1.0)) : size;
}

/// And the heat by which temperatures change is known no better than the torque (solve.cpp).
/// `lands`: of bars of the grid.
void share(const CourseRun& run, const Begun& begun, const LandError& lands, Instants& bars) {
  const auto size = [&](std::size_t k, const Followed<Instant>& q) {
    return size_of(run.instants[k], begun, q);
  };
  const auto none = [](const Followed<Instant>&) { return false; };
  widen_by_lands(lands, kFollowedInstants, size, bars);
  share_bars_of_states(kFollowedInstants, size, none, bars);
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const double heat = bars[k].torque / std::abs(run.instants[k].torque);
    for (const auto& q : kFollowedInstants) {
      double& bar = bars[k].*q.value;
      const double least = heat * rubbed_of(run.instants[k], begun, q);
      if (is_of_heat(q.name) && bar < least) bar = least;
    }
  }
}

/// And what the steps within the cycle leave open, of the last stretch's on `grid`: marches on all
/// grids take the same. Where that cycle is not found no bar of steps is known.
void add_open_within_cycles(Case c, const Grid& grid, SolveControl control, const CourseRun& run,
                            Instants& bars) {
  control.kept = nullptr;
  c.model.grid = grid;
  const auto cycle = cycle_with_bars_of_steps(c, control);
  for (const auto& q : kFollowedInstants) {
    if (!cycle) {
      for (Instant& bar : bars) bar.*q.value = NAN;
      continue;
    }
    const CycleQuantity* known = quantity_named(*cycle, q.name);
    if (known == nullptr) continue;  // of bodies: they see the cycle's mean
    const Quantity& told = known->quantity;
    const double open = std::min(told.error_time, furthest(c, told));
    const bool absolute = std::string_view(q.unit) == "K";
    for (std::size_t k = 0; k < bars.size(); ++k) {
      const double value = std::abs(run.instants[k].*q.value);
      bars[k].*q.value += absolute || told.size() == 0.0 ? open : open / told.size() * value;
    }
  }
}

/// Of marches in steps of their own, which end at times of their own.
EndBars end_bars(const std::vector<Stretch>& stretches, const WarmUpOptions& options,
                 const CourseRun& run, const SolveControl& control) {
  using Times = std::vector<double>;
  const Case& c = stretches.front().subject;
  const auto time_on = [&](const Grid& grid, bool longer, const SolveControl& within) {
    std::vector<Stretch> on = stretches;
    for (Stretch& s : on) s.subject.model.grid = grid;
    WarmUpOptions o = options;
    if (longer) o.error *= std::exp2(kOrder);  // steps twice as long
    try {
      const CourseRun other = run_course(on, c.model.tier, o, within);
      if (other.end.left_bounds) return Times{other.end.t};
      return other.end.verdict.good() ? Times{INFINITY} : Times{};  // its film lasts
    } catch (const InputError&) {  // the grid cannot carry the supplies
      return Times{};
    }
  };
  const auto coarse = coarse_runs<double>(nearest_coarse_grids(c), true, control, time_on);
  EndBars bars;
  if (coarse.usual.empty()) return bars;
  std::vector<GridValue> values;
  for (const auto& [grid, times] : coarse.usual) {
    values.push_back({cell_size(grid), times.front(), 0.0});
  }
  values.push_back({cell_size(c.model.grid), run.end.t, 0.0});
  const bool all = std::all_of(values.begin(), values.end(),
                               [](const GridValue& v) { return std::isfinite(v.value); });
  if (all) bars.grid = grid_bar(values, values.back().h).bar;
  if (coarse.joined.empty()) return bars;
  const double change = coarse.joined.front() - coarse.usual.back().second.front();
  if (!std::isfinite(change)) return bars;
  bars.time = part_of_steps(kOrder) * std::abs(change);
  return bars;
}

}  // namespace

std::vector<double> joined(const std::vector<double>& steps) {
  std::vector<double> out;
  std::size_t k = steps.size() % 2;
  if (k == 1) out.push_back(steps.front());
  for (; k < steps.size(); k += 2) out.push_back(steps[k] + steps[k + 1]);
  return out;
}

MarchBars march_bars(const std::vector<Stretch>& stretches, const WarmUpOptions& options,
                     const CourseRun& run, const SolveControl& control) {
  MarchBars bars;
  if (run.instants.empty()) return bars;
  bars.tried = true;
  const Case& c = stretches.front().subject;
  const auto coarse =
      coarse_runs<Instant>(nearest_coarse_grids(c), true, control,
                           [&](const Grid& grid, bool join, const SolveControl& within) {
                             return passed(as_taken(stretches, run, grid, join), options, within);
                           });
  if (!coarse.usual.empty()) {
    const double at_edge = run.over_cycles ? 0.0 : part_hidden_at_edge(run.solution);
    bars.grid = bars_of_grids(coarse.usual, run.instants, c.model.grid, at_edge, kFollowedInstants);
    bars.time = time_bars(coarse.usual.back().second, coarse.joined, run);
    const Begun begun{options.T_start, mean_supply_temperature(c)};
    share(run, begun, land_error(c), bars.grid);
    share(run, begun, {}, bars.time);
    if (run.over_cycles && !stopped(control)) {
      add_open_within_cycles(stretches.back().subject, coarse.usual.back().first, control, run,
                             bars.time);
    }
  }
  if (run.end.left_bounds) bars.end = end_bars(stretches, options, run, control);
  bars.interrupted = stopped(control);
  if (bars.interrupted) {
    bars.grid = bars.time = {};
    bars.end = {};
  }
  return bars;
}

MarchBars march_bars(const Case& c, const WarmUpOptions& options, const WarmUp& run,
                     const SolveControl& control) {
  CourseRun as_course;
  as_course.instants = run.instants;
  as_course.over_cycles = c.cycle.has_value();
  as_course.solution = run.solution;
  as_course.end = run.end;
  // A coarser grid whose film lasts twice as long tells no bar.
  const double duration = std::min(options.end, 2.0 * run.end.t);
  return march_bars({Stretch{c, duration}}, options, as_course, control);
}

}  // namespace shellback::fidelity
