#pragma once
/// Infinitely wide converging slider with a pocket, mass-conserving cavitation: exact solution.
///
/// h falls linearly from h_in at 0 to h_out at L, deeper by `depth` in a < x < b; pressure p_a at
/// both ends, cavitation at p = 0. The film ruptures at the mouth of the pocket (p(a) = 0), which
/// fixes the flow Q per width from the first land; it reforms at x_r inside the pocket such that
/// the pressure built up in (x_r, L) comes down to p_a at L. In each piece dp/dx = 6 eta U/h^2 -
/// 12 eta Q/h^3 with h linear: elementary integrals. Derived here from Reynolds' equation; the
/// scene is that of Fowell et al. 2007 (validation/data/pocket_slider_fowell_exact.csv).
#include <cmath>

namespace shellback::analytic {

struct PocketSlider {
  double length = 0.01, h_in = 1.05e-6, h_out = 1.0e-6;         // [m]
  double pocket_from = 0.002, pocket_to = 0.005, depth = 1e-6;  // [m]
  double eta = 0.01, speed = 1.0, p_ambient = 1e5;              // [Pa s], [m/s], [Pa]

  [[nodiscard]] double slope() const { return (h_in - h_out) / length; }
  [[nodiscard]] bool in_pocket(double x) const { return x > pocket_from && x < pocket_to; }
  [[nodiscard]] double gap(double x, bool pocket) const {
    return h_in - slope() * x + (pocket ? depth : 0.0);
  }
  /// Pressure rise from x1 to x2 within one piece at flow Q per width [m2/s].
  [[nodiscard]] double rise(double x1, double x2, bool pocket, double Q) const {
    const double k = slope(), h1 = gap(x1, pocket), h2 = gap(x2, pocket);
    const double inverse_square = (1.0 / h2 - 1.0 / h1) / k;
    const double inverse_cube = (1.0 / (h2 * h2) - 1.0 / (h1 * h1)) / (2.0 * k);
    return 6.0 * eta * speed * inverse_square - 12.0 * eta * Q * inverse_cube;
  }
  /// Flow per width [m2/s]: rise over the first land is -p_ambient; it is linear in Q.
  [[nodiscard]] double flow() const {
    const double at_zero = rise(0.0, pocket_from, false, 0.0);
    const double per_flow = rise(0.0, pocket_from, false, 1.0) - at_zero;
    return (-p_ambient - at_zero) / per_flow;
  }
  /// Where the film reforms [m]: bisection on the pressure at the outlet.
  [[nodiscard]] double reformation() const {
    double low = pocket_from, high = pocket_to;
    for (int k = 0; k < 100; ++k) {
      const double x = 0.5 * (low + high);
      const double outlet =
          rise(x, pocket_to, true, flow()) + rise(pocket_to, length, false, flow());
      (outlet > p_ambient ? low : high) = x;
    }
    return 0.5 * (low + high);
  }
  /// Pressure above cavitation [Pa].
  [[nodiscard]] double pressure(double x) const {
    const double Q = flow(), x_r = reformation();
    if (x <= pocket_from) return p_ambient + rise(0.0, x, false, Q);
    if (x <= x_r) return 0.0;
    if (x <= pocket_to) return rise(x_r, x, true, Q);
    return p_ambient - rise(x, length, false, Q);
  }
};

}  // namespace shellback::analytic
