#pragma once
/// A last look at a converged solution: what the equations forbid, a coarse grid may still give.
#include "coupling/solve.hpp"

namespace shellback::coupling {

/// Good, or why the solution cannot be one. Heat flows from warm to cold and friction only adds to
/// it: no film temperature lies below the lowest of all temperatures given (oil, ambient, back) by
/// more than the ripple of the discretisation. Where gap jumps drive oil round and
/// round within few cells the discrete film energy may break this.
[[nodiscard]] Verdict plausible(const Solution& s);

/// Undershoot that the discretisation may have where temperatures span `span` [K]: the polynomial
/// across the film and the second-order convection round it overshoot at jumps; 10 %, at least 5 K.
[[nodiscard]] double temperature_ripple(double span);

/// The lowest temperature given in the case [K]: supplies, oil, back, ambients.
[[nodiscard]] double coldest_given(const Case& c);

}  // namespace shellback::coupling
