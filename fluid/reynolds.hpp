#pragma once
/// Pressure and fill ratio of a film of given gap: JFO cavitation by semismooth Newton.
///
///   sum over faces m + stored = 0 in every cell, stored zero without end of step (1)
///   p >= p_cav,  0 <= theta <= 1,  (p - p_cav)(1 - theta) = 0                   (2)
///
/// One unknown per cell: p where the film is full, theta where it is cavitated. Each step solves
/// the linearised (1) for these unknowns, then moves cells across: p < p_cav becomes cavitated,
/// theta > 1 becomes full. Pressures advance along the local Barus curve,
/// p <- p - ln(1 - alpha dp)/alpha, that is, linearly in q = (1 - exp(-alpha p))/alpha: for Barus
/// oil of one temperature the step is exact, and a step with alpha dp >= 1 shows that the film
/// has no steady pressure at this gap. If an active set comes back, the step is replaced by one
/// on the Fischer-Burmeister form of (2) with line search.
/// Sources: methods 1.2; Newton on complementarity: textbook.
#include "fluid/film_matrix.hpp"
#include "fluid/film_solution.hpp"
#include "fluid/film_update.hpp"

namespace shellback::fluid {

/// Solves (1)-(2) from `guess`. Does not throw for lack of convergence: read the verdict.
[[nodiscard]] Outcome<FilmSolution> solve_reynolds(const FilmScene& scene, const Gap& gap,
                                                   const Field& profile, const OilLaw& oil,
                                                   const FilmState& guess,
                                                   const ReynoldsOptions& options = {});

}  // namespace shellback::fluid
