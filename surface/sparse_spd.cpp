#include "surface/sparse_spd.hpp"

#include <Eigen/CholmodSupport>
#include <stdexcept>

namespace shellback::surface {

// Simplicial, not supernodal: no threads of OpenMP within ours (their barriers stall on a busy
// machine), the same digits for any number of threads, and no slower on maps with the plain BLAS.
struct SparseSpd::Factor {
  Eigen::CholmodSimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky;
};

SparseSpd::SparseSpd(int rows, const std::vector<Eigen::Triplet<double>>& entries)
    : factor_(std::make_unique<Factor>()) {
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_->cholesky.compute(matrix);
  if (factor_->cholesky.info() != Eigen::Success) {
    throw std::runtime_error("CHOLMOD: the matrix is not positive definite");
  }
}

SparseSpd::~SparseSpd() = default;

Eigen::VectorXd SparseSpd::solve(const Eigen::VectorXd& rhs) const {
  return factor_->cholesky.solve(rhs);
}

}  // namespace shellback::surface
