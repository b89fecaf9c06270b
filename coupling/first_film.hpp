#pragma once
/// The first equilibrium of film, position and elastic surfaces at one oil temperature, from cold.
///
/// A rigid film comes first; elastic surfaces are let in by continuation in the load. Where that
/// does not lead to the whole load, it is approached by steps from a light one (stepped_start.hpp)
/// or, for a given position, from a wide gap (position_path.hpp). Source: textbook (natural
/// continuation).
#include "coupling/solve.hpp"

namespace shellback::coupling {

/// Solves `s.target` on the model's own grid at temperature T [K]; rigid films from `s.film_end`,
/// if there is one. `s.film` is left at the last iterate.
[[nodiscard]] Verdict first_film(Solution& s, double T, const SolveControl& control);

}  // namespace shellback::coupling
