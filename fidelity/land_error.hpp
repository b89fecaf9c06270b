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
///
/// Where all grids of a sequence cut the lands between supplies and side edges into as few cells,
/// m on the narrowest, what the film beside a groove takes along is known, beside what they tell,
/// to
///   past = 0.1 / m^1.5 of flows, 0.04 / m^1.5 of friction and temperatures that heat makes,
///   0.012 / m^1.5 of friction in a film of one temperature                                   (4)
/// decision 089.
#include <string>
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

/// What a grid gives the supplies at least.
struct CellsOfSupplies {
  int lands = 0;  ///< cells of the narrowest land between one and a side edge; 0: there is none
  int holes = 0;  ///< rows of cells of a hole; 0: there is none
};
[[nodiscard]] CellsOfSupplies cells_of_supplies(const FilmGrid& grid,
                                                const fluid::SupplyMap& supply);
[[nodiscard]] CellsOfSupplies cells_of_supplies(const bearing::Case& c,
                                                const std::array<int, 2>& cells);

/// `cells` with as many more along, up to `most`, as cut the narrowest land of the case into three.
/// Where one sequence holds lands of one cell and of two its differences are those of the cut: two
/// axial grooves with lands of 10 mm, friction at 240 x 31 cells (two, one) +-4.2 %, at 280 x 37
/// (three) +-0.4 %. None are added where there is no land, or so narrow a one that `most` do not
/// do.
[[nodiscard]] std::array<int, 2> with_lands_cut(const bearing::Case& c, std::array<int, 2> cells,
                                                int most);

/// Part of its size that (4) leaves open of the quantity of this name on lands of m cells (0:
/// none); `heated`: the film has a temperature of its own; `torn`: part of it is cavitated.
[[nodiscard]] double open_past_lands(int m, bool heated, bool torn, const std::string& name);

/// Part of its size that they leave open of the quantity of this name [-].
[[nodiscard]] double open_by_lands(const LandError& lands, std::string_view name);

}  // namespace shellback::fidelity
