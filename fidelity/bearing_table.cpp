#include "fidelity/bearing_table.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "core/table_rows.hpp"
#include "fidelity/closed_forms.hpp"

namespace shellback::fidelity {
namespace {

using Numbers = std::array<double, 5>;

/// The numbers as ratios to closed forms, in which they are smooth.
Numbers smoothed(double eps, double b, const BearingNumbers& n) {
  return {std::log(n.so / bridge(eps, b)), n.attitude / std::acos(eps), n.couette,
          std::log(n.side / (eps * side_scale(b))), std::log(n.pressure)};
}

BearingNumbers restored(double eps, double b, const Numbers& s) {
  return {bridge(eps, b) * std::exp(s[0]), std::acos(eps) * s[1], s[2],
          eps * side_scale(b) * std::exp(s[3]), std::exp(s[4])};
}

struct PlainBearingTable {
  std::vector<double> v;         ///< ln b
  std::vector<double> u;         ///< -ln(1 - eps)
  std::vector<Numbers> numbers;  ///< smoothed, index v * u.size() + u
};

PlainBearingTable read_plain_bearing() {
  PlainBearingTable t;
  for (const std::vector<double>& row : table_rows(plain_bearing_table())) {
    const double b = row[0], eps = row[1];
    const BearingNumbers n{row[2], row[3] * kPi / 180.0, row[4], row[5], row[6]};
    if (t.v.empty() || std::log(b) != t.v.back()) t.v.push_back(std::log(b));
    if (t.v.size() == 1) t.u.push_back(-std::log1p(-eps));
    t.numbers.push_back(smoothed(eps, b, n));
  }
  ENSURES(t.numbers.size() == t.v.size() * t.u.size());
  return t;
}

const PlainBearingTable& plain_bearing() {
  static const PlainBearingTable once = read_plain_bearing();
  return once;
}

}  // namespace

BearingCurve::BearingCurve(double b) : b_(b) {
  EXPECTS(b > 0.0);
  const PlainBearingTable& t = plain_bearing();
  const double v = std::clamp(std::log(b), t.v.front(), t.v.back());
  std::vector<double> column(t.v.size()), ratio(t.u.size());
  for (std::size_t number = 0; number < ratios_.size(); ++number) {
    for (std::size_t e = 0; e < t.u.size(); ++e) {
      for (std::size_t w = 0; w < t.v.size(); ++w) {
        column[w] = t.numbers[w * t.u.size() + e][number];
      }
      ratio[e] = MonotoneCubic(t.v, column).at(v).value;
    }
    ratios_[number] = MonotoneCubic(t.u, ratio);
  }
}

BearingNumbers BearingCurve::at(double eps) const {
  EXPECTS(eps > 0.0 && eps < 1.0);
  const PlainBearingTable& t = plain_bearing();
  const double u = -std::log1p(-eps);
  Numbers s{};
  const double within = std::clamp(u, t.u.front(), t.u.back());
  for (std::size_t k = 0; k < s.size(); ++k) s[k] = ratios_[k].at(within).value;
  s[4] += 0.5 * std::max(0.0, u - t.u.back());  // p_max/p ~ (1 - eps)^(-1/2)
  return restored(eps, b_, s);
}

}  // namespace shellback::fidelity
