#pragma once
/// Decompositions of dense matrices, by Eigen: here, because each takes a compiler longer than the
/// law that asks for it.
#include "core/eigen.hpp"

namespace shellback {

struct SymmetricModes {
  Eigen::VectorXd values;   ///< ascending, unit of the matrix
  Eigen::MatrixXd vectors;  ///< orthonormal columns [-]
};
/// A = V diag(values) V^T of a symmetric matrix, whose lower triangle is read.
[[nodiscard]] SymmetricModes symmetric_modes(const Eigen::MatrixXd& A);

/// A = U diag(values) V^T with orthonormal columns and values that fall.
struct ThinSvd {
  Eigen::MatrixXd U;
  Eigen::VectorXd values;
  Eigen::MatrixXd V;
};
[[nodiscard]] ThinSvd thin_svd(const Eigen::MatrixXd& A);

/// x of the smallest |A x - b|, and of these the smallest |x|.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// Largest |eigenvalue| of a square matrix.
[[nodiscard]] double spectral_radius(const Eigen::MatrixXd& A);

}  // namespace shellback
