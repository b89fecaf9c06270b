#pragma once
/// The equilibrium of film, journal and elastic surfaces by the method that the case asks for
/// (coupling/methods.hpp); the usual one is Newton's, then through time.
#include <atomic>

#include "coupling/equilibrium.hpp"

namespace shellback::coupling {

/// Solves from `state`, which is left at the last iterate whatever the verdict.
[[nodiscard]] Verdict solve_equilibrium(const BearingModel& model, const LoadTarget& target,
                                        const Field& growth, const EquilibriumOptions& options,
                                        FilmEquilibrium& state, EquilibriumCost& cost,
                                        const std::atomic<bool>* stop = nullptr);

}  // namespace shellback::coupling
