#include "fidelity/mobility_table.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/table_rows.hpp"
#include "fidelity/closed_forms.hpp"

namespace shellback::fidelity {
namespace {

double mobility_bridge(double eps, double alpha, double b) {
  return narrow_mobility(eps, alpha, b) + wide_mobility(eps, alpha);
}

/// M_across over M_along is about -4/pi times this (Booker's closed form).
double lean(double eps, double alpha) {
  return eps * std::sin(alpha) / (1.0 - eps * std::cos(alpha));
}

/// Angle at which the sweep is s, 0 ... pi.
double angle_at(double s, double eps) {
  double low = 0.0, high = kPi;
  for (int k = 0; k < 60; ++k) {  // to rounding
    const double middle = 0.5 * (low + high);
    (sweep_of(middle, eps) < s ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

using MobilityNumbers = std::array<double, 4>;

struct MobilityTable {
  std::vector<double> v;                 ///< ln b
  std::vector<double> u;                 ///< -ln(1 - eps)
  std::vector<double> s;                 ///< sweep
  std::vector<MobilityNumbers> numbers;  ///< as ratios in which they are smooth, index (v, u, s)
};

void keep_new(std::vector<double>& nodes, double x) {
  if (std::none_of(nodes.begin(), nodes.end(), [&](double old) { return old == x; })) {
    nodes.push_back(x);
  }
}

/// The table's numbers as ratios in which they are smooth.
std::vector<MobilityNumbers> smoothed(const MobilityTable& t, const std::vector<Mobility>& rows) {
  std::vector<MobilityNumbers> all(rows.size());
  const std::size_t each = t.u.size() * t.s.size();
  for (std::size_t k = 0; k < each; ++k) {
    const double eps = -std::expm1(-t.u[k / t.s.size()]);
    const double alpha = angle_at(t.s[k % t.s.size()], eps);
    for (std::size_t w = 0; w < t.v.size(); ++w) {
      const Mobility& m = rows[w * each + k];
      const double b = std::exp(t.v[w]);
      all[w * each + k] = {std::log(m.along / mobility_bridge(eps, alpha, b)),
                           m.across / (m.along * lean(eps, alpha)), std::log(m.pressure),
                           std::log(m.side / side_scale(b))};
    }
  }
  return all;
}

MobilityTable read_mobilities() {
  MobilityTable t;
  std::vector<Mobility> rows;
  for (const std::vector<double>& row : table_rows(bearing_mobility_table())) {
    keep_new(t.v, std::log(row[0]));
    keep_new(t.u, -std::log1p(-row[1]));
    keep_new(t.s, kPi * row[2]);
    rows.push_back({row[3], row[4], row[5], row[6]});
  }
  t.numbers = smoothed(t, rows);
  ENSURES(t.numbers.size() == t.v.size() * t.u.size() * t.s.size());
  return t;
}

const MobilityTable& mobilities() {
  static const MobilityTable once = read_mobilities();
  return once;
}

/// Slopes at the nodes x of the parabolas through three neighbours, at the ends of the first and
/// last three.
std::vector<double> slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> d(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t m = std::clamp<std::size_t>(k, 1, n - 2);
    const double left = (y[m] - y[m - 1]) / (x[m] - x[m - 1]);
    const double right = (y[m + 1] - y[m]) / (x[m + 1] - x[m]);
    const double curve = (right - left) / (x[m + 1] - x[m - 1]);
    d[k] = left + curve * (2.0 * x[k] - x[m - 1] - x[m]);
  }
  return d;
}

/// The piece of x that holds `at`, and the four weights of a cubic there: of the values and the
/// slopes at its ends.
struct Piece {
  std::size_t k = 0;
  double low = 0.0, high = 0.0, low_slope = 0.0, high_slope = 0.0;
};

/// Beyond the ends the end values.
Piece piece(const std::vector<double>& x, double at) {
  at = std::clamp(at, x.front(), x.back());
  const auto above = std::upper_bound(x.begin(), x.end(), at) - x.begin();
  const auto k = std::clamp<std::size_t>(static_cast<std::size_t>(above), 1, x.size() - 1);
  const double h = x[k] - x[k - 1];
  const double t = (at - x[k - 1]) / h, s = 1.0 - t;
  return {k - 1, s * s * (1.0 + 2.0 * t), t * t * (1.0 + 2.0 * s), h * t * s * s, -h * t * t * s};
}

double value(const Piece& p, double low, double high, double low_slope, double high_slope) {
  return p.low * low + p.high * high + p.low_slope * low_slope + p.high_slope * high_slope;
}

}  // namespace

double narrow_mobility(double eps, double alpha, double b) {
  const double room = 1.0 - eps * std::cos(alpha);
  return room * room * std::sqrt(room) / (kPi * b * b);
}

double wide_mobility(double eps, double alpha) {
  const double r = 1.0 - eps * eps, c = std::cos(alpha), s = std::sin(alpha);
  return std::sqrt(r) / (6.0 * kPi) * (r * c * c + (1.0 + 0.5 * eps * eps) * s * s);
}

double sweep_of(double alpha, double eps) {
  const double stretch = std::sqrt((1.0 + eps) / (1.0 - eps));
  return 0.5 * alpha + std::atan(stretch * std::tan(0.5 * alpha));
}

MobilityMap::MobilityMap(double b) : b_(b) {
  EXPECTS(b > 0.0);
  const MobilityTable& t = mobilities();
  const std::size_t nu = t.u.size(), ns = t.s.size();
  const Piece p = piece(t.v, std::log(b));
  nodes_.resize(nu * ns);
  std::vector<double> column(t.v.size()), along_u(nu), along_s(ns);
  for (std::size_t n = 0; n < 4; ++n) {
    for (std::size_t k = 0; k < nu * ns; ++k) {
      for (std::size_t w = 0; w < t.v.size(); ++w) column[w] = t.numbers[w * nu * ns + k][n];
      const auto d = slopes(t.v, column);
      nodes_[k].f[n] = value(p, column[p.k], column[p.k + 1], d[p.k], d[p.k + 1]);
    }
    const auto differentiate = [&](Numbers Node::*of, Numbers Node::*slope, bool by_u) {
      const std::size_t lines = by_u ? ns : nu, along = by_u ? nu : ns;
      std::vector<double>& y = by_u ? along_u : along_s;
      for (std::size_t line = 0; line < lines; ++line) {
        const auto node = [&](std::size_t k) { return by_u ? k * ns + line : line * ns + k; };
        for (std::size_t k = 0; k < along; ++k) y[k] = (nodes_[node(k)].*of)[n];
        const auto d = slopes(by_u ? t.u : t.s, y);
        for (std::size_t k = 0; k < along; ++k) (nodes_[node(k)].*slope)[n] = d[k];
      }
    };
    differentiate(&Node::f, &Node::u, true);
    differentiate(&Node::f, &Node::s, false);
    differentiate(&Node::u, &Node::us, false);
  }
}

Mobility MobilityMap::at(double eps, double alpha) const {
  EXPECTS(eps >= 0.0 && eps < 1.0);
  const MobilityTable& t = mobilities();
  const double folded = std::remainder(alpha, 2.0 * kPi);
  const double u = -std::log1p(-eps);
  const Piece pu = piece(t.u, u), ps = piece(t.s, sweep_of(std::abs(folded), eps));
  const Node* low = &nodes_[pu.k * t.s.size() + ps.k];
  const Node* high = low + t.s.size();
  Numbers q;
  for (std::size_t n = 0; n < 4; ++n) {
    const auto on = [&](const Node* at, Numbers Node::*f, Numbers Node::*s) {
      return value(ps, (at[0].*f)[n], (at[1].*f)[n], (at[0].*s)[n], (at[1].*s)[n]);
    };
    q[n] = value(pu, on(low, &Node::f, &Node::s), on(high, &Node::f, &Node::s),
                 on(low, &Node::u, &Node::us), on(high, &Node::u, &Node::us));
  }
  Mobility m;
  m.along = mobility_bridge(eps, folded, b_) * std::exp(q[0]);
  m.across = m.along * lean(eps, folded) * q[1];
  // In a film that is thin against its width p_max/p ~ (1 - eps)^(-1/2), as in a steady one.
  m.pressure = std::exp(q[2] + 0.5 * std::max(0.0, u - t.u.back()));
  m.side = side_scale(b_) * std::exp(q[3]);
  return m;
}

}  // namespace shellback::fidelity
