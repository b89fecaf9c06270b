#include "bearing/row_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

std::vector<RowGap> stretches(const std::vector<double>& t, double period) {
  std::vector<RowGap> all;
  for (std::size_t k = 0; k + 1 < t.size(); ++k) {
    if (t[k + 1] > t[k]) all.push_back({k, k + 1, t[k + 1] - t[k], 0.0});
  }
  const double rest = t.front() + period - t.back();
  if (std::isfinite(period) && rest > kRoundOff * period)
    all.push_back({t.size() - 1, 0, rest, 0.0});
  return all;
}

double median_length(std::vector<RowGap> all) {
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end(),
                   [](const RowGap& a, const RowGap& b) { return a.length < b.length; });
  return middle->length;
}

}  // namespace

std::vector<RowGap> row_gaps(const std::vector<double>& t, double period) {
  EXPECTS(!t.empty());
  const std::vector<RowGap> all = stretches(t, period);
  std::vector<RowGap> gaps;
  if (all.empty()) return gaps;
  const double median = median_length(all);
  const std::size_t n = all.size();
  for (std::size_t k = 0; k < n; ++k) {
    double beside = median;
    if (k > 0) beside = std::max(beside, all[k - 1].length);
    if (k + 1 < n) beside = std::max(beside, all[k + 1].length);
    const double times = all[k].length / beside;
    if (times > kLineToTell) gaps.push_back({all[k].from, all[k].to, all[k].length, times});
  }
  return gaps;
}

}  // namespace shellback::bearing
