#pragma once
/// Courses of what is told of each instant of a run in time, and the size of a picture of them.
#include <vector>

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

}  // namespace shellback::app
