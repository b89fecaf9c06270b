#pragma once
/// What a run in time follows, as a table for spreadsheets: a load cycle, a transient, a
/// running-in.
#include <string>
#include <vector>

#include "app/followed.hpp"
#include "bearing/over_time/cycle.hpp"
#include "fidelity/bars_over_time.hpp"

namespace shellback::app {

/// A column: one quantity at all instants, SI; with its bars where any are known (half-widths, grid
/// and time together).
struct Curve {
  std::string name, unit;  ///< "1" for a plain number; "rad" is shown as "deg"
  std::vector<double> values;
  std::vector<double> bars;  ///< empty: none are known
};

/// One line of names with units, then one line an instant; a bar stands behind its quantity as
/// "NAME error [unit]". Empty where there is no number. The last column is how the run ended: what
/// did not converge says so in every row. Needs curves of one length.
[[nodiscard]] std::string curves_csv(const std::vector<Curve>& curves, const Verdict& verdict);

/// Angle or time, and all that is followed over the cycle (labels/cycle_shown.hpp). The bars of a
/// cycle belong to its means and extremes, not to its instants.
[[nodiscard]] std::vector<Curve> curves_of(const bearing::Case& c,
                                           const bearing::CycleResult& cycle);

/// Time, and what is `followed` of the states.
template <class State, class Followed>
[[nodiscard]] std::vector<Curve> curves_of(const std::vector<State>& states,
                                           const fidelity::BarsOverTime<State>& bars,
                                           const Followed& followed) {
  std::vector<Curve> curves{{"time", "s", over_time(states, &State::t), {}}};
  for (const auto& q : followed) {
    Curve curve{q.name, q.unit, over_time(states, q.value), {}};
    for (std::size_t k = 0; !bars.grid.empty() && k < states.size(); ++k) {
      curve.bars.push_back(bars.at(k, q.value));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace shellback::app
