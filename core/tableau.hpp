#pragma once
/// One-step methods of second order, diagonally implicit and stiffly accurate.
#include <array>
#include <numbers>

namespace shellback {

/// A diagonally implicit Runge-Kutta method; the weights of its result are its last row.
struct Tableau {
  int stages = 0;
  bool explicit_first = false;  ///< the first stage is the beginning of the step
  std::array<double, 3> c{};
  std::array<std::array<double, 3>, 3> a{};
  std::array<double, 3> other{};  ///< weights of the result that is compared: error estimate
  [[nodiscard]] double b(int i) const { return a[stages - 1][i]; }
};

/// Trapezoidal rule, then BDF2: one step with two solves. Source: methods 4, textbook.
[[nodiscard]] inline Tableau tr_bdf2() {
  const double d = 1.0 - std::numbers::sqrt2 / 2.0;
  const double w = std::numbers::sqrt2 / 4.0;
  return {3,
          true,
          {0.0, 2.0 * d, 1.0},
          {{{0.0, 0.0, 0.0}, {d, d, 0.0}, {w, w, d}}},
          {(1.0 - w) / 3.0, (3.0 * w + 1.0) / 3.0, d / 3.0}};
}

/// L-stable from the first stage on: at a start and behind a jump. Source: textbook (Alexander).
[[nodiscard]] inline Tableau sdirk2() {
  const double g = 1.0 - std::numbers::sqrt2 / 2.0;
  // Compared with the first stage carried on in a straight line: of first order, a safe bound.
  return {2, false, {g, 1.0, 0.0}, {{{g, 0.0, 0.0}, {1.0 - g, g, 0.0}, {}}}, {1.0, 0.0, 0.0}};
}

}  // namespace shellback
