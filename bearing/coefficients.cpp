#include "bearing/coefficients.hpp"

#include <cmath>

#include "core/bracketed_root.hpp"
#include "core/constants.hpp"

namespace shellback::bearing {

Matrix2 forces_of(const Matrix4& m) { return {{{m[0][0], m[0][1]}, {m[1][0], m[1][1]}}}; }

Matrix2 in_axes(const Matrix2& m, double angle, int turn) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const Matrix2 axis{{{c, s}, {-turn * s, turn * c}}};
  Matrix2 out{};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      for (int k = 0; k < 2; ++k) {
        for (int l = 0; l < 2; ++l) out[i][j] += axis[i][k] * m[k][l] * axis[j][l];
      }
    }
  }
  return out;
}

namespace {

constexpr int kSamples =
    1200;  ///< up to `highest`: 200 a turn of phase of oil that lags by two turns

/// (4), free of the pole that kappa has where the trace is real.
struct AtFrequency {
  double nu;
  std::complex<double> trace, det;
  [[nodiscard]] double kappa() const { return det.imag() / trace.imag(); }
  /// g Im(tr Z)^2/nu^2.
  [[nodiscard]] double g() const {
    const double t = trace.imag() / nu;
    const double d = det.imag() / nu;
    return d * d - d * t * trace.real() + t * t * det.real();
  }
};

AtFrequency at_frequency(const Impedance& impedance, double nu) {
  const ComplexMatrix2 Z = impedance(nu);
  return {nu, Z[0][0] + Z[1][1], Z[0][0] * Z[1][1] - Z[0][1] * Z[1][0]};
}

}  // namespace

WhirlThreshold whirl_threshold(const Impedance& Z, double highest) {
  WhirlThreshold w{WhirlVerdict::always_stable, INFINITY};
  const auto g = [&](double nu) { return at_frequency(Z, nu).g(); };
  AtFrequency last = at_frequency(Z, highest / kSamples);
  double turned = std::arg(last.det);
  for (int k = 2; k <= kSamples; ++k) {
    const AtFrequency next = at_frequency(Z, highest * k / kSamples);
    turned += std::arg(next.det / last.det);
    if ((last.g() < 0.0) != (next.g() < 0.0)) {
      const double narrow = 1e-9 * highest;
      const double nu =
          bracketed_root(g, {last.nu, last.g()}, {next.nu, next.g()}, {0.0, narrow}).at.x;
      const double kappa = at_frequency(Z, nu).kappa();
      if (kappa > 0.0 && kappa / (nu * nu) < w.critical_mass) {
        w = {WhirlVerdict::threshold, kappa / (nu * nu), nu};
      }
    }
    last = next;
  }
  const ComplexMatrix2 K = Z(0.0);
  const double still = (K[0][0] * K[1][1] - K[0][1] * K[1][0]).real();
  const bool stable = still > 0.0 && turned > 0.0 && turned < 2.0 * kPi;  // without mass
  return stable ? w : WhirlThreshold{WhirlVerdict::never_stable, 0.0};
}

}  // namespace shellback::bearing
