#include "core/monotone_cubic.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"

namespace shellback {
namespace {

constexpr double kSteepest = 3.0;  ///< of the secant: monotone up to there (Fritsch and Carlson)

/// `slope` brought between 0 and three times the secant.
double limited(double slope, double secant) {
  if (slope * secant <= 0.0) return 0.0;
  return std::abs(slope) > kSteepest * std::abs(secant) ? kSteepest * secant : slope;
}

}  // namespace

MonotoneCubic::MonotoneCubic(std::vector<double> x, std::vector<double> y,
                             std::optional<double> first, std::optional<double> last)
    : x_(std::move(x)), y_(std::move(y)), slope_(x_.size()) {
  const std::size_t n = x_.size();
  EXPECTS(n > 1 && y_.size() == n);
  const auto step = [&](std::size_t i) { return x_[i + 1] - x_[i]; };
  const auto secant = [&](std::size_t i) { return (y_[i + 1] - y_[i]) / step(i); };
  slope_[0] = limited(first.value_or(secant(0)), secant(0));
  slope_[n - 1] = limited(last.value_or(secant(n - 2)), secant(n - 2));
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = secant(i - 1), right = secant(i);
    if (left * right <= 0.0) continue;
    const double w1 = 2.0 * step(i) + step(i - 1), w2 = step(i) + 2.0 * step(i - 1);
    slope_[i] = (w1 + w2) / (w1 / left + w2 / right);
  }
}

ValueAndSlope MonotoneCubic::at(double x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - x_.begin()) - 1;
  const double step = x_[i + 1] - x_[i], t = (x - x_[i]) / step;
  const double a = y_[i], da = step * slope_[i], db = step * slope_[i + 1];
  const double rise = y_[i + 1] - a;
  const double c2 = 3.0 * rise - 2.0 * da - db, c3 = da + db - 2.0 * rise;
  return {a + t * (da + t * (c2 + t * c3)), (da + t * (2.0 * c2 + t * 3.0 * c3)) / step};
}

}  // namespace shellback
