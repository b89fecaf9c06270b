#include "bearing/over_time/cycle_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

double magnitude(const LoadCycle& c, std::size_t row) { return std::hypot(c.x[row], c.y[row]); }

/// The row that follows, in the next period if need be, and the time until then.
struct Next {
  std::size_t row;
  double dt;
};

Next next_of(const LoadCycle& c, std::size_t row) {
  if (row + 1 < c.t.size()) return {row + 1, c.t[row + 1] - c.t[row]};
  return c.repeats() ? Next{0, c.period - c.t[row] + c.t[0]} : Next{row, 0.0};
}

/// Smallest magnitude on the straight line from a row to the next. A jump takes no time: only its
/// ends count.
double smallest_between(const LoadCycle& c, std::size_t a) {
  const auto [b, dt] = next_of(c, a);
  const double dx = c.x[b] - c.x[a];
  const double dy = c.y[b] - c.y[a];
  const double square = dx * dx + dy * dy;
  if (dt <= 0.0 || square <= 0.0) return std::min(magnitude(c, a), magnitude(c, b));
  const double part = std::clamp(-(c.x[a] * dx + c.y[a] * dy) / square, 0.0, 1.0);
  return std::hypot(c.x[a] + part * dx, c.y[a] + part * dy);
}

double speed(const LoadCycle& c, std::size_t row, double omega) {
  return c.omega.empty() ? omega : c.omega[row];
}

/// Integral of sqrt(s^2 + q^2) over s from 0, q not negative.
double length_integral(double s, double q) {
  return 0.5 * (s * std::hypot(s, q) + (q > 0.0 ? q * q * std::asinh(s / q) : 0.0));
}

/// Mean of the magnitude along the straight line from (ax, ay) to (bx, by), at distance q from 0.
double mean_magnitude(double ax, double ay, double bx, double by) {
  const double dx = bx - ax, dy = by - ay;
  const double length = std::hypot(dx, dy);
  const double ends = 0.5 * (std::hypot(ax, ay) + std::hypot(bx, by));
  if (length <= kRoundOff * ends) return ends;
  const double from = (ax * dx + ay * dy) / length, till = (bx * dx + by * dy) / length;
  const double q = std::abs(ax * by - ay * bx) / length;
  return (length_integral(till, q) - length_integral(from, q)) / length;
}

}  // namespace

CycleNumbers cycle_numbers(const LoadCycle& cycle, double omega) {
  EXPECTS(!cycle.t.empty() && cycle.x.size() == cycle.t.size() && cycle.y.size() == cycle.t.size());
  const LoadCycle c = as_lines(cycle);
  CycleNumbers n;
  n.smallest = magnitude(c, 0);
  double time = 0.0;
  double x = 0.0;
  double y = 0.0;
  for (std::size_t a = 0; a < c.t.size(); ++a) {
    const double load = magnitude(c, a);
    if (load > n.largest) {
      n.largest = load;
      n.at = c.t[a];
      n.angle = std::atan2(c.y[a], c.x[a]);
    }
    n.smallest = std::min(n.smallest, smallest_between(c, a));
    n.largest_speed = std::max(n.largest_speed, std::abs(speed(c, a, omega)));
    const auto [b, dt] = next_of(c, a);
    time += dt;
    n.mean += dt * mean_magnitude(c.x[a], c.y[a], c.x[b], c.y[b]);
    x += 0.5 * dt * (c.x[a] + c.x[b]);
    y += 0.5 * dt * (c.y[a] + c.y[b]);
    const double from = speed(c, a, omega);
    const double till = speed(c, b, omega);
    n.mean_speed += 0.5 * dt * (from + till);
    n.mean_sliding += dt * mean_magnitude(from, 0.0, till, 0.0);
  }
  if (n.angle < 0.0) n.angle += 2.0 * kPi;
  n.mean = time > 0.0 ? n.mean / time : n.largest;
  n.net = time > 0.0 ? std::hypot(x, y) / time : n.largest;
  n.mean_speed = time > 0.0 ? n.mean_speed / time : speed(c, 0, omega);
  n.mean_sliding = time > 0.0 ? n.mean_sliding / time : std::abs(speed(c, 0, omega));
  n.length = c.length();
  return n;
}

LoadGiven largest_load(const LoadCycle& cycle) {
  const CycleNumbers n = cycle_numbers(cycle, 0.0);
  return {n.largest, n.angle};
}

std::optional<std::size_t> vanishing_load(const LoadCycle& cycle) {
  const double limit = kVanishingLoad * largest_load(cycle).force;
  const LoadCycle lines = as_lines(cycle);
  const std::size_t lines_of_row = lines.t.size() / cycle.t.size();
  for (std::size_t line = 0; line < lines.t.size(); ++line) {
    if (smallest_between(lines, line) < limit) return line / lines_of_row;
  }
  return std::nullopt;
}

}  // namespace shellback::bearing
