#pragma once
/// What a cavitated cell hands on of its fill ratio, f being its front (fill_front.hpp):
///   theta_f = theta (1 - f (1 - theta))                                                       (1)
/// f = 0: its own fill ratio (upwind). Range: |f| <= 1; theta_f then rises with theta, from 0 to 1.

namespace shellback::fluid {

/// theta_f and its derivative; beyond 0 and 1, where iterates of Newton come, its tangents.
struct CarriedFill {
  double value = 1.0;  ///< [-]
  double slope = 1.0;  ///< [-]
};
[[nodiscard]] inline CarriedFill carried_fill(double theta, double front) {
  if (theta < 0.0) return {theta * (1.0 - front), 1.0 - front};
  if (theta > 1.0) return {1.0 + (theta - 1.0) * (1.0 + front), 1.0 + front};
  return {theta * (1.0 - front * (1.0 - theta)), 1.0 - front * (1.0 - 2.0 * theta)};
}

}  // namespace shellback::fluid
