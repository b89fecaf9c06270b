#pragma once
/// Gauss-Lobatto-Legendre nodes on [0, 1] and the operators of polynomials through them.
///
/// For values f_k at the n nodes: quadrature sum w_k f_k (exact to degree 2n - 3), derivative
/// (D f)_k, running integral sum_l Q_kl f_l = int_0^{s_k}, and the projection S that removes the
/// highest Legendre mode (leaves degree n - 2 and the integral unchanged). Summation by parts
/// holds exactly: sum w_k (D f)_k = f(1) - f(0). Source: textbook (Legendre polynomials by their
/// three-term recurrence; nodes are the ends and the roots of P'_{n-1}).
#include "core/cross_film_nodes.hpp"

namespace shellback {

/// Nodes and operators, 3 <= n <= 32; S is the projection onto degree n - 2.
[[nodiscard]] CrossFilmNodes gauss_lobatto(int n);

}  // namespace shellback
