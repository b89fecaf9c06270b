#include "fidelity/march_bars.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/contract.hpp"
#include "core/largest.hpp"
#include "fidelity/edge_error.hpp"
#include "fidelity/grid_error.hpp"
#include "fidelity/grid_sequence.hpp"

namespace shellback::fidelity {

using namespace bearing;

namespace {

using Instants = std::vector<Instant>;

/// Indices of instants that end stretches, and of the last one.
std::vector<std::size_t> ends_of(const CourseRun& run) {
  std::vector<std::size_t> ends = run.ends;
  const std::size_t last = run.instants.size() - 1;
  if (ends.empty() || ends.back() != last) ends.push_back(last);
  return ends;
}

/// Two steps each taken as one; of an odd number the first is left as it is.
std::vector<double> joined(const std::vector<double>& steps) {
  std::vector<double> out;
  std::size_t k = steps.size() % 2;
  if (k == 1) out.push_back(steps.front());
  for (; k < steps.size(); k += 2) out.push_back(steps[k] + steps[k + 1]);
  return out;
}

/// The stretches as far as they were passed, in the steps that were taken.
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
Instants passed(const std::vector<Stretch>& stretches, WarmUpOptions options,
                SolveControl control) {
  control.kept = nullptr;
  try {
    return run_course(stretches, stretches.front().subject.model.tier, options, control).instants;
  } catch (const InputError&) {
    return {};
  }
}

Instant unknown() {
  Instant i;
  for (const auto& q : kFollowedInstants) i.*q.value = NAN;
  return i;
}

/// Bars of nested grids, coarsest first, whose instants have the same times as those of `run`; a
/// grid may lack the last ones.
Instants grid_bars(const std::vector<std::pair<Grid, Instants>>& coarse, const Instants& run,
                   Grid grid, double edge) {
  const auto size = [](const Grid& g) { return 1.0 / std::sqrt(g[0] * g[1]); };
  Instants bars(run.size(), unknown());
  for (std::size_t k = 0; k < run.size(); ++k) {
    for (const auto& q : kFollowedInstants) {
      std::vector<GridValue> values;
      for (const auto& [g, on] : coarse) {
        if (k < on.size()) values.push_back({size(g), on[k].*q.value, 0.0});
      }
      values.push_back({size(grid), run[k].*q.value, 0.0});
      bars[k].*q.value = grid_bar(values, size(grid)).bar;
    }
    bars[k].h_min += edge * run[k].h_min;
  }
  return bars;
}

/// (1) at one instant, as a part of the values of `usual`; `other` has taken two steps as one.
Instant change_by_steps(const Instant& usual, const Instant& other, const Instant& of,
                        double order) {
  Instant bar;
  for (const auto& q : kFollowedInstants) {
    const double size = std::abs(usual.*q.value);
    const double change = std::abs(other.*q.value - usual.*q.value);
    const double part = kSafety / (std::exp2(order) - 1.0);
    bar.*q.value = size > 0.0 ? part * change / size * std::abs(of.*q.value) : 0.0;
  }
  return bar;
}

/// Bars of the steps; `usual` and `other` on one coarse grid.
Instants time_bars(const Instants& usual, const Instants& other, const CourseRun& run) {
  const double order = run.over_cycles ? 1.0 : 2.0;
  Instants bars(run.instants.size(), unknown());
  const std::vector<std::size_t> ends = ends_of(run);
  std::size_t k = 0, n = 0;  // of the instants, and of those with joined steps
  for (const std::size_t end : ends) {
    const std::size_t begin = k;
    if ((end + 1 - begin) % 2 == 0) ++k;
    for (; k <= end; k += 2, ++n) {
      if (k >= usual.size() || n >= other.size()) return bars;
      bars[k] = change_by_steps(usual[k], other[n], run.instants[k], order);
      if (k == begin) continue;
      bars[k - 1] = bars[k];
      if (k < begin + 2) continue;
      for (const auto& q : kFollowedInstants) {
        bars[k - 1].*q.value = larger(bars[k].*q.value, bars[k - 2].*q.value);
      }
    }
    k = end + 1;
  }
  return bars;
}

}  // namespace

MarchBars march_bars(const std::vector<Stretch>& stretches, const WarmUpOptions& options,
                     const CourseRun& run, const SolveControl& control) {
  MarchBars bars;
  if (run.instants.empty()) return bars;
  const Case& c = stretches.front().subject;
  std::vector<Grid> grids = coarse_grids(c);
  if (grids.size() > 2) grids.erase(grids.begin(), grids.end() - 2);
  std::vector<std::pair<Grid, Instants>> coarse;
  for (const Grid& grid : grids) {
    Instants on = passed(as_taken(stretches, run, grid, false), options, control);
    if (!on.empty()) coarse.emplace_back(grid, std::move(on));
  }
  if (!coarse.empty() && !stopped(control)) {
    const auto& [grid, usual] = coarse.back();
    const Instants other = passed(as_taken(stretches, run, grid, true), options, control);
    const Solution& last = run.solution;
    const bool known = !run.over_cycles && last.film.least.h > 0.0;
    const double edge =
        known ? edge_error(last.model.domain.grid, last.film.gap.cell, last.film.least) /
                    last.film.least.h
              : 0.0;
    bars.grid = grid_bars(coarse, run.instants, c.model.grid, edge);
    bars.time = time_bars(usual, other, run);
  }
  bars.interrupted = stopped(control);
  if (bars.interrupted) bars.grid = bars.time = {};
  return bars;
}

MarchBars march_bars(const Case& c, const WarmUpOptions& options, const WarmUp& run,
                     const SolveControl& control) {
  CourseRun as_course;
  as_course.instants = run.instants;
  as_course.over_cycles = c.cycle.has_value();
  as_course.solution = run.solution;
  return march_bars({Stretch{c, run.end.t}}, options, as_course, control);
}

}  // namespace shellback::fidelity
