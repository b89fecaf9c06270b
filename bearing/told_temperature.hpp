#pragma once
/// Temperatures in messages. An iteration on its way to nowhere passes any number; beyond what an
/// oil can be, the number says nothing and is told in words.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/constants.hpp"

namespace shellback::bearing {

inline constexpr double kHottestTold = kZeroCelsius + 400.0;  ///< no oil film survives hotter [K]
inline constexpr double kColdestTold = 150.0;  ///< no oil is a liquid any more, no law holds [K]

/// "87 degC".
[[nodiscard]] inline std::string told_temperature(double T) {
  if (!(T <= kHottestTold)) return "more than any oil survives";
  if (T < kColdestTold) return "less than any oil is a liquid at";
  return fmt::format("{:.0f} degC", T - kZeroCelsius);
}

/// "the film is 87 K above the supply".
[[nodiscard]] inline std::string told_rise(double T, double T_supply) {
  if (!(T <= kHottestTold))
    return "the film is hotter than any oil survives, and than its laws hold";
  return fmt::format("the film is {:.0f} K above the supply", T - T_supply);
}

}  // namespace shellback::bearing
