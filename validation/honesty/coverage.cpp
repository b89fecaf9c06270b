#include "validation/honesty/coverage.hpp"

#include <algorithm>
#include <map>

namespace shellback::validation {
namespace {

double error_of(const BarSample& s, BarKind kind) {
  const double truth = kind == BarKind::grid    ? s.truth_tier
                       : kind == BarKind::limit ? s.truth_limit
                                                : s.truth_full;
  return std::abs(s.value - truth);
}

bool bar_known(const BarSample& s, BarKind kind) {
  if (kind == BarKind::total && !std::isfinite(s.error_model) && !s.richest) return false;
  return std::isfinite(s.error_grid);
}

/// True if it is a bar to be judged, were its truth known.
bool is_asked(const BarSample& s, BarKind kind) {
  return bar_known(s, kind) && !(s.given && (kind != BarKind::total || s.richest));
}

/// Bars of a bearing, and those that hold.
struct Counted {
  int bars = 0;
  int held = 0;
};

/// As many bars drawn one by one are as sure as these, of which the part p holds.
double effective_count(const std::map<int, Counted>& bearings, int count, double p) {
  const auto m = static_cast<double>(bearings.size());
  if (m < 2.0 || p <= 0.0 || p >= 1.0) return std::min<double>(m, count);
  double squares = 0.0;
  for (const auto& [subject, c] : bearings) squares += std::pow(c.held - p * c.bars, 2);
  const double variance = m / (m - 1.0) * squares / (static_cast<double>(count) * count);
  const double single = p * (1.0 - p) / count;
  return count / std::max(1.0, variance / single);
}

}  // namespace

bool testable(const BarSample& s, BarKind kind) {
  // A value that meets its truth to this part of its size does so whatever its bar: what is zero by
  // construction (heat of a sealed shaft, contact that there is not) proves none.
  constexpr double kExact = 1e-9;
  if (!is_asked(s, kind)) return false;
  const BarAgainstError b = bar_against_error(s, kind);
  return std::isfinite(b.error) && std::isfinite(b.bar) && b.error > kExact;
}

BarAgainstError bar_against_error(const BarSample& s, BarKind kind) {
  double bar = s.error_grid;
  if (kind == BarKind::total && std::isfinite(s.error_model)) bar += s.error_model;
  return {bar / s.size, error_of(s, kind) / s.size};
}

double Coverage::share_without_truth() const {
  const int all = count + no_truth;
  return all > 0 ? static_cast<double>(no_truth) / all : NAN;
}

Coverage coverage_of(const std::vector<BarSample>& samples, BarKind kind) {
  Coverage c;
  int held = 0;
  std::vector<double> ratios;
  std::map<int, Counted> bearings;
  for (const BarSample& s : samples) {
    const bool truth = std::isfinite(error_of(s, kind));
    if (truth && !bar_known(s, kind)) ++c.unknown;
    if (!truth && is_asked(s, kind)) ++c.no_truth;
    if (!testable(s, kind)) continue;
    const BarAgainstError b = bar_against_error(s, kind);
    const bool holds = b.error <= b.bar;
    held += holds;
    ++bearings[s.subject].bars;
    bearings[s.subject].held += holds;
    ratios.push_back(b.error > 0.0 ? b.bar / b.error : INFINITY);
  }
  c.count = static_cast<int>(ratios.size());
  if (c.count == 0) return c;
  c.held = static_cast<double>(held) / c.count;
  c.interval = wilson(held, c.count);
  const double effective = effective_count(bearings, c.count, c.held);
  c.by_bearing = wilson(c.held * effective, effective);
  std::nth_element(ratios.begin(), ratios.begin() + c.count / 2, ratios.end());
  c.median = ratios[c.count / 2];
  return c;
}

}  // namespace shellback::validation
