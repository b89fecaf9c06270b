#pragma once
/// An operator of harmonics, made ready to act on fields over and over.
///
///   u = op_N f + S (op_n - op_N) A f                                                    (1)
///
/// with A and S the analysis and synthesis of core/harmonics.hpp and N the highest harmonic: the
/// part of f above it is treated as the highest, for soft layers whose compliance stays finite.
/// Symmetric for symmetric diag(dz) op_n. Half of an iteration of Newton's method in an elastic
/// film goes into (1): rows are padded to whole registers and factors stand in the order in which
/// they are used (docs/decisions/094).
#include "core/harmonics.hpp"

namespace shellback {

class FieldOperator {
 public:
  /// Of no field.
  FieldOperator() = default;
  /// Square operators of all harmonics of the transform.
  FieldOperator(const Harmonics& harmonics, const HarmonicOperator& op);

  /// (1) of a cell field of any unit.
  [[nodiscard]] Field operator()(const Field& field) const;

 private:
  int rows_ = 0;                   ///< cells of a line along the bearing
  int lines_ = 0;                  ///< of them around it
  int coefficients_ = 0;           ///< of a row
  Eigen::MatrixXd last_;           ///< op_N, padded rows
  Eigen::MatrixXd rest_;           ///< op_n - op_N beside each other, padded rows
  std::vector<double> analysis_;   ///< a block of columns after the other, row by row
  std::vector<double> synthesis_;  ///< the same of its transpose
};

}  // namespace shellback
