#pragma once
/// The value that a chart's errors are measured against, and how well it is known.
#include <array>

namespace shellback::validation {

struct ReferenceValue {
  double value = 0.0;
  double uncertainty = 0.0;  ///< absolute, not negative
  bool extrapolated = false;
};

/// From the values on three grids, each twice as fine as the one before. Where the differences
/// show second order (their ratio between 2^1.5 and 2^2.5) the value is Richardson's extrapolation
/// E(medium, fine) = fine + (fine - medium)/3, and its uncertainty its distance from
/// E(coarse, medium), which holds the larger error of the two. Elsewhere the value is that of the
/// finest grid, its uncertainty the last difference. Source: textbook (Richardson).
[[nodiscard]] ReferenceValue reference_value(double coarse, double medium, double fine);

}  // namespace shellback::validation
