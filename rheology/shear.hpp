#pragma once
/// Shear thinning: eta(T, p, rate) = eta(T, p) f(rate).
///
///   none    f = 1
///   Cross   f = r + (1 - r) / (1 + u) = (1 + r u) / (1 + u),   u = (K rate)^m    seed 000 Eq. 8
///
/// f falls from 1 to r. Its logarithmic slope is
///   d ln f / d ln rate = -m (1 - r) u / [(1 + r u)(1 + u)],
/// largest at u = 1/sqrt(r), where it is -m (1 - sqrt r)/(1 + sqrt r). The shear stress
/// tau = eta rate therefore grows with the rate everywhere if and only if
///   m (1 - sqrt r)/(1 + sqrt r) < 1,
/// which holds for every r > 0 with m <= 1, and for r = 0 with m < 1. Otherwise a stress can
/// belong to three rates (shear banding) or, for r = 0 and m >= 1, to none.
#include <cmath>
#include <variant>

#include "rheology/oil.hpp"

namespace shellback::rheology {

/// f and its slope in logarithms.
struct ShearFactor {
  double value;    ///< f [-]
  double dlnrate;  ///< d ln f / d ln rate [-]
};

[[nodiscard]] inline ShearFactor shear_factor(const NoShearThinning&, double /*rate*/) {
  return {1.0, 0.0};
}

/// rate >= 0 [1/s].
[[nodiscard]] inline ShearFactor shear_factor(const Cross& law, double rate) {
  // u or 1/u, whichever is below 1: neither overflows at any rate.
  const double x = law.K * rate;
  if (x <= 1.0) {
    const double u = std::pow(x, law.m);
    const double top = 1.0 + law.r * u;
    return {top / (1.0 + u), -law.m * (1.0 - law.r) * u / (top * (1.0 + u))};
  }
  const double v = std::pow(x, -law.m);
  const double top = v + law.r;
  return {top / (1.0 + v), -law.m * (1.0 - law.r) * v / (top * (1.0 + v))};
}

[[nodiscard]] inline ShearFactor shear_factor(const ShearLaw& law, double rate) {
  return std::visit([rate](const auto& l) { return shear_factor(l, rate); }, law);
}

/// Whether every shear stress belongs to exactly one shear rate (condition above).
[[nodiscard]] inline bool stress_is_monotone(const Cross& law) {
  const double root = std::sqrt(law.r);
  return law.m * (1.0 - root) < 1.0 + root;
}

}  // namespace shellback::rheology
