#pragma once
/// The first equilibrium of film, position and elastic surfaces at one oil temperature, from cold.
///
/// Newton's method, then through time; where neither arrives, along the load from a light one.
#include "bearing/control.hpp"
#include "bearing/film/solution.hpp"

namespace shellback::bearing {

/// Solves `s.point` on the model's own grid at temperature T [K]. `s.film` is left at the last
/// state.
[[nodiscard]] Verdict first_film(Solution& s, double T, const SolveControl& control);

}  // namespace shellback::bearing
