#pragma once
/// A rigid bearing's equilibrium, followed from a load at which there surely is one.
///
/// Where the joint Newton iteration gets lost, this is the slower and surer way: a position
/// near the centre, at which there is a film, carries some load lambda W; turned into the
/// direction of W it is an equilibrium; then lambda goes to 1 in steps that shrink where a step
/// fails. If the steps become small before that, the path ends: with rigid surfaces and Barus oil
/// at the limit load, where the reduced pressure reaches 1/alpha. Source: continuation, textbook.
#include <atomic>

#include "coupling/film_equilibrium.hpp"

namespace shellback::coupling {

/// As solve_equilibrium, for a rigid bearing with unknown position; starts from cold. Verdict
/// no_steady_state: the path ends where the film has no pressure any more.
[[nodiscard]] Verdict follow_load(const BearingModel& model, const LoadTarget& target,
                                  const Field& growth, const EquilibriumOptions& options,
                                  FilmEquilibrium& state, EquilibriumCost& cost,
                                  const std::atomic<bool>* stop);

}  // namespace shellback::coupling
