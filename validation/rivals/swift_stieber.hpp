#pragma once
/// Reynolds' (Swift-Stieber) condition: no pressure below that of cavitation, no fill ratio.
///
///   p >= p_cav,   R(p) >= 0,   (p - p_cav) R(p) = 0,   theta = 1 everywhere          (1)
/// R the net outflow of a cell as in fluid/reynolds.hpp. The film ends where pressure and its slope
/// vanish. In cavitated cells R > 0: oil comes from nowhere there, and where the film forms again
/// it forms as soon as the gap closes. The mass audit shows it. Solved by Newton on the set of
/// cells with pressure; a set that comes back is left by moving only its worst cell.
/// Source: textbook (Swift 1932, Stieber 1933).
#include "fluid/reynolds.hpp"

namespace shellback::validation {

/// Solves (1) from `guess`. Does not throw for lack of convergence: read the verdict.
[[nodiscard]] Outcome<fluid::FilmSolution> solve_swift_stieber(
    const fluid::FilmScene& scene, const fluid::Gap& gap, const Field& profile,
    const fluid::OilLaw& oil, const fluid::FilmState& guess,
    const fluid::ReynoldsOptions& options = {});

}  // namespace shellback::validation
