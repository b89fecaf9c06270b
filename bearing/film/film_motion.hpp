#pragma once
/// The loaded film moved as a whole.
///
/// A change of the gap dh, given for every cell, moves the film by
///   dh* = sum_k a_k s_k                                                                    (1)
/// s_k the slopes of the gap by the journal's free motions (fluid/gap.hpp), a_k by least squares,
/// with the force on each cell as weight: what dh is worth as a motion of the journal, where the
/// film carries.
///
/// Of a step in time dh is what it misses. The pressure beside a front of oil jumps as cells fill,
/// one after the other (of first order in time, methods 4), and elastic surfaces give way there,
/// however short the steps: dh of single cells is noise, largest where the film is thick. What
/// carries is the film as a whole; the journal and the surfaces that yield with it are in dh*
/// together, of a soft bearing, whose journal takes the shell along, as the small difference of
/// both. Error:
///   max( max |dh*|/(h + sigma),  sqrt( sum p dA (dh/(h + sigma))^2 / sum p dA ) )          (2)
/// the maximum over the whole loaded film, up to its fronts, the mean over the cells that count.
/// Range: any film; errors: none. Source: own form (docs/decisions/053).
#include <array>
#include <optional>

#include "bearing/film/equilibrium.hpp"

namespace shellback::bearing {

/// What film and summits of each cell carry [N].
[[nodiscard]] Field carrying_force(const BearingModel& model, const FilmEquilibrium& film);

/// a_k of (1) [m], [rad]; `force`: weight of each cell, of any unit. Few cells: the least motion.
[[nodiscard]] std::array<double, 4> motion_of(const BearingModel& model, int unknowns,
                                              const Field& force, const Field& dh);

/// Full cells of which no neighbour within two cells to both sides around is cavitated.
[[nodiscard]] std::vector<char> away_from_fronts(const FilmGrid& g, const std::vector<char>& full);

/// (2) of a film with `unknowns` free motions; `missing`: dh of each cell [m], `counts`: cells that
/// are full and have been for some time, `loaded`: pressure from which on a film cell is loaded
/// [Pa]. None if no loaded cell counts.
[[nodiscard]] std::optional<double> loaded_film_error(const BearingModel& model, int unknowns,
                                                      const FilmEquilibrium& film,
                                                      const Field& missing,
                                                      const std::vector<char>& counts,
                                                      double loaded);

}  // namespace shellback::bearing
