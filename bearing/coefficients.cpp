#include "bearing/coefficients.hpp"

#include <cmath>

namespace shellback::bearing {
namespace {

double determinant(const Matrix2& m) { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; }

}  // namespace

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

WhirlThreshold whirl_threshold(const Matrix2& K, const Matrix2& C) {
  WhirlThreshold w;
  const double trace = C[0][0] + C[1][1];
  const double kappa =
      (K[0][0] * C[1][1] + K[1][1] * C[0][0] - K[0][1] * C[1][0] - K[1][0] * C[0][1]) / trace;
  const double damping = determinant(C);
  if (!(trace > 0.0 && kappa > 0.0 && damping > 0.0 && determinant(K) > 0.0)) {
    w.verdict = WhirlVerdict::never_stable;
    w.critical_mass = 0.0;
    return w;
  }
  const double rest = (K[0][0] - kappa) * (K[1][1] - kappa) - K[0][1] * K[1][0];
  if (!(rest > 0.0)) {
    w.verdict = WhirlVerdict::always_stable;
    w.critical_mass = INFINITY;
    return w;
  }
  w.critical_mass = kappa * damping / rest;
  w.whirl_frequency = std::sqrt(rest / damping);
  return w;
}

}  // namespace shellback::bearing
