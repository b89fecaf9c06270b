#pragma once
/// Bars of what is followed over time, at each of its states, from the same steps on coarser grids
/// and, on one of these, from two steps each taken as one: what that changes of a state leaves open
///   1.5 |f(2 dt) - f(dt)| / (2^n - 1)                                                        (1)
/// as a part of the larger of its values on both grids, n the order in time; states between two
/// such steps have the larger of their bars. 1.5 is the safety of the grid's bars (grid_error.hpp).
/// Source: Richardson, textbook.
#include <cmath>
#include <future>
#include <utility>
#include <vector>

#include "bearing/instant.hpp"
#include "core/largest.hpp"
#include "fidelity/grid_error.hpp"
#include "fidelity/grid_sequence.hpp"
#include "fidelity/land_error.hpp"

namespace shellback::fidelity {

/// Half-widths in the units of the values that are followed, one for each state; not a number: not
/// known. Empty: no coarser grid serves, or they were interrupted.
template <class State>
struct BarsOverTime {
  std::vector<State> grid, time;
  bool tried = false;  ///< there is something to have bars
  bool interrupted = false;

  /// Both together.
  [[nodiscard]] double at(std::size_t k, double State::*value) const {
    return grid.empty() ? NAN : grid[k].*value + time[k].*value;
  }
};

/// What a grid gives: states at the times of the run, the last ones may be missing.
template <class State>
using OnGrid = std::pair<Grid, std::vector<State>>;

/// The runs that bars are made of.
template <class State>
struct CoarseRuns {
  std::vector<OnGrid<State>> usual;  ///< those that were found, coarsest grid first
  /// On the finest of the grids, two steps each taken as one; empty: not known, or there are none.
  std::vector<State> joined;
};

/// Makes them, all at the same time; the finest tells how far it is. `pass(grid, join, control)`
/// gives the states on a grid, as few as were found, in the steps of the run or joined ones.
template <class State, class Pass>
[[nodiscard]] CoarseRuns<State> coarse_runs(const std::vector<Grid>& grids, bool steps,
                                            const bearing::SolveControl& control,
                                            const Pass& pass) {
  bearing::SolveControl loud = control;
  loud.kept = nullptr;
  bearing::SolveControl quiet = loud;
  quiet.progress = {};
  const auto begin = [&](const Grid& grid, bool join) {
    const bool told = !join && grid == grids.back();
    return std::async(std::launch::async, pass, grid, join, told ? loud : quiet);
  };
  std::vector<std::future<std::vector<State>>> all;
  for (const Grid& grid : grids) all.push_back(begin(grid, false));
  if (steps && !grids.empty()) all.push_back(begin(grids.back(), true));
  CoarseRuns<State> out;
  bool finest = false;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    std::vector<State> states = all[k].get();
    finest = !states.empty();
    if (finest) out.usual.emplace_back(grids[k], std::move(states));
  }
  if (all.size() > grids.size()) out.joined = all.back().get();
  if (!finest) out.joined.clear();
  return out;
}

/// Two steps each taken as one; of an odd number the first is left as it is.
[[nodiscard]] std::vector<double> joined(const std::vector<double>& steps);

template <class State, class Followed>
[[nodiscard]] std::vector<State> unknown(std::size_t n, const Followed& followed) {
  State one;
  for (const auto& q : followed) one.*q.value = NAN;
  return std::vector<State>(n, one);
}

/// Bar over what steps twice as long change, (1): of order n in time [-].
[[nodiscard]] inline double part_of_steps(double order) {
  return kSafety / (std::exp2(order) - 1.0);
}

/// Of nested grids, coarsest first. `edge`: what is hidden of h_min besides, as a part of it [-].
template <class State, class Followed>
[[nodiscard]] std::vector<State> bars_of_grids(const std::vector<OnGrid<State>>& coarse,
                                               const std::vector<State>& run, const Grid& grid,
                                               double edge, const Followed& followed) {
  auto bars = unknown<State>(run.size(), followed);
  for (std::size_t k = 0; k < run.size(); ++k) {
    for (const auto& q : followed) {
      std::vector<GridValue> values;
      for (const auto& [g, on] : coarse) {
        if (k < on.size()) values.push_back({cell_size(g), on[k].*q.value, 0.0});
      }
      values.push_back({cell_size(grid), run[k].*q.value, 0.0});
      bars[k].*q.value = grid_bar(values, cell_size(grid)).bar;
    }
    bars[k].h_min += edge * std::abs(run[k].h_min);
  }
  return bars;
}

/// share_bars() within each state: as what two grids, or two lengths of a step, change of a
/// quantity passes through zero in time, its bar of that instant is chance. `size_of(k, q)` of
/// value q of state k, in its unit; `is_part(q)`: its bar gives no least length to others.
template <class State, class Followed, class Size, class IsPart>
void share_bars_of_states(const Followed& followed, const Size& size_of, const IsPart& is_part,
                          std::vector<State>& bars) {
  for (std::size_t k = 0; k < bars.size(); ++k) {
    std::vector<BarOfSize> all;
    for (const auto& q : followed) {
      all.push_back({&(bars[k].*q.value), size_of(k, q), is_part(q)});
    }
    share_bars(all);
  }
}

/// No bar of the grid is shorter than what few cells on lands leave open (land_error.hpp).
template <class State, class Followed, class Size>
void widen_by_lands(const LandError& lands, const Followed& followed, const Size& size_of,
                    std::vector<State>& bars) {
  for (std::size_t k = 0; k < bars.size(); ++k) {
    for (const auto& q : followed) {
      const double open = open_by_lands(lands, q.name) * size_of(k, q);
      bars[k].*q.value = larger(bars[k].*q.value, open);
    }
  }
}

/// (1) of the states from `begin` to `end`, the last of which has been reached by each of its
/// steps; `other`, of joined steps, is looked at from `n` on, which is moved on. `usual` and
/// `other` on one grid.
template <class State, class Followed>
void add_bars_of_steps(const std::vector<State>& usual, const std::vector<State>& other,
                       const std::vector<State>& run, double order, std::size_t begin,
                       std::size_t end, const Followed& followed, std::size_t& n,
                       std::vector<State>& bars) {
  const double part = part_of_steps(order);
  const std::size_t first = (end + 1 - begin) % 2 == 0 ? begin + 1 : begin;
  for (std::size_t k = first; k <= end; k += 2, ++n) {
    if (k >= usual.size() || n >= other.size()) return;
    for (const auto& q : followed) {
      const double own = std::abs(run[k].*q.value);
      const double size = larger(own, std::abs(usual[k].*q.value));
      const double change = std::abs(other[n].*q.value - usual[k].*q.value);
      const double bar = size > 0.0 ? part * change / size * own : 0.0;
      bars[k].*q.value = bar;
      if (k > begin) bars[k - 1].*q.value = k > first ? larger(bar, bars[k - 2].*q.value) : bar;
      // Of an odd number the first step is the same in both: it errs no less than those behind it.
      const bool alone = first == begin && k == first + 2;
      if (alone) bars[first].*q.value = larger(bars[first].*q.value, bar);
    }
  }
}

}  // namespace shellback::fidelity
