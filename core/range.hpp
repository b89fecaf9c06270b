#pragma once
/// What a value can be: a range, and the words that say so.
#include <limits>

namespace shellback {

/// Values that can be computed with: low <= value <= high (low < value if `open`).
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false;
  const char* words = "";  ///< completes "it must ..."
  /// False for what is not a number.
  [[nodiscard]] constexpr bool holds(double value) const {
    return (open ? value > low : value >= low) && value <= high;
  }
};

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();
inline constexpr Range kAnyValue{};
inline constexpr Range kPositive{0.0, kInfinite, true, "be positive"};
inline constexpr Range kNotNegative{0.0, kInfinite, false, "not be negative"};
inline constexpr Range kAboveOne{1.0, kInfinite, true, "be greater than 1"};
inline constexpr Range kUpToOne{0.0, 1.0, false, "lie between 0 and 1"};

}  // namespace shellback
