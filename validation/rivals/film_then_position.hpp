#pragma once
/// Film at a position by any cavitation method, journal position around it.
///
/// The film is solved at rest for its position, no more sharply than the load is met so far; then
/// the journal moves by dq with  dF/dq dq = wanted change of the force  (bordered_film.hpp).
/// Methods that factorise a matrix J of the film give dF/dq by it, dp = -J^-1 dR/dq dq. The
/// relaxation has none: dF/dq is found by moving the journal a little along each component, then
/// kept by Broyden's rank-one updates. A step after which the film fails or the force is further
/// off is taken back and halved.
#include "bearing/film/equilibrium.hpp"

namespace shellback::validation {

/// As solve_equilibrium, for a rigid bearing (thermal deformation and displacement given).
[[nodiscard]] Verdict film_then_position(const bearing::FilmTask& task,
                                         bearing::FilmEquilibrium& state,
                                         bearing::EquilibriumCost& cost);

}  // namespace shellback::validation
