#pragma once
/// Fill ratio that oil carries out of a cavitated cell while fronts of oil wander.
///
/// With the cell's own fill ratio a front that is carried with the oil widens with the square root
/// of its way times the cell's length: a film that is fed once in a turn forgets where it was fed.
/// Here the ratio at the downstream face is
///   theta_f = theta (1 - f (1 - theta)),   d theta_f / d theta = 1 - f (1 - 2 theta)          (1)
/// with f, |f| <= 1, of a given film such that in that film
///   theta_f = theta + (dx/2) S                                                                (2)
/// S is the smaller of two slopes along the way of the oil, zero if their signs differ: that of
/// theta, and N/(C dx) with N the net loss of a cell that carries its own fill ratio [kg/s] and C
/// the Couette flow of full film through its downstream face. Each is van Leer's mean over the
/// cell and its neighbours. Where fronts wander the two are the same. In a film that stands still
/// N is zero, and a load that stands still leads to the steady film to round-off; where the gap
/// alone changes along the way, theta has no slope of its own.
/// With f given, (1) is a law of the cell alone that rises from 0 at theta = 0 to 1 at theta = 1:
/// no cell is emptied below zero or pressed by what is carried, the film's matrix keeps its pattern
/// and its signs, and a cell that fills passes into full film without a jump. A stage takes f from
/// the film with which it begins, is solved, and solved again with f from what was found: with the
/// first alone fronts lag by a step (docs/decisions/041).
/// Range: any step; in one in which the oil goes many cells a front is as wide as the step makes
/// it. Errors: none. Source: own form; van Leer's limiter, textbook.
#include "fluid/carried_fill.hpp"
#include "fluid/film_flux.hpp"

namespace shellback::fluid {

/// f of every cell from this film and its flows; zero where it is full, in supplies, without speed,
/// and where flows are not known [-].
[[nodiscard]] Field fill_fronts(const FilmScene& scene, const FilmState& film,
                                const FilmFlow& flow);

}  // namespace shellback::fluid
