#pragma once
/// Circumferential Fourier series of film fields, on cells of unequal width.
///
///   a_n(j) = 1/pi sum_i f_ij int_cell_i cos(n phi) dphi   (1/2pi for n = 0; b_n with sin)   (1)
///   f_ij   = a_0(j) + sum_n [ a_n(j) <cos n phi>_i + b_n(j) <sin n phi>_i ]                 (2)
///
/// with <.>_i the mean over cell i. (1) is exact for a field constant on each cell, (2) gives cell
/// means. Analysis A and synthesis S obey A = S^T W / pi with W the cell widths, so an operator
/// S C_n A is symmetric with respect to the cell areas whenever diag(dz) C_n is: the work of one
/// pressure on the displacement of another does not depend on their order [textbook].
///
/// A after S is not one: harmonic n returns with the factor (sin(x)/x)^2, x = n dphi / 2, the
/// price of symmetry, second order in the cell width. `fit` inverts S exactly (least squares).
///
/// Coefficients are nz x (2 N + 1): column 0 is a_0, columns 2n - 1 and 2n are a_n and b_n.
#include <vector>

#include "core/eigen.hpp"
#include "core/grid.hpp"

namespace shellback {

/// Owns the transform matrices of one grid.
class Harmonics {
 public:
  /// Harmonics 0 .. highest; 2 highest + 1 <= nt. Throws InputError otherwise.
  Harmonics(const FilmGrid& grid, int highest);

  [[nodiscard]] int highest() const { return highest_; }
  [[nodiscard]] int coefficients() const { return 2 * highest_ + 1; }  ///< of a row
  [[nodiscard]] int lines() const { return nt_; }                      ///< cells around
  /// A and S of (1) and (2), nt x (2 N + 1).
  [[nodiscard]] const Eigen::MatrixXd& analysis() const { return analysis_; }
  [[nodiscard]] const Eigen::MatrixXd& synthesis() const { return synthesis_; }
  /// Coefficients (1) of a cell field of any unit.
  [[nodiscard]] Eigen::MatrixXd analyse(const Field& field) const;
  /// Cell field (2) of coefficients with any number of rows m; index i * m + j.
  [[nodiscard]] Field synthesise(const Eigen::MatrixXd& coefficients) const;
  /// Coefficients whose synthesis is nearest to the field in the cell-width-weighted mean square;
  /// fit(synthesise(c)) = c to round-off, the mean over phi is kept.
  [[nodiscard]] Eigen::MatrixXd fit(const Field& field) const;

 private:
  int nt_;
  int highest_;
  Eigen::MatrixXd synthesis_;  ///< nt x (2 N + 1)
  Eigen::MatrixXd analysis_;   ///< nt x (2 N + 1)
  Eigen::LLT<Eigen::MatrixXd> gram_;
};

/// Harmonics that a grid of nt cells carries well: nt / 4, at most 48 [-]. Four cells to a period
/// keep the factor of A S above 0.81; beyond 48 a shell of usual thickness no longer answers.
[[nodiscard]] int default_harmonics(int nt);

/// One matrix (rows x nz) for each harmonic n = 0 .. N, alike for cosine and sine.
using HarmonicOperator = std::vector<Eigen::MatrixXd>;

/// Harmonics at which the operators of a body are computed, and the others from these.
///
/// From harmonic 6 on the operators of a linear body are smooth functions of n, rational where the
/// body is cut into elements: their poles lie at |n| <= 1 and about the imaginary axis. In
/// x = (n - a) / (n + a) both stay away from the interval, and one polynomial through nodes that
/// lie like Chebyshev's comes near fast. Over seven shells (linings of 10 um to 1 mm from stiff to
/// nearly incompressible, a bare ring of 2 mm, a thick one), each held, free and clamped, the
/// operators of 48 harmonics from 16 are within 1.3e-4 of their norm: less than the mesh is off.
/// First harmonic, nodes and a were chosen among 4 to 7, 10 to 13, 4 to 12 by that error
/// (HarmonicsBetweenFollowFromTheirNeighbours has the worst of these shells); 15 harmonics with the
/// best of them are at 2.8e-4, 17 at 4e-5.
class HarmonicSample {
 public:
  /// Harmonics 0 .. highest. `all`: every one is computed.
  explicit HarmonicSample(int highest, bool all = false);
  /// Those to be computed, ascending.
  [[nodiscard]] const std::vector<int>& computed() const { return computed_; }
  /// All operators from those at computed(); those are kept as they are.
  [[nodiscard]] HarmonicOperator complete(const HarmonicOperator& at_computed) const;

 private:
  int highest_;
  std::vector<int> computed_;
};

/// Coefficients times operator, harmonic by harmonic.
[[nodiscard]] Eigen::MatrixXd multiply(const HarmonicOperator& op,
                                       const Eigen::MatrixXd& coefficients);

/// a_n b_n, harmonic by harmonic: first b, then a.
[[nodiscard]] HarmonicOperator compose(const HarmonicOperator& a, const HarmonicOperator& b);

/// S op A field, symmetric for symmetric diag(dz) op_n; what lies above the highest harmonic is
/// dropped (core/field_operator.hpp does not). The operator must hold all harmonics of the
/// transform.
[[nodiscard]] Field apply(const Harmonics& harmonics, const HarmonicOperator& op,
                          const Field& field);

}  // namespace shellback
