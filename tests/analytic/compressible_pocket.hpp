#pragma once
/// Infinitely wide slider with a pocket, Barus oil whose density follows the pressure.
///
/// The scene of tests/analytic/pocket_slider.hpp with the mass flow per width m constant where the
/// film is full:
///
///   dp/dx = 12 eta0 exp(alpha p)/h^3 (U h/2 - m/rho(p)),   rho = rho0 (C1 + C2 p)/(C1 + p)
///
/// The film ruptures at the mouth of the pocket (p(a) = 0), which fixes m from the first land, and
/// reforms with p = 0 where the pressure meets, at the pocket's end, the one that the last land
/// asks for. Classical Runge-Kutta along x, bisection for m and the front: 1e-9 of the peak.
/// Written down here from Reynolds' equation, with nothing of the program's. Dimensions: header of
/// validation/data/bertocchi_2013_pocket_2d.csv.
#include <cmath>

namespace shellback::analytic {

struct CompressiblePocket {
  double C1 = 2.22e9, C2 = 1.66;                                // [Pa], [-]; of the source
  double length = 0.02, h_in = 1.1e-6, h_out = 1.0e-6;          // [m]
  double pocket_from = 0.004, pocket_to = 0.010, depth = 4e-7;  // [m]
  double eta0 = 0.01, alpha = 1.2e-8, speed = 1.0;              // [Pa s], [1/Pa], [m/s]
  double p_ambient = 1e5;                                       // above cavitation [Pa]

  /// rho/rho0 [-].
  [[nodiscard]] double swell(double p) const { return (C1 + C2 * p) / (C1 + p); }
  [[nodiscard]] double slope(double x, double p, bool pocket, double flow) const {
    const double h = h_in - (h_in - h_out) * x / length + (pocket ? depth : 0.0);
    const double drive = 0.5 * speed * h - flow / swell(p);
    return 12.0 * eta0 * std::exp(alpha * p) / (h * h * h) * drive;
  }
  /// Pressure at `to` with `p` at `from`, within one piece; flow m/rho0 per width [m2/s].
  [[nodiscard]] double pressure(double from, double to, double p, bool pocket, double flow) const {
    constexpr int kSteps = 2000;
    const double dx = (to - from) / kSteps;
    for (int k = 0; k < kSteps; ++k) {
      const double x = from + k * dx;
      const double k1 = slope(x, p, pocket, flow);
      const double k2 = slope(x + 0.5 * dx, p + 0.5 * dx * k1, pocket, flow);
      const double k3 = slope(x + 0.5 * dx, p + 0.5 * dx * k2, pocket, flow);
      const double k4 = slope(x + dx, p + dx * k3, pocket, flow);
      p += dx / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    return p;
  }
  /// m/rho0 per width [m2/s]: the more flows, the lower the pressure at the pocket's mouth.
  [[nodiscard]] double flow() const {
    double low = 0.5 * speed * h_out, high = 0.5 * speed * h_in;
    for (int k = 0; k < 60; ++k) {
      const double q = 0.5 * (low + high);
      (pressure(0.0, pocket_from, p_ambient, false, q) > 0.0 ? low : high) = q;
    }
    return 0.5 * (low + high);
  }
  /// The largest pressure, at the pocket's end [Pa]: from the outlet upstream.
  [[nodiscard]] double peak() const {
    return pressure(length, pocket_to, p_ambient, false, flow());
  }
  /// Where the film reforms [m].
  [[nodiscard]] double reformation() const {
    const double q = flow(), wanted = peak();
    double low = pocket_from, high = pocket_to;
    for (int k = 0; k < 60; ++k) {
      const double x = 0.5 * (low + high);
      (pressure(x, pocket_to, 0.0, true, q) > wanted ? low : high) = x;
    }
    return 0.5 * (low + high);
  }
};

}  // namespace shellback::analytic
