#pragma once
/// Oil that is carried out of a cavitated cell in time, of second order.
///
/// In a cavitated film the oil M = rho theta hT of a place [kg/m2] is carried with the mean speed of
/// the surfaces, whatever the gap. A cell that hands on its own fill ratio smears what it carries:
/// a front widens with the square root of its way times the cell's length, and a film that is fed
/// once in a turn forgets where it was fed. Here the oil at the downstream face is
///   M_f = M + (dx/2) S                                                                        (1)
/// S being van Leer's mean of the slopes of M to the cells before and behind, zero where their
/// signs differ and beside supplies: 0 <= M_f <= 2 M. The fill ratio at the face is
///   theta_f = M_f/(rho hT)_f                                                                  (2)
/// (rho hT)_f of full film at the face, and f such that the law of the cell
///   theta_f = theta/(1 + f (1 - theta)),   -1/2 <= f <= 1                                     (3)
/// gives it for the film that f is taken from. With f given (3) rises from 0 at theta = 0 to 1 at
/// theta = 1, nowhere steeper than twice and nowhere flatter than half: no cell is emptied below
/// zero or pressed by what is carried, the film's matrix keeps its pattern and its signs, and a cell
/// that fills passes into full film without a jump. The bounds of f bind where a cell is nearly
/// full or the gap changes much within it. A stage takes f from the film with which it begins, is
/// solved, and solved again with f from what was found: with the first alone fronts lag by a step
/// (docs/decisions/041).
/// The steady film carries its cells' own fill ratios: nothing wanders there, the flow is the same,
/// and theta is then that at the downstream face, M of a cell that of theta's mean over its two
/// faces (resultants.hpp).
/// Range: any step; in one in which the oil goes many cells a front is as wide as the step makes
/// it. Errors: none. Source: own form; van Leer's limiter, textbook.
#include "fluid/carried_fill.hpp"
#include "fluid/film_flux.hpp"

namespace shellback::fluid {

/// f of every cell from this film and its flows in a step in time; zero where it is full, in
/// supplies and before their patches, without speed, and in a step without end [-].
[[nodiscard]] Field fill_fronts(const FilmScene& scene, const FilmState& film,
                                const FilmFlow& flow);

}  // namespace shellback::fluid
