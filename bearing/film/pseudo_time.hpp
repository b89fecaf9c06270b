#pragma once
/// From any possible state to the steady one through time.
///
/// Steps of backward Euler with the film's own storage: a journal that its load drives squeezes oil
/// out of its way, so that it closes no gap in a finite step. Steps lengthen as long as Newton's
/// method is quick and shorten where it fails; once they are long against everything that moves
/// the steady equations are solved. Source: pseudo-transient continuation, textbook.
#include "bearing/film/equilibrium.hpp"

namespace shellback::bearing {

/// As newton, of the steady bearing.
[[nodiscard]] Verdict march_to_steady(const FilmTask& task, FilmEquilibrium& state,
                                      EquilibriumCost& cost);

/// A journal that does not turn, let go in the middle of a full film: until, after days, the film
/// carries nothing any more and asperities all. Cavitated oil is left where it is.
[[nodiscard]] Verdict come_to_rest(const FilmTask& task, FilmEquilibrium& state,
                                   EquilibriumCost& cost);

/// Newton's method; where it fails, through time.
[[nodiscard]] Verdict newton_or_through_time(const FilmTask& task, FilmEquilibrium& state,
                                             EquilibriumCost& cost);

}  // namespace shellback::bearing
