#pragma once
/// What is told of each state of a run in time, with its bars, and the size of a picture of it.
#include <cmath>
#include <string>
#include <vector>

#include "app/json_parts.hpp"
#include "app/words/note_words.hpp"
#include "fidelity/bars_over_time.hpp"

namespace shellback::app {

// Size of a picture of them [px].
inline constexpr double kOverTimeWidth = 1200.0;
inline constexpr double kOverTimeHeight = 780.0;

template <class State>
[[nodiscard]] std::vector<double> over_time(const std::vector<State>& states,
                                            double State::*value) {
  std::vector<double> out;
  for (const State& s : states) out.push_back(s.*value);
  return out;
}

/// `time`, and in `quantities` what is followed over it as {unit, values, error_grid, error_time};
/// without the bars where none are known, null what has no number.
template <class State, class Followed>
void add_over_time(json_parts::Json& json, const std::vector<State>& states,
                   const fidelity::BarsOverTime<State>& bars, const Followed& followed) {
  const auto values_of = [](const std::vector<State>& of, double State::*value) {
    auto values = json_parts::Json::array();
    for (const double v : over_time(of, value)) values.push_back(json_parts::number(v));
    return values;
  };
  json["time"] = {{"unit", "s"}, {"values", values_of(states, &State::t)}};
  for (const auto& q : followed) {
    json_parts::Json& one = json["quantities"][q.name];
    one = {{"unit", q.unit}, {"values", values_of(states, q.value)}};
    if (bars.grid.empty()) continue;
    one["error_grid"] = values_of(bars.grid, q.value);
    one["error_time"] = values_of(bars.time, q.value);
  }
}

/// What `model.tolerance` is wished for of a state.
template <class State>
struct Wished {
  const char* name;
  const char* label;
  double State::*value;
};

/// How far states are known of what their case wishes to within `model.tolerance`.
struct KnownAtEnds {
  struct Part {
    std::string name, label;
    double bar = 0.0;       ///< of grid and steps, the widest of the ends, over the value [-]
    bool by_steps = false;  ///< most of it
    bool known = true;      ///< at all ends; else the bar is what is known of it
  };
  double asked = 0.0;       ///< model.tolerance [-]
  std::vector<Part> parts;  ///< empty: no bars are known
  bool all = true;          ///< those of all that is wished for are known
  bool laminar = true;      ///< false: bars are of a laminar film, which this one is not
  [[nodiscard]] bool met() const;
  /// "model.tolerance (1 %) is not met at the end: friction torque +-2.1 %"; empty: it is.
  [[nodiscard]] std::vector<std::string> words() const;
  /// {asked, met, NAME: bar}; null what is not known, or not whole.
  [[nodiscard]] json_parts::Json json() const;
};

/// Of the states `ends`, each in what is `wished`.
template <class State>
[[nodiscard]] KnownAtEnds known_at_ends(const bearing::Case& c, const std::vector<State>& states,
                                        const fidelity::BarsOverTime<State>& bars,
                                        const std::vector<std::size_t>& ends,
                                        const std::vector<Wished<State>>& wished) {
  KnownAtEnds known{c.model.tolerance, {}, true};
  if (bars.grid.empty()) return known;
  for (const auto& w : wished) {
    KnownAtEnds::Part widest{w.name, w.label};
    for (const std::size_t k : ends) {
      const double grid = bars.grid[k].*w.value, time = bars.time[k].*w.value;
      widest.known = widest.known && std::isfinite(grid) && std::isfinite(time);
      const double bar = (std::isfinite(grid) ? grid : 0.0) + (std::isfinite(time) ? time : 0.0);
      const double size = std::abs(states[k].*w.value);
      if (!(bar > widest.bar * size) || size == 0.0) continue;
      widest.bar = bar / size;
      widest.by_steps = time > grid;
    }
    known.all = known.all && widest.known;
    if (widest.bar > 0.0 || !widest.known) known.parts.push_back(widest);
  }
  return known;
}

/// That the bars were interrupted or are not known; nothing where there is nothing to have any.
template <class State>
[[nodiscard]] std::vector<std::string> bar_warnings(const fidelity::BarsOverTime<State>& bars) {
  if (bars.interrupted) return {words_of(bearing::note::Plain::bars_interrupted)};
  if (bars.tried && bars.grid.empty()) {
    return {words_of(bearing::note::Plain::march_bars_unknown)};
  }
  return {};
}

}  // namespace shellback::app
