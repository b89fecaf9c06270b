#pragma once
/// A plain bearing under a firing pulse, over two turns of its journal.
#include <functional>

#include "tests/bearing/solved.hpp"

namespace shellback::bearing::tests {

using Load = std::array<double, 2>;

/// `load` of the crank angle over two turns of the journal, in rows of 5 degrees, as a spline.
inline LoadCycle over_two_turns(const Case& c, const std::function<Load(double)>& load) {
  constexpr int kRows = 144;
  LoadCycle cycle;
  cycle.crank_speed = std::abs(c.operation.omega);
  cycle.period = 4.0 * kPi / cycle.crank_speed;
  for (int k = 0; k < kRows; ++k) {
    const double angle = 4.0 * kPi * k / kRows;
    cycle.t.push_back(angle / cycle.crank_speed);
    const Load w = load(angle);
    cycle.x.push_back(w[0]);
    cycle.y.push_back(w[1]);
  }
  cycle.interpolation = LoadInterpolation::periodic_spline;
  cycle.journal_mass = 0.5;
  return cycle;
}

/// A firing pulse of 6 kN over a turning load of 1 kN.
inline Load pulse(double angle) {
  const double from = std::remainder(angle - 2.0 * kPi, 4.0 * kPi);
  const double fired = 6e3 * std::exp(-from * from / 0.2);
  return {1e3 * std::cos(angle), 1e3 * std::sin(angle) - fired};
}

inline Case pulsed_case() {
  Case c = plain_case();
  c.supplies[0].pressure = 1e5;
  c.supplies[0].arc = 20.0 * kDegree;
  c.supplies[0].length = 0.02;
  c.cycle = over_two_turns(c, pulse);
  return c;
}

}  // namespace shellback::bearing::tests
