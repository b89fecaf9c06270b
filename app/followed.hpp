#pragma once
/// What is told of each instant of a run in time: names and units in JSON, and their courses.
#include <array>
#include <vector>

#include "bearing/heat_march.hpp"

namespace shellback::app {

// Size of a picture of them [px].
inline constexpr double kOverTimeWidth = 1200.0;
inline constexpr double kOverTimeHeight = 780.0;

template <class State>
struct Followed {
  const char* name;
  const char* unit;
  double State::*value;
};

/// Of bodies that warm up.
inline constexpr std::array kFollowedInstants{
    Followed<bearing::Instant>{"friction_torque", "N m", &bearing::Instant::torque},
    Followed<bearing::Instant>{"h_min", "m", &bearing::Instant::h_min},
    Followed<bearing::Instant>{"T_film_max", "K", &bearing::Instant::T_film_max},
    Followed<bearing::Instant>{"T_shell_max", "K", &bearing::Instant::T_shell_max},
    Followed<bearing::Instant>{"T_shell_back", "K", &bearing::Instant::T_shell_back},
    Followed<bearing::Instant>{"T_shaft", "K", &bearing::Instant::T_shaft},
    Followed<bearing::Instant>{"thermal_opening_mean", "m", &bearing::Instant::deformation},
    Followed<bearing::Instant>{"heat_in", "W", &bearing::Instant::heat_in},
    Followed<bearing::Instant>{"heat_out", "W", &bearing::Instant::heat_out},
    Followed<bearing::Instant>{"heat_stored", "W", &bearing::Instant::stored}};

template <class State>
[[nodiscard]] std::vector<double> over_time(const std::vector<State>& states,
                                            double State::*value) {
  std::vector<double> out;
  for (const State& s : states) out.push_back(s.*value);
  return out;
}

}  // namespace shellback::app
