#include "fidelity/bearing_table.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include "core/contract.hpp"
#include "fidelity/closed_forms.hpp"

namespace shellback::fidelity {
namespace {

using Numbers = std::array<double, 5>;

/// Side flow over eps falls with the width as this does; the narrow bearing's below the table.
double side_scale(double b) { return 1.0 / (1.0 + std::max(b, 0.05)); }

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
  std::vector<double> v;         ///< ln b
  std::vector<double> u;         ///< -ln(1 - eps)
  std::vector<Numbers> numbers;  ///< smoothed, index v * u.size() + u
};

Table read_table() {
  Table t;
  std::istringstream text(plain_bearing_table());
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'B') continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream cells(line);
    double b = 0.0, eps = 0.0, degrees = 0.0;
    BearingNumbers n;
    cells >> b >> eps >> n.so >> degrees >> n.couette >> n.side >> n.pressure;
    n.attitude = degrees * kPi / 180.0;
    if (t.v.empty() || std::log(b) != t.v.back()) t.v.push_back(std::log(b));
    if (t.v.size() == 1) t.u.push_back(-std::log1p(-eps));
    t.numbers.push_back(smoothed(eps, b, n));
  }
  ENSURES(t.numbers.size() == t.v.size() * t.u.size());
  return t;
}

const Table& table() {
  static const Table once = read_table();
  return once;
}

/// Slope at node k of a monotone cubic through y over x (Fritsch and Carlson's condition in
/// Brodlie's harmonic form, textbook): 0 at an extremum, a weighted harmonic mean of the secants
/// elsewhere; the end nodes take the secant.
double slope_at(const std::vector<double>& x, const std::vector<double>& y, std::size_t k) {
  const auto secant = [&](std::size_t a) { return (y[a + 1] - y[a]) / (x[a + 1] - x[a]); };
  if (k == 0) return secant(0);
  if (k + 1 == x.size()) return secant(k - 1);
  const double before = secant(k - 1), after = secant(k);
  if (before * after <= 0.0) return 0.0;
  const double h0 = x[k] - x[k - 1], h1 = x[k + 1] - x[k];
  return 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / before + (h1 + 2.0 * h0) / after);
}

/// The monotone cubic through y over x; beyond the ends the end values.
double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  at = std::clamp(at, x.front(), x.back());
  const auto above = std::upper_bound(x.begin(), x.end(), at) - x.begin();
  const auto k = std::clamp<std::size_t>(above, 1, x.size() - 1);
  const double h = x[k] - x[k - 1];
  const double t = (at - x[k - 1]) / h, s = 1.0 - t;
  return s * s * (1.0 + 2.0 * t) * y[k - 1] + t * t * (1.0 + 2.0 * s) * y[k] +
         h * t * s * (s * slope_at(x, y, k - 1) - t * slope_at(x, y, k));
}

}  // namespace

BearingCurve::BearingCurve(double b) : b_(b) {
  EXPECTS(b > 0.0);
  const Table& t = table();
  std::vector<double> column(t.v.size());
  for (std::size_t number = 0; number < ratios_.size(); ++number) {
    for (std::size_t e = 0; e < t.u.size(); ++e) {
      for (std::size_t w = 0; w < t.v.size(); ++w) {
        column[w] = t.numbers[w * t.u.size() + e][number];
      }
      ratios_[number].push_back(interpolated(t.v, column, std::log(b)));
    }
  }
}

BearingNumbers BearingCurve::at(double eps) const {
  EXPECTS(eps > 0.0 && eps < 1.0);
  const Table& t = table();
  const double u = -std::log1p(-eps);
  Numbers s{};
  for (std::size_t k = 0; k < s.size(); ++k) s[k] = interpolated(t.u, ratios_[k], u);
  s[4] += 0.5 * std::max(0.0, u - t.u.back());  // p_max/p ~ (1 - eps)^(-1/2)
  return restored(eps, b_, s);
}

}  // namespace shellback::fidelity
