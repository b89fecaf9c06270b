#pragma once
/// The two classical closed solutions of the plain journal bearing, and a bridge between them.
///
/// Full cylindrical bearing, rigid, isoviscous, the film in the converging half only (half
/// Sommerfeld, Guembel). eps eccentricity ratio in [0, 1), b = B/D, So = F psi^2/(B D eta omega),
/// psi = c/R. All textbook.
#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::fidelity {

/// Infinitely wide bearing (Sommerfeld), half film:
///   So = 3 eps sqrt(pi^2 (1 - eps^2) + 4 eps^2) / ((2 + eps^2)(1 - eps^2)).
[[nodiscard]] inline double sommerfeld_half(double eps) {
  const double r = 1.0 - eps * eps;
  return 3.0 * eps * std::sqrt(kPi * kPi * r + 4.0 * eps * eps) / ((2.0 + eps * eps) * r);
}

/// Infinitely narrow bearing (Ocvirk), half film:
///   So = b^2 eps sqrt(16 eps^2 + pi^2 (1 - eps^2)) / (2 (1 - eps^2)^2).
[[nodiscard]] inline double ocvirk(double eps, double b) {
  const double r = 1.0 - eps * eps;
  return b * b * eps * std::sqrt(16.0 * eps * eps + kPi * kPi * r) / (2.0 * r * r);
}

/// Both limits at once, 1/So = 1/ocvirk + 1/sommerfeld_half: ours, within 16 % of Butenschoen's
/// tables; the measure by which the table of the finite bearing is made smooth.
[[nodiscard]] inline double bridge(double eps, double b) {
  if (eps <= 0.0) return 0.0;
  return 1.0 / (1.0 / ocvirk(eps, b) + 1.0 / sommerfeld_half(eps));
}

/// Side flow falls with the width about as this does; as the narrow bearing's below b = 0.05, the
/// first width of the tables [-].
[[nodiscard]] inline double side_scale(double b) { return 1.0 / (1.0 + std::max(b, 0.05)); }

/// Couette torque of the full film over eta omega R^3 B/c (Petroff at eps = 0):
///   2 pi / sqrt(1 - eps^2).
[[nodiscard]] inline double couette_torque(double eps) {
  return 2.0 * kPi / std::sqrt(1.0 - eps * eps);
}

}  // namespace shellback::fidelity
