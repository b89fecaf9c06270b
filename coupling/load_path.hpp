#pragma once
/// A rigid bearing's equilibrium, followed from a load at which there surely is one.
///
/// Where the joint Newton iteration gets lost, this is the slower and surer way. Films are solved
/// at rest in positions all over the loaded half; the one whose force F is nearest to the load W
/// carries |F| in the direction of W after a little turning; then the load goes to |W| in steps
/// that shrink where a step fails. On the way loads are whole powers of 2^(1/32) N, so that where
/// a path ends is the same number whatever load is asked for. If the steps become one such power,
/// the path ends. The end of the path on a coarser grid is where that on a finer one begins. Then a
/// film a little closer is asked for: if it has no pressure (reduced pressure beyond 1/alpha), the
/// end is the limit load of rigid surfaces; if the gap is below a molecule's length, there is no
/// film of smooth ones. Source: continuation, textbook.
#include <atomic>

#include "coupling/film_equilibrium.hpp"

namespace shellback::coupling {

/// As solve_equilibrium, for a rigid bearing with unknown position; starts from cold, or from
/// `near` if there is one and it leads anywhere. Verdict no_steady_state: the path ends where the
/// film has no pressure any more.
[[nodiscard]] Verdict follow_load(const BearingModel& model, const LoadTarget& target,
                                  const Field& growth, const EquilibriumOptions& options,
                                  FilmEquilibrium& state, EquilibriumCost& cost,
                                  const std::atomic<bool>* stop, double carried = 0.0);

}  // namespace shellback::coupling
