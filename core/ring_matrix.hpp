#pragma once
/// Linear systems on the developed bearing: a five-point stencil, periodic in phi.
///
/// Row (i, j) of the system reads
///   c x(i,j) + w x(i-1,j) + e x(i+1,j) + s x(i,j-1) + n x(i,j+1) = b(i,j)
/// with i taken modulo nt. Line by line this is a cyclic block-tridiagonal matrix whose
/// off-diagonal blocks are diagonal; RingFactor eliminates it by dense nz x nz block inverses in
/// ring order (partial pivoting inside a block) and closes the ring by a bordered last line.
/// Where the ring can be cut, that is, where no row of a line depends on the line after it (a
/// groove across the width, or a cavitated line), the border costs next to nothing.
///
/// Cost: about 2 to 8 nt nz^3 operations per factorisation, 4 nt nz^2 per solve. The inverses
/// are kept, so that many right-hand sides per factorisation are cheap. Source: textbook (block
/// elimination); why inverses and no symbolic phase: docs/theory.md.
#include <vector>

namespace shellback {

/// Most unknowns of a line (padded to whole registers) for which kernels are compiled.
inline constexpr int kLongestLine = 128;

struct RingMatrix {
  int nt = 0;
  int nz = 0;
  std::vector<double> c, w, e, s, n;  ///< nt * nz each, index i * nz + j
  void resize(int lines, int per_line);
  /// y = A x.
  void multiply(const std::vector<double>& x, std::vector<double>& y) const;
};

class RingFactor {
 public:
  /// Factorises; false if a block is singular (then `solve` must not be called).
  [[nodiscard]] bool factorize(const RingMatrix& a);
  /// Solves in place for `count` right-hand sides stored one after another, each nt * nz long.
  void solve(double* b, int count = 1) const;

 private:
  template <int LD>
  void take_couplings(const RingMatrix& a);
  template <int LD>
  bool factorize_padded(const RingMatrix& a);
  template <int LD>
  void apply_inverse(int i, const double* x, double* y) const;
  template <int LD>
  void solve_padded(double* b) const;
  [[nodiscard]] int line(int chain_index) const { return (first_ + chain_index) % nt_; }

  int nt_ = 0;
  int nz_ = 0;
  int ld_ = 0;                     ///< nz padded to whole vector registers
  int first_ = 0;                  ///< line with which the chain begins
  bool row_border_ = false;        ///< the last line depends on the first
  bool column_border_ = false;     ///< the first line depends on the last
  std::vector<double> w_, e_;      ///< couplings in chain order, padded
  std::vector<double> inverse_;    ///< block inverses
  std::vector<char> diagonal_;     ///< blocks that are diagonal: lines of cavitated film
  std::vector<double> inverse_v_;  ///< inverse times border column
  std::vector<double> u_inverse_;  ///< border row times inverse
};

}  // namespace shellback
