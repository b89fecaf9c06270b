#include "fidelity/bearing_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "core/contract.hpp"
#include "fidelity/closed_forms.hpp"
#include "fidelity/table_text.hpp"

namespace shellback::fidelity {
namespace {

constexpr int kNumbers = 5;
using Numbers = std::array<double, kNumbers>;

constexpr double kNarrow = 0.05;  ///< B/D from which on downwards the side flow is the narrow one

/// Side flow over eps falls with the width as this does.
double side_scale(double b) { return 1.0 / (1.0 + std::max(b, kNarrow)); }

/// The numbers as ratios to closed forms, in which they are smooth.
Numbers smoothed(double eps, double b, const BearingNumbers& n) {
  return {std::log(n.so / bridge(eps, b)), n.attitude / std::acos(eps), n.couette,
          std::log(n.side / (eps * side_scale(b))), std::log(n.pressure)};
}

BearingNumbers restored(double eps, double b, const Numbers& s) {
  return {bridge(eps, b) * std::exp(s[0]), std::acos(eps) * s[1], s[2],
          eps * side_scale(b) * std::exp(s[3]), std::exp(s[4])};
}

struct Table {
  std::vector<double> b;         ///< widths over diameter
  std::vector<double> eps;       ///< eccentricity ratios
  std::vector<double> u;         ///< -ln(1 - eps)
  std::vector<Numbers> numbers;  ///< smoothed, index b * eps.size() + eps
};

Table read_table() {
  Table t;
  std::istringstream text(plain_bearing_table());
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'B') continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream cells(line);
    double b = 0.0;
    double eps = 0.0;
    double degrees = 0.0;
    BearingNumbers n;
    cells >> b >> eps >> n.so >> degrees >> n.couette >> n.side >> n.pressure;
    n.attitude = degrees * kPi / 180.0;
    if (t.b.empty() || b != t.b.back()) t.b.push_back(b);
    if (t.b.size() == 1) {
      t.eps.push_back(eps);
      t.u.push_back(-std::log1p(-eps));
    }
    t.numbers.push_back(smoothed(eps, b, n));
  }
  ENSURES(t.numbers.size() == t.b.size() * t.eps.size());
  return t;
}

const Table& table() {
  static const Table once = read_table();
  return once;
}

/// Slope of a monotone cubic at a node between two secants (Fritsch and Carlson's condition in
/// Brodlie's harmonic form, textbook): 0 at an extremum, a weighted harmonic mean elsewhere.
double node_slope(double h0, double h1, double d0, double d1) {
  if (d0 * d1 <= 0.0) return 0.0;
  const double w0 = 2.0 * h1 + h0;
  const double w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// Slope at node k of values y over x. The end nodes take the secant.
double slope_at(const std::vector<double>& x, const std::vector<double>& y, std::size_t k) {
  const auto secant = [&](std::size_t a) { return (y[a + 1] - y[a]) / (x[a + 1] - x[a]); };
  if (k == 0) return secant(0);
  if (k + 1 == x.size()) return secant(k - 1);
  return node_slope(x[k] - x[k - 1], x[k + 1] - x[k], secant(k - 1), secant(k));
}

/// Cubic of end values and slopes at the part t of an interval of length h.
double cubic(double t, double h, double y0, double y1, double m0, double m1) {
  const double s = 1.0 - t;
  return s * s * (1.0 + 2.0 * t) * y0 + t * t * (1.0 + 2.0 * s) * y1 +
         h * t * s * (s * m0 - t * m1);
}

}  // namespace

BearingCurve::BearingCurve(double b) : b_(b) {
  EXPECTS(b > 0.0);
  const Table& t = table();
  const std::size_t n = t.eps.size();
  std::vector<double> v;
  for (const double width : t.b) v.push_back(std::log(width));
  const double at = std::clamp(std::log(b), v.front(), v.back());
  const std::size_t right = std::clamp<std::size_t>(
      std::upper_bound(v.begin(), v.end(), at) - v.begin(), 1, v.size() - 1);
  const double h = v[right] - v[right - 1];
  const double part = (at - v[right - 1]) / h;
  values_.resize(n * kNumbers);
  slopes_.resize(n * kNumbers);
  std::vector<double> column(v.size());
  for (int k = 0; k < kNumbers; ++k) {
    for (std::size_t e = 0; e < n; ++e) {
      for (std::size_t w = 0; w < v.size(); ++w) column[w] = t.numbers[w * n + e][k];
      values_[e * kNumbers + k] = cubic(part, h, column[right - 1], column[right],
                                        slope_at(v, column, right - 1), slope_at(v, column, right));
    }
    std::vector<double> row(n);
    for (std::size_t e = 0; e < n; ++e) row[e] = values_[e * kNumbers + k];
    for (std::size_t e = 0; e < n; ++e) slopes_[e * kNumbers + k] = slope_at(t.u, row, e);
  }
}

BearingNumbers BearingCurve::at(double eps) const {
  EXPECTS(eps > 0.0 && eps < 1.0);
  const Table& t = table();
  const double u = std::clamp(-std::log1p(-eps), t.u.front(), t.u.back());
  const std::size_t right = std::clamp<std::size_t>(
      std::upper_bound(t.u.begin(), t.u.end(), u) - t.u.begin(), 1, t.u.size() - 1);
  const double h = t.u[right] - t.u[right - 1];
  const double part = (u - t.u[right - 1]) / h;
  Numbers s{};
  for (int k = 0; k < kNumbers; ++k) {
    const std::size_t a = (right - 1) * kNumbers + k;
    s[k] = cubic(part, h, values_[a], values_[a + kNumbers], slopes_[a], slopes_[a + kNumbers]);
  }
  const double beyond = -std::log1p(-eps) - t.u.back();
  if (beyond > 0.0) s[4] += 0.5 * beyond;  // p_max/p ~ (1 - eps)^(-1/2)
  return restored(eps, b_, s);
}

double BearingCurve::eccentricity(double so) const {
  EXPECTS(so >= 0.0);
  constexpr double kLeast = 1e-9;  // eps and 1 - eps below which nothing is told apart
  constexpr int kTurns = 80;
  constexpr double kClose = 1e-12;
  if (so <= at(kLeast).so) return so / at(kLeast).so * kLeast;
  double low = std::log(kLeast / (1.0 - kLeast));  // of ln(eps/(1 - eps)), in which ln So is
  double high = -low;                              // nearly straight
  const auto gap = [&](double x) { return std::log(at(1.0 / (1.0 + std::exp(-x))).so / so); };
  double f_low = gap(low);
  double f_high = gap(high);
  if (f_high <= 0.0) return 1.0 - kLeast;
  double x = low;
  for (int turn = 0; turn < kTurns && high - low > kClose; ++turn) {
    x = turn % 3 == 2 ? 0.5 * (low + high) : high - f_high * (high - low) / (f_high - f_low);
    const double f = gap(x);
    if (std::abs(f) < kClose) break;
    (f < 0.0 ? low : high) = x;
    (f < 0.0 ? f_low : f_high) = f;
  }
  return 1.0 / (1.0 + std::exp(-x));
}

}  // namespace shellback::fidelity
