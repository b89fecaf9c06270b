#pragma once
/// What a cavitated cell hands on of its fill ratio, f being its front (fill_front.hpp):
///   theta_f = theta/(1 + f (1 - theta)),   d theta_f / d theta = (1 + f)/(1 + f (1 - theta))^2 (1)
/// f = 0: its own fill ratio (upwind). Range: f > -1; theta_f then rises with theta, from 0 to 1.

namespace shellback::fluid {

/// theta_f and its derivative; beyond 0 and 1, where iterates of Newton come, its tangents.
struct CarriedFill {
  double value = 1.0;  ///< [-]
  double slope = 1.0;  ///< [-]
};
[[nodiscard]] inline CarriedFill carried_fill(double theta, double front) {
  const double steepest = 1.0 + front;  // slope at theta = 1; its inverse at 0
  if (theta < 0.0) return {theta / steepest, 1.0 / steepest};
  if (theta > 1.0) return {1.0 + (theta - 1.0) * steepest, steepest};
  const double d = 1.0 + front * (1.0 - theta);
  return {theta / d, steepest / (d * d)};
}

}  // namespace shellback::fluid
