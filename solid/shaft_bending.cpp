#include "solid/shaft_bending.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::solid {
namespace {

struct Beam {
  double EI;    ///< [N m2]
  double kGA;   ///< [N]
  double span;  ///< L [m]
  double a;     ///< l/2 [m]
  double beta;  ///< (3) [-]

  /// (1): per unit net force [m/N].
  [[nodiscard]] double by_force(double z) const {
    z = std::abs(z);
    const double supports = (span * z * z / 4.0 - z * z * z / 6.0) / 2.0;
    const double body =
        (a * a * z * z / 2.0 - a * z * z * z / 3.0 + z * z * z * z / 12.0) / (4.0 * a);
    return -(supports - body) / EI - z * z / (4.0 * a * kGA);
  }
  /// (2): per unit net moment [1/N].
  [[nodiscard]] double by_moment(double z) const {
    const double z3 = z * z * z, a3 = a * a * a;
    const double bent =
        ((1.0 - beta) * 3.0 / (4.0 * a) + beta / (2.0 * a) - 1.0 / span) * z3 / 6.0 -
        (1.0 - beta) * z3 * z * z / (80.0 * a3);
    return -bent / EI - (1.0 - beta) * z3 / (4.0 * a3 * kGA);
  }
};

/// E I of a solid shaft [N m2].
double stiffness(double R, const Material& m) {
  return m.youngs_modulus * 0.25 * kPi * R * R * R * R;
}

}  // namespace

double free_shaft_shift(double radius, double width, const Material& m, double length) {
  EXPECTS(length >= width);
  const double a = 0.5 * length, c = 0.5 * width, rest = a - c;
  const double loaded = c * c * (c * c / 20.0 + c * rest / 8.0 + rest * rest / 12.0) / a;
  return (a * a * a / 20.0 - loaded) / (2.0 * stiffness(radius, m));
}

Eigen::MatrixXd shaft_bending(const FilmGrid& g, const Material& m, double span, double length) {
  EXPECTS(span >= g.width && length >= g.width);
  const double R = g.radius;
  const Beam beam{stiffness(R, m),
                  m.youngs_modulus * kPi * R * R * 3.0 / (7.0 + 6.0 * m.poisson_ratio), span,
                  0.5 * length, 3.0 * R * R / (3.0 * R * R + length * length)};
  Eigen::MatrixXd C(g.nz, g.nz);
  for (int j = 0; j < g.nz; ++j) {
    for (int k = 0; k < g.nz; ++k) {
      const double force = beam.by_force(g.z[j]) + beam.by_force(g.z[k]);
      const double moment =
          g.half ? 0.0 : beam.by_moment(g.z[j]) * g.z[k] + g.z[j] * beam.by_moment(g.z[k]);
      C(j, k) = kPi * R * g.dz[k] * (g.multiplicity() * force + moment);
    }
  }
  return C;
}

}  // namespace shellback::solid
