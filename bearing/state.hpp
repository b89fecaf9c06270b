#pragma once
/// What is solved for.
#include "core/grid.hpp"
#include "fluid/film_flux.hpp"

namespace shellback::bearing {

/// The unknowns of film, journal and elastic surfaces, and nothing that follows from them. (Those
/// of heat: HeatUnknowns, heat_state.hpp, and the temperatures across the film, OilColumns.)
struct State {
  fluid::FilmState film;
  fluid::JournalPosition position;
  /// e less q_free (equilibrium.hpp) over a step with an end, set where the step begins: the same
  /// place, without the round-off of e, of which a short step and a heavy journal make a force [m].
  std::array<double, 2> flight{};
  double ln_load = 0.0;  ///< of the load's factor, unknown along a path of loads [-]
  Field elastic;         ///< widening of equilibrium.hpp (3), shell and shaft [m]; empty: rigid
};

}  // namespace shellback::bearing
