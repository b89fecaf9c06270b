#pragma once
/// What a grid leaves open where supplies leave little film.
///
/// Grids of one sequence cut a narrow land into as few cells as the own one does, and agree on what
/// all of them miss: the sequence says nothing of it. With n cells around on the widest land of a
/// row that has film on less than half a turn,
///   pads = mean over the rows, by width, of 20 / n^2                                        (1)
/// of every quantity: the pressure over a pad is an arch of one sign, whose mean over n cells is of
/// second order. With m cells between a supply and the side edge,
///   sides = sum of 0.1 A / m over such lands, over the area of all film                     (2)
/// of friction: where the oil tears off within a land is known to a part of a cell, and friction
/// follows the fill. Factors are those of decision 079, from bearings of one groove of 280 to 345
/// degrees. Both vanish as cells become many, and where half a turn and more is film.
///
/// Likewise a hole that is one row of cells on all of them: around it pressure falls off as a
/// logarithm, and the flow that it feeds is known to
///   holes = 0.2 / n^2,  n rows of cells of the hole with the fewest                         (3)
/// decision 085, from 126 bearings.
#include <string_view>

#include "bearing/case.hpp"
#include "fluid/supply.hpp"

namespace shellback::fidelity {

struct LandError {
  double pads = 0.0;   ///< (1), of the size of each quantity [-]
  double sides = 0.0;  ///< (2), of friction [-]
  double holes = 0.0;  ///< (3), of flows [-]
};

/// Of the patches that take cells; lines and drillings of the journal part no lands.
[[nodiscard]] LandError land_error(const FilmGrid& grid, const fluid::SupplyMap& supply);

/// Of the case on its grid; errors as film_grid() and map_supplies().
[[nodiscard]] LandError land_error(const bearing::Case& c);

/// Part of its size that they leave open of the quantity of this name [-].
[[nodiscard]] double open_by_lands(const LandError& lands, std::string_view name);

}  // namespace shellback::fidelity
