#pragma once
/// Rings of the film that are cavitated all round and fed by nothing.
///
/// Cavitated film passes oil along the rotation only, so that in such a ring it goes round: any
/// fill ratio balances it, and the film's matrix is singular. A Newton step that was too long may
/// leave one where the film is full.
#include <vector>

#include "fluid/film_flux.hpp"

namespace shellback::fluid {

/// Axial indices of such rings.
[[nodiscard]] std::vector<int> empty_rings(const FilmScene& scene, const FilmState& state);

/// Whether a steady film has one: its matrix is singular then, and whether a pivot of its
/// factorisation is 0 is up to rounding. With a step in time the oil that is stored tells it.
[[nodiscard]] bool steady_ring_is_empty(const FilmScene& scene, const FilmState& state);

/// Fills them again, to be emptied anew if they must; false if there are none.
bool refill_empty_rings(const FilmScene& scene, FilmState& state);

}  // namespace shellback::fluid
