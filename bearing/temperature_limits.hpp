#pragma once
/// What no oil can be. An iteration on its way to nowhere passes any number.
#include <algorithm>
#include <vector>

#include "core/constants.hpp"

namespace shellback::bearing {

inline constexpr double kHottestOil = kZeroCelsius + 400.0;  ///< no oil film survives hotter [K]
inline constexpr double kColdestOil = kZeroCelsius - 100.0;  ///< every oil is a glass [K]

/// True if an oil can have all of these [K]. Not a number: false.
[[nodiscard]] inline bool oil_can_be(const std::vector<double>& T) {
  return std::all_of(T.begin(), T.end(),
                     [](double t) { return t > kColdestOil && t < kHottestOil; });
}

}  // namespace shellback::bearing
