// Modes of a surface's impedance: they solve what they are defined by.
#include "thermal/impedance_modes.hpp"

#include <catch2/catch.hpp>

using namespace shellback;

TEST_CASE("ModesOfAnImpedanceAreItsOwnOnUnevenCells") {
  // Fluxes of cells spread as exp(-|z - z'|): a symmetric kernel over cells of different lengths.
  constexpr int kCells = 7;
  Eigen::VectorXd dz(kCells), z(kCells);
  double at = 0.0;
  for (int j = 0; j < kCells; ++j) {
    dz[j] = 1e-3 * (1.0 + 0.5 * (j % 3));
    z[j] = at + 0.5 * dz[j];
    at += dz[j];
  }
  Eigen::MatrixXd Z(kCells, kCells);
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) Z(i, j) = std::exp(-std::abs(z[i] - z[j]) / at) * dz[j];
  }
  const thermal::ImpedanceModes modes = thermal::impedance_modes(Z, dz);
  const double size = Z.norm();
  CHECK((Z * modes.V - modes.V * modes.lambda.asDiagonal()).norm() < 1e-12 * size * modes.V.norm());
  const Eigen::MatrixXd one = modes.V.transpose() * dz.asDiagonal() * modes.V;
  CHECK((one - Eigen::MatrixXd::Identity(kCells, kCells)).norm() < 1e-12);
  for (int k = 1; k < kCells; ++k) CHECK(modes.lambda[k] >= modes.lambda[k - 1]);
  CHECK(modes.lambda[0] > 0.0);  // the kernel is positive
}
