#pragma once
/// An elastic bearing's film at a given position, followed from a smaller eccentricity.
///
/// A rigid film of Barus oil may have no pressure at the position given while an elastic one, which
/// gives way, has; then no rigid film is a start. The journal is taken from half its eccentricity
/// to the whole in steps of the gap that is left, which shrink where a step fails. Source:
/// continuation, textbook.
#include <atomic>

#include "coupling/film_equilibrium.hpp"

namespace shellback::coupling {

/// As solve_equilibrium, for an elastic bearing with position given, from cold at one oil
/// temperature T [K].
[[nodiscard]] Verdict follow_position(const BearingModel& model, const LoadTarget& target, double T,
                                      const Field& growth, FilmEquilibrium& state,
                                      EquilibriumCost& cost, const std::atomic<bool>* stop);

}  // namespace shellback::coupling
