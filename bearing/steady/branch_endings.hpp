#pragma once
/// How a branch of steady states ended, and where it shows.
#include "bearing/film/follow.hpp"
#include "bearing/heat/heat_march.hpp"

namespace shellback::bearing {

/// True if by its end there is nothing beyond, as far as one grid can tell; `s`: its last state.
[[nodiscard]] bool shows_none_beyond(const Solution& s, const Branch& branch);

/// The branch ended before the whole load or speed, `s` being its last state.
[[nodiscard]] Verdict branch_ended(const Solution& s, const Branch& branch);

/// Under a little more than the branch carries film and walls ran away in time.
[[nodiscard]] Verdict ran_away_from(const Solution& s, const Branch& branch, const MarchEnd& end);

/// Where the branches of two grids end does not agree, or there is but one.
[[nodiscard]] Verdict limit_not_resolved(const Solution& s);

}  // namespace shellback::bearing
