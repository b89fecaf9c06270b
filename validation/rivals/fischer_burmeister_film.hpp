#pragma once
/// The film of a given gap by Fischer-Burmeister steps alone (fluid/fischer_burmeister.hpp).
#include "fluid/film_solution.hpp"

namespace shellback::validation {

/// As fluid::solve_reynolds.
[[nodiscard]] Outcome<fluid::FilmSolution> solve_fischer_burmeister(
    const fluid::FilmScene& scene, const fluid::Gap& gap, const Field& profile,
    const fluid::OilLaw& oil, const fluid::FilmState& guess,
    const fluid::ReynoldsOptions& options = {});

}  // namespace shellback::validation
