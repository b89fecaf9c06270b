#pragma once
/// Where an equilibrium is solved by a method other than the usual one (coupling/methods.hpp).
#include <atomic>

#include "coupling/equilibrium.hpp"

namespace shellback::coupling {

/// True if the methods of the model's case ask for it, for this state's physics.
[[nodiscard]] bool solved_otherwise(const BearingModel& model, const FilmEquilibrium& state);

/// As solve_equilibrium.
[[nodiscard]] Verdict solve_otherwise(const BearingModel& model, const LoadTarget& target,
                                      const Field& growth, const EquilibriumOptions& options,
                                      FilmEquilibrium& state, EquilibriumCost& cost,
                                      const std::atomic<bool>* stop);

}  // namespace shellback::coupling
