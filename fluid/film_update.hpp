#pragma once
/// Films to begin with, and how a step of the unknowns moves one: along the local Barus curve, and
/// across between full and cavitated. See reynolds.hpp.
#include "fluid/film_flux.hpp"

namespace shellback::fluid {

/// Effect of an update on the state.
struct UpdateReport {
  int moved = 0;         ///< cells that changed between full and cavitated
  int beyond_barus = 0;  ///< cells whose step left the range of the pressure law, alpha dp >= 1
  int worst_cell = -1;   ///< one of them
};

constexpr double kMostBarus = 0.99;  ///< of advance: largest alpha dp of a step [-]

/// Applies the step t (scaled by `fraction`) and moves cells across. alpha dp is held to at most
/// `most_barus`, below 1; a cell that asks for more is counted.
UpdateReport advance(const FilmScene& scene, const FilmCoefficients& oil, const Field& step,
                     double fraction, FilmState& state, double most_barus = kMostBarus);

/// Full film at ambient pressure, supply cells at theirs: the cold start.
[[nodiscard]] FilmState cold_film(const FilmScene& scene);
/// Puts the supply pressures into a state (after interpolation from another grid, say).
void impose_supply(const SupplyMap& supply, FilmState& state);

}  // namespace shellback::fluid
