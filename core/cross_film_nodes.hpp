#pragma once
/// Nodes on [0, 1] across the film with the operators that the film's energy and viscosity need.
///
/// For values f_k at the n nodes: integral sum w_k f_k, derivative (D f)_k, running integral
/// sum_l Q_kl f_l = int_0^{s_k}, conduction A (symmetric, rows sum to 0: weak form of -d2/ds2).
/// S takes out of f, without changing its integral, what no derivative D g of a g with
/// g(0) = 0 can be; then D Q S f = S f, and summation by parts sum w_k (D f)_k = f(1) - f(0) makes
/// balances exact. Sets: core/gauss_lobatto.hpp, core/even_layers.hpp, core/bulk_node.hpp.
#include <vector>

namespace shellback {

struct CrossFilmNodes {
  int n = 0;
  std::vector<double> s;  ///< nodes [-], s[0] = 0, s[n-1] = 1
  std::vector<double> w;  ///< weights of what the oil carries and makes [-], sum 1
  std::vector<double> v;  ///< weights of the integrals over the fluidity [-], sum 1
  std::vector<double> D;  ///< n x n, row k: derivative at s_k [-]
  std::vector<double> Q;  ///< n x n, row k: integral from 0 to s_k [-]
  std::vector<double> S;  ///< n x n, projection [-]
  std::vector<double> A;  ///< n x n, conduction [-]
  /// True: the oil of a column has one temperature, that of the nodes between the walls.
  bool one_temperature = false;

  /// sum w_k f_k of the n values of one column, from `f` on.
  [[nodiscard]] double mean(const double* f) const {
    double sum = 0.0;
    for (int k = 0; k < n; ++k) sum += w[k] * f[k];
    return sum;
  }
};

/// D^T W D: the conduction of a set whose D is exact for what its nodes can hold.
[[nodiscard]] std::vector<double> conduction_of(const CrossFilmNodes& set);

}  // namespace shellback
