#pragma once
/// Even layers across the film with second-order differences: what finite-volume codes use.
///
/// n = layers + 1 nodes at the faces of the layers, step d = 1/layers. Trapezoidal weights
/// w = d (1/2, 1, ..., 1, 1/2); central differences inside, one-sided at the walls: summation by
/// parts, second order with first-order closures. Conduction is the three-point stencil
/// (T_{k+1} - T_k)/d between neighbours. Q is the inverse of D: V_1 = d f_0,
/// V_{k+1} = V_{k-1} + 2 d f_k. What D cannot make is the alternating vector (1, -1, 1, ...): S
/// takes it out. Source: textbook (summation-by-parts operators of second order).
#include "core/cross_film_nodes.hpp"

namespace shellback {

/// 2 <= layers <= 60.
[[nodiscard]] CrossFilmNodes even_layers(int layers);

}  // namespace shellback
