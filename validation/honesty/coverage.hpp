#pragma once
/// How often error bars hold their truth, and how sure that is.
///
/// Bars of one bearing are wrong together, so that the interval of n bars drawn one by one is too
/// narrow. The second interval is Wilson's for n / D bars, D the variance of the share between
/// bearings over that of n single draws, at least 1 (design effect of the ratio estimator;
/// textbook, Kish 1965); where all or none hold, that of as many draws as there are bearings.
#include <cmath>
#include <vector>

#include "validation/honesty/honesty_record.hpp"
#include "validation/honesty/wilson.hpp"

namespace shellback::validation {

/// How well a set of bars holds.
struct Coverage {
  int count = 0;             ///< of bars that could be judged
  double held = NAN;         ///< part of them that contain the truth [-]
  ShareInterval interval;    ///< of `held`, 95 %, as if every bar were drawn by itself
  ShareInterval by_bearing;  ///< of `held`, 95 %: bars of one bearing share its film
  double median = NAN;       ///< of bar over true error [-]
  int no_truth = 0;          ///< bars that could not be judged: no truth was found
  int unknown = 0;           ///< bars that are not known themselves, where a truth is
  [[nodiscard]] double share_without_truth() const;  ///< of all bars that are known [-]
};

/// Which bar against which truth: that of the grid against the fine grid, or against the limit of
/// fine grids (a truth twice as fine is itself off by a part of the bar); that of grid and model
/// together against the full physics on the fine grid.
enum class BarKind { grid, limit, total };

/// Bar and true error of a sample, both over its natural size; false: it has no such bar, or there
/// is nothing to test (given by the case, no truth, both exact).
struct BarAgainstError {
  double bar = 0.0;
  double error = 0.0;
};
[[nodiscard]] bool testable(const BarSample& s, BarKind kind);
[[nodiscard]] BarAgainstError bar_against_error(const BarSample& s, BarKind kind);

[[nodiscard]] Coverage coverage_of(const std::vector<BarSample>& samples, BarKind kind);

}  // namespace shellback::validation
