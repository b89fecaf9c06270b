#include "bearing/over_time/cycle_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

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

/// Of a straight line from `a` to `b`.
double mean_magnitude(double a, double b) {
  if (a * b >= 0.0) return 0.5 * std::abs(a + b);
  return 0.5 * (a * a + b * b) / std::abs(b - a);
}

}  // namespace

CycleNumbers cycle_numbers(const LoadCycle& c, double omega) {
  EXPECTS(!c.t.empty() && c.x.size() == c.t.size() && c.y.size() == c.t.size());
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
    n.mean += 0.5 * dt * (load + magnitude(c, b));
    x += 0.5 * dt * (c.x[a] + c.x[b]);
    y += 0.5 * dt * (c.y[a] + c.y[b]);
    const double from = speed(c, a, omega);
    const double till = speed(c, b, omega);
    n.mean_speed += 0.5 * dt * (from + till);
    n.mean_sliding += dt * mean_magnitude(from, till);
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
  for (std::size_t row = 0; row < cycle.t.size(); ++row) {
    if (smallest_between(cycle, row) < limit) return row;
  }
  return std::nullopt;
}

}  // namespace shellback::bearing
