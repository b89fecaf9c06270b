#pragma once
/// What no oil can be. An iteration on its way to nowhere passes any number.
#include "core/constants.hpp"

namespace shellback::bearing {

inline constexpr double kHottestOil = kZeroCelsius + 400.0;  ///< no oil film survives hotter [K]
inline constexpr double kColdestOil = 150.0;  ///< no oil is a liquid any more, no law holds [K]

}  // namespace shellback::bearing
