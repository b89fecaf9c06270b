#pragma once
/// GMRES without restart for small relative tolerances and few iterations; x starts from zero.
///
/// SPGMR of SUNDIALS without scaling and restart. Stops at |b - A x| <= tolerance |b| or after
/// `most` iterations, whichever is first.
#include <cstddef>
#include <functional>
#include <vector>

namespace shellback {

/// What operators near to one another have answered, and with it an inverse P of them all: of
/// fields V asked of them and their answers W, made orthonormal together,
///   P r = r + (V - W) W^T r,                                                                   (1)
/// the least-squares answer to what lies among W and the identity beside it. Solves of a Newton
/// iteration ask for much the same fields of operators that hardly change: right-preconditioned
/// with P they take half the iterations. Source: textbook (recycled Krylov spaces).
class KrylovMemory {
 public:
  /// w = A v. Forgotten where it tells nothing new; the first 24 that do are kept.
  void learn(std::vector<double> v, std::vector<double> w);
  /// P r in the place of r, of n numbers.
  void apply(double* r, std::size_t n) const;
  [[nodiscard]] bool empty() const { return pairs_.empty(); }

 private:
  struct Pair {
    std::vector<double> answer;  ///< of W
    std::vector<double> beyond;  ///< of V - W
  };
  std::vector<Pair> pairs_;
};

struct KrylovResult {
  std::vector<double> x;
  int iterations = 0;
  double reduction = 1.0;  ///< |b - A x| / |b| reached [-]
};

using LinearOperator = std::function<std::vector<double>(const std::vector<double>&)>;

/// `memory`: of operators near to this one; it learns from this solve.
[[nodiscard]] KrylovResult gmres(const LinearOperator& apply, const std::vector<double>& b,
                                 double tolerance, int most, KrylovMemory* memory = nullptr);

}  // namespace shellback
