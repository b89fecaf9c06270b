#pragma once
/// Oils and helpers shared by the rheology tests.
#include <cmath>

#include "core/constants.hpp"
#include "rheology/oil.hpp"

namespace shellback::rheology::test {

/// 0W20 of seed 000 with the C = 110 K row of the bracket in data/oils/0W20.toml.
inline Oil oil_0W20() {
  Oil oil;
  oil.name = "0W20";
  oil.temperature = Vogel{0.09521e-3, 896.4, 110.0};
  oil.pressure = Barus{9.5e-9};
  oil.shear = Cross{0.5, 4.5e-8, 0.457};
  return oil;
}

inline double celsius(double t) { return t + kZeroCelsius; }

/// Central difference of f at x. Its error is of order (step/x)^2 f''' plus round-off/step: with
/// steps of 1e-5 of the scale of x about 1e-10 of the derivative; tests ask for 1e-7.
template <class F>
double central_difference(F f, double x, double step) {
  return (f(x + step) - f(x - step)) / (2.0 * step);
}
inline constexpr double kDerivativeTolerance = 1e-7;

}  // namespace shellback::rheology::test
