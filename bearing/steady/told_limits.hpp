#pragma once
/// Where a converged solution leaves the range of its laws, and which limiters acted.
#include <string>
#include <vector>

#include "bearing/result.hpp"
#include "bearing/steady/solve.hpp"

namespace shellback::bearing {

/// One note for each law that is used beyond its range, for stiffness and damping that are only
/// a guide, and for further roots of the heat balance. For an evaluated film.
[[nodiscard]] std::vector<Note> warnings_of(const Solution& s);

/// Limiters that acted, and how often.
[[nodiscard]] std::vector<LimiterCount> limiters_of(const Solution& s);

}  // namespace shellback::bearing
