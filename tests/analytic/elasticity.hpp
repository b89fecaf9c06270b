#pragma once
/// Closed-form elastic solutions (plane strain) for the tests of solid/.
#include <Eigen/Dense>
#include <cmath>

namespace shellback::analytic {

enum class OuterEdge { free, held };

/// Radial displacement of the bore of a ring a..b under pressure cos(n phi), n >= 2, per unit
/// pressure [m/Pa]. Airy function sum A_k r^k cos(n phi), k in {n, n+2, -n, 2-n} (Michell,
/// textbook); positive powers are scaled with b, negative ones with a.
inline double ring_compliance(int n, double a, double b, double youngs, double nu, OuterEdge edge) {
  const double two_g = youngs / (1.0 + nu), kap = 3.0 - 4.0 * nu;
  const int power[4] = {n, n + 2, -n, 2 - n};
  const double radial[4] = {-1.0 * n, kap - n - 1, 1.0 * n, kap + n - 1};
  const double hoop[4] = {1.0 * n, kap + n + 1, 1.0 * n, -(kap - n + 1)};
  const auto scaled = [&](int q, double r) {  // (r / scale)^(k - 2)
    return std::pow(r / (power[q] > 0 ? b : a), power[q] - 2);
  };
  Eigen::Matrix4d m;
  for (int q = 0; q < 4; ++q) {
    const double k = power[q];
    m(0, q) = (k - n * n) * scaled(q, a);
    m(1, q) = n * (k - 1) * scaled(q, a);
    if (edge == OuterEdge::free) {
      m(2, q) = (k - n * n) * scaled(q, b);
      m(3, q) = n * (k - 1) * scaled(q, b);
    } else {
      m(2, q) = radial[q] * scaled(q, b);
      m(3, q) = hoop[q] * scaled(q, b);
    }
  }
  const Eigen::Vector4d c = m.fullPivLu().solve(Eigen::Vector4d(-1.0, 0.0, 0.0, 0.0));
  double u = 0.0;
  for (int q = 0; q < 4; ++q) u += c(q) * radial[q] * scaled(q, a) * a / two_g;
  return u;
}

/// The same for n = 0, outer surface free (Lame, textbook).
inline double ring_lame_free(double a, double b, double youngs, double nu) {
  return (1.0 + nu) * a * ((1.0 - 2.0 * nu) * a * a + b * b) / (youngs * (b * b - a * a));
}
/// The same for n = 0, outer surface fixed: u = A r + B / r with u(b) = 0.
inline double ring_lame_held(double a, double b, double youngs, double nu) {
  return (1.0 + nu) * (b * b - a * a) / (a * youngs * (1.0 / (1.0 - 2.0 * nu) + b * b / (a * a)));
}

/// Inward displacement of the surface of a solid cylinder under pressure cos(n phi), n >= 2, per
/// unit pressure [m/Pa]: the two regular Michell terms r^n, r^(n+2), free of shear at r = a.
inline double cylinder_compliance(int n, double a, double youngs, double nu) {
  const double two_g = youngs / (1.0 + nu), kap = 3.0 - 4.0 * nu;
  // With a = 1, B = -(n - 1), A = n + 1: tau = n (n - 1) A + n (n + 1) B = 0 and
  // sigma_rr = (n - n^2) A + (n + 2 - n^2) B, which is scaled to the unit pressure.
  const double cap_a = n + 1.0, cap_b = 1.0 - n;
  const double sigma = (n - n * n) * cap_a + (n + 2 - n * n) * cap_b;
  const double u = (-n * cap_a + (kap - n - 1) * cap_b) * a / two_g;  // outward
  return u / sigma;  // pressure 1 is sigma_rr = -1, outward -> inward
}

/// Surface deflection of an elastic layer bonded to a rigid base under pressure cos(k x), per
/// unit pressure [m/Pa] (methods 2.4 b, textbook).
inline double bonded_layer(double k, double t, double youngs, double nu) {
  const double x = k * t, kap = 3.0 - 4.0 * nu;
  return 2.0 * (1.0 - nu * nu) / (youngs * k) * (kap * std::sinh(2.0 * x) - 2.0 * x) /
         (kap * std::cosh(2.0 * x) + 2.0 * x * x + 5.0 - 12.0 * nu + 8.0 * nu * nu);
}

/// Deflection of a thin bonded layer per unit pressure, k t -> 0 [m/Pa].
inline double winkler_layer(double t, double youngs, double nu) {
  return t * (1.0 + nu) * (1.0 - 2.0 * nu) / (youngs * (1.0 - nu));
}

}  // namespace shellback::analytic
