#pragma once
/// Temperatures at which the laws of an oil mean anything, whatever range they were fitted in.
#include <cmath>

#include "core/constants.hpp"
#include "rheology/density.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::rheology {

/// Above the pole of Vogel's law; below it the formula gives numbers again, without a meaning.
[[nodiscard]] inline bool above_pole(const Oil& oil, double T) {
  const auto* vogel = std::get_if<Vogel>(&oil.temperature);
  return !vogel || T - kZeroCelsius > -vogel->C;
}

/// True if viscosity, density and heat capacity at T [K] and ambient pressure are positive numbers:
/// above the pole of Vogel's law, say, and below the temperature at which expansion leaves no mass.
[[nodiscard]] inline bool laws_hold(const Oil& oil, double T) {
  const auto positive = [](double x) { return std::isfinite(x) && x > 0.0; };
  return above_pole(oil, T) && positive(viscosity(oil, T, 0.0)) &&
         positive(density(oil, T, 0.0).rho) && positive(heat_capacity(oil, T).cp);
}

}  // namespace shellback::rheology
