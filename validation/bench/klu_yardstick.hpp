#pragma once
/// The yardstick of the benchmark: one KLU refactorisation of a Reynolds matrix.
///
/// The matrix is that of the full-width film of the given case at eccentricity ratio 0.9 with its
/// converged cavitation, entries that are zero left out, AMD order, pattern and pivots of a first
/// factorisation reused (klu_refactor). A time over this one holds on any machine.
#include <memory>

#include "bearing/case.hpp"
#include "core/ring_matrix.hpp"

namespace shellback::bench {

/// Jacobian of the full-width film on nt x nz cells, in the unknowns of the active set.
[[nodiscard]] RingMatrix reynolds_matrix(const bearing::Case& c, int nt, int nz);

/// Owns a matrix in KLU's form and its factors.
class KluYardstick {
 public:
  explicit KluYardstick(const RingMatrix& matrix);
  ~KluYardstick();
  KluYardstick(const KluYardstick&) = delete;
  KluYardstick& operator=(const KluYardstick&) = delete;

  void refactor();       ///< numbers only, the former pattern and pivots
  void factor_afresh();  ///< analysis and factorisation

 private:
  struct Factors;
  std::unique_ptr<Factors> f_;
};

}  // namespace shellback::bench
