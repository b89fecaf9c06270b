#pragma once
/// Nested iteration: a cold film is solved on coarse grids first and carried to finer ones.
///
/// The coarse solutions cost little, place the cavitation boundary and the journal, and leave the
/// fine grid one to three Newton iterations (methods 1.2, 8).
#include <array>
#include <optional>
#include <vector>

#include "bearing/film/equilibrium.hpp"
#include "bearing/film/solve_equilibrium.hpp"
#include "bearing/heat_state.hpp"

namespace shellback::bearing {

/// Half the cells of each axis, rounded up along it; none where a grid is coarse enough already.
[[nodiscard]] std::optional<std::array<int, 2>> halved(std::array<int, 2> grid);

/// Grids from the coarsest to the case's, each axis about halved from one to the next; without
/// coarse ones that do not hold the supplies.
[[nodiscard]] std::vector<std::array<int, 2>> grid_ladder(const Case& c);

/// State on another grid of the same bearing: pressures, fill ratios, position, temperatures.
[[nodiscard]] FilmEquilibrium carry_over(const BearingModel& from, const FilmEquilibrium& s,
                                         const BearingModel& to);

/// Wall temperatures and thermal deformation on another grid of the same bearing.
[[nodiscard]] HeatState carry_over(const BearingModel& from, const HeatState& heat,
                                   const BearingModel& to);

}  // namespace shellback::bearing
