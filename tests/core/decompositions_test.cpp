// Decompositions of dense matrices: what they are defined by.
#include "core/decompositions.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace shellback;

namespace {

/// Without symmetry and of full rank.
Eigen::MatrixXd sample(int rows, int cols) {
  Eigen::MatrixXd A(rows, cols);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < cols; ++j) A(i, j) = std::sin(1.0 + 3.0 * i + 5.0 * i * j);
  }
  return A;
}

}  // namespace

TEST_CASE("SymmetricModesAndSingularValuesMakeUpTheirMatrix") {
  const Eigen::MatrixXd A = sample(6, 4);
  const Eigen::MatrixXd S = A.transpose() * A;
  const SymmetricModes modes = symmetric_modes(S);
  const ThinSvd svd = thin_svd(A);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(4, 4);
  CHECK((modes.vectors * modes.values.asDiagonal() * modes.vectors.transpose() - S).norm() < 1e-13);
  CHECK((modes.vectors.transpose() * modes.vectors - one).norm() < 1e-13);
  CHECK((svd.U * svd.values.asDiagonal() * svd.V.transpose() - A).norm() < 1e-13);
  CHECK((svd.U.transpose() * svd.U - one).norm() < 1e-13);
  for (int k = 0; k < 4; ++k) {  // one rises, the other falls
    CHECK(modes.values[k] == Approx(svd.values[3 - k] * svd.values[3 - k]).epsilon(1e-10));
  }
}

TEST_CASE("LeastSquaresLeaveNothingThatAColumnCouldTake") {
  Eigen::MatrixXd A = sample(6, 3);
  const Eigen::VectorXd b = sample(6, 4).col(3);  // no column of A
  CHECK((A.transpose() * (A * least_squares(A, b) - b)).norm() < 1e-13);
  A.col(2) = A.col(1);  // which of the two takes it is open: each a half
  const Eigen::VectorXd x = least_squares(A, b);
  CHECK((A.transpose() * (A * x - b)).norm() < 1e-13);
  CHECK(x[1] == Approx(x[2]).epsilon(1e-12));
}

TEST_CASE("TheSpectralRadiusOfATurnIsItsStretch") {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3, 3);  // complex eigenvalues 1.5 exp(+-0.4 i), and 1.2
  A.topLeftCorner(2, 2) << std::cos(0.4), -std::sin(0.4), std::sin(0.4), std::cos(0.4);
  A *= 1.5;
  A(2, 2) = -1.2;
  A(0, 2) = 7.0;
  CHECK(spectral_radius(A) == Approx(1.5).epsilon(1e-12));
}
