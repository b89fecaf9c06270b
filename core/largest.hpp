#pragma once
/// The largest of many numbers, in which what is not a number wins: a norm that passes over one
/// would call a film solved that holds it.
#include <cmath>
#include <span>

namespace shellback {

/// The larger of two.
[[nodiscard]] inline double larger(double a, double b) { return a > b || std::isnan(a) ? a : b; }

/// Largest value; 0 of nothing.
[[nodiscard]] inline double largest(std::span<const double> x) {
  double most = x.empty() ? 0.0 : x.front();
  for (const double v : x) most = larger(most, v);
  return most;
}

/// Largest |x|; 0 of nothing.
[[nodiscard]] inline double largest_magnitude(std::span<const double> x) {
  double most = 0.0;
  for (const double v : x) most = larger(most, std::abs(v));
  return most;
}

/// Largest |a - b| of two fields of one size.
[[nodiscard]] inline double largest_difference(std::span<const double> a,
                                               std::span<const double> b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = larger(most, std::abs(a[k] - b[k]));
  return most;
}

}  // namespace shellback
