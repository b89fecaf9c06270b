#pragma once
/// Direct solution with a large sparse symmetric positive definite matrix (CHOLMOD).
#include <Eigen/Sparse>
#include <memory>
#include <vector>

#include "core/eigen.hpp"

namespace shellback::surface {

/// Owns the factor of a matrix.
class SparseSpd {
 public:
  /// Entries at one place add up; both triangles are given. Throws std::runtime_error if the matrix
  /// is not positive definite.
  SparseSpd(int rows, const std::vector<Eigen::Triplet<double>>& entries);
  ~SparseSpd();
  SparseSpd(const SparseSpd&) = delete;
  SparseSpd& operator=(const SparseSpd&) = delete;

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace shellback::surface
