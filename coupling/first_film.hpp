#pragma once
/// The first equilibrium of film, position and elastic surfaces at one oil temperature, from cold.
///
/// A rigid film comes first; elastic surfaces are let in by continuation in the load. Where that
/// does not lead to the whole load, it is approached by steps from a light one (stepped_start.hpp)
/// or, for a given position, from a wide gap (position_path.hpp). Source: textbook (natural
/// continuation).
#include "coupling/solve.hpp"

namespace shellback::coupling {

/// How long to look for what is not found at once.
enum class Search { long_way, brief };

/// Solves `s.target` on the model's own grid at temperature T [K]; `s.film` is the start.
[[nodiscard]] Verdict first_film(Solution& s, double T, Search search, const SolveControl& control);

}  // namespace shellback::coupling
