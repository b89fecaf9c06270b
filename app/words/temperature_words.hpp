#pragma once
/// Temperatures in messages: beyond what an oil can be, the number says nothing and is told in
/// words.
#include <fmt/format.h>

#include <string>

#include "bearing/temperature_limits.hpp"

namespace shellback::app {

/// "87 degC".
[[nodiscard]] inline std::string told_temperature(double T) {
  if (!(T <= bearing::kHottestOil)) return "more than any oil survives";
  if (T < bearing::kColdestOil) return "less than any oil is a liquid at";
  return fmt::format("{:.0f} degC", T - kZeroCelsius);
}

/// "the film is 87 K above the supply".
[[nodiscard]] inline std::string told_rise(double T, double T_supply) {
  if (!(T <= bearing::kHottestOil))
    return "the film is hotter than any oil survives, and than its laws hold";
  return fmt::format("the film is {:.0f} K above the supply", T - T_supply);
}

}  // namespace shellback::app
