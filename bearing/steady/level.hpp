#pragma once
/// A grid of the sequence on which a tier is solved.
#include "bearing/film/equilibrium.hpp"

namespace shellback::bearing {

/// How a grid is begun.
struct Level {
  bool warm = false;    ///< from the state that is there; else from cold
  bool coarse = false;  ///< its solution is not told: known as well as a finer grid needs
  bool start = false;   ///< of a finer grid: nothing is asked beyond where a branch turns back
};

/// Of the work that is left: most that a coarse grid may take, and a film from cold before a branch
/// is followed to it. The verdict is that of the last grid and of the branch, which are not to go
/// without a try for want of a start (docs/decisions/022) [-].
inline constexpr double kForStarts = 0.5;

/// Residuals of the film of a coarse grid, which begins a finer one and tells what cells change:
/// the bars that are made of it take 1e-4 of every quantity for what an iteration leaves [-].
inline constexpr double kCoarseFilm = 1e-7;
[[nodiscard]] inline EquilibriumOptions film_options(const Level& level) {
  EquilibriumOptions o;
  if (level.coarse) {
    o.film_tolerance = o.load_tolerance = o.viscosity_tolerance = kCoarseFilm;
    o.elastic_tolerance = kCoarseFilm;
  }
  return o;
}

}  // namespace shellback::bearing
