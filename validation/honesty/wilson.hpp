#pragma once
/// The interval of a share that was counted: Wilson's score interval.
///
/// Of n cases k hold. The interval is the set of shares p that a test at z standard deviations does
/// not reject:
///
///   |k/n - p| <= z sqrt(p (1 - p)/n)                                                   (1)
///
/// a quadratic inequality in p. Unlike k/n +- z sqrt(...) it stays within [0, 1] and has a width at
/// k = 0 and k = n: (1) gives there [0, z^2/(n + z^2)] and [n/(n + z^2), 1].
/// Source: textbook (E. B. Wilson 1927).
namespace shellback::validation {

/// Normal quantile of two-sided 95 % [-].
inline constexpr double kNormal95 = 1.959963984540054;

struct ShareInterval {
  double low = 0.0;   ///< [-]
  double high = 1.0;  ///< [-]
};

/// `held` of `count`, neither need be whole (a weighted count); nothing counted: [0, 1].
[[nodiscard]] ShareInterval wilson(double held, double count, double z = kNormal95);

}  // namespace shellback::validation
