#pragma once
/// Newton's method on the equilibrium of film, journal and elastic surfaces (equilibrium.hpp).
///
/// Each step (bordered_film.hpp) is bounded in the journal's movement, and in all of itself where
/// the residuals of elastic surfaces grow: a step after which a gap is closed, no pressure is left
/// (Barus) or the residuals are several times those before is rejected and tried again at half the
/// reach. Source: semismooth Newton with step control, methods 1.2, 2.2.
#include "bearing/film/equilibrium.hpp"

namespace shellback::bearing {

/// Solves from `state`, which is left at the last iterate that was evaluated where the iteration
/// does not settle.
[[nodiscard]] Verdict newton(const FilmTask& task, FilmEquilibrium& state, EquilibriumCost& cost);

}  // namespace shellback::bearing
