#pragma once
/// The equilibrium of film, journal and elastic surfaces by the method that the case asks for
/// (bearing/methods.hpp); the usual one is Newton's, then through time.
#include <atomic>

#include "bearing/equilibrium.hpp"

namespace shellback::bearing {

/// Solves from `state`, which is left at the last iterate whatever the verdict.
[[nodiscard]] Verdict solve_equilibrium(const BearingModel& model, const LoadTarget& target,
                                        const Field& growth, const EquilibriumOptions& options,
                                        FilmEquilibrium& state, EquilibriumCost& cost,
                                        const std::atomic<bool>* stop = nullptr);

/// The same from a state near the solution: the usual method does not go through time.
[[nodiscard]] Verdict solve_equilibrium_near(const BearingModel& model, const LoadTarget& target,
                                             const Field& growth, const EquilibriumOptions& options,
                                             FilmEquilibrium& state, EquilibriumCost& cost,
                                             const std::atomic<bool>* stop = nullptr);

/// True if the case asks for the usual methods; others are shown as they are known elsewhere, and
/// know nothing of a path of loads.
[[nodiscard]] bool usual_methods(const Case& c);

}  // namespace shellback::bearing
