#pragma once
/// Closed-form solutions of the isoviscous film of a journal bearing, for the tests of fluid/.
/// eps eccentricity ratio, phi from the widest gap in the direction of rotation, psi = c/R,
/// So = F psi^2/(B D eta omega).
#include <cmath>

namespace shellback::analytic {

/// Infinitely wide bearing, full film (Sommerfeld 1904, textbook): So; attitude 90 deg.
inline double sommerfeld_load(double eps) {
  const double pi = 3.14159265358979323846;
  return 6.0 * pi * eps / ((2.0 + eps * eps) * std::sqrt(1.0 - eps * eps));
}

/// The same: pressure above that of the widest gap, in units of eta omega/psi^2 [-].
inline double sommerfeld_pressure(double eps, double phi) {
  const double h = 1.0 + eps * std::cos(phi);
  return 6.0 * eps * std::sin(phi) * (1.0 + h) / ((2.0 + eps * eps) * h * h);
}

/// Infinitely narrow bearing, film in the converging half (Ocvirk 1953, textbook):
/// So = (B/D)^2 times this, attitude [rad].
inline double ocvirk_load(double eps) {
  const double pi = 3.14159265358979323846;
  const double square = 1.0 - eps * eps;
  return eps / (2.0 * square * square) * std::sqrt(16.0 * eps * eps + pi * pi * square);
}
inline double ocvirk_attitude(double eps) {
  const double pi = 3.14159265358979323846;
  return std::atan(pi * std::sqrt(1.0 - eps * eps) / (4.0 * eps));
}

}  // namespace shellback::analytic
