#pragma once
/// The equilibrium of film, journal and elastic surfaces by Newton's method, then through time; or
/// by what stands in for it if the case asks for another method (bearing/methods.hpp).
#include "bearing/film/equilibrium.hpp"

namespace shellback::bearing {

/// Solves from `state`, which is left at the last iterate whatever the verdict.
[[nodiscard]] Verdict solve_equilibrium(const FilmTask& task, FilmEquilibrium& state,
                                        EquilibriumCost& cost);

/// The same from a state near the solution: Newton's method alone, not through time.
[[nodiscard]] Verdict solve_equilibrium_near(const FilmTask& task, FilmEquilibrium& state,
                                             EquilibriumCost& cost);

}  // namespace shellback::bearing
