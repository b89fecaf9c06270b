#pragma once
/// Stiffness and damping of a solved bearing by its linearised film (coefficients.hpp).
#include "bearing/coefficients.hpp"
#include "bearing/film/solution.hpp"

namespace shellback::bearing {

/// Of a converged solution, to `tolerance` of the largest entry of K and C: far below what the grid
/// leaves wrong.
[[nodiscard]] Coefficients coefficients_of(const Solution& s, double tolerance = 1e-3);

}  // namespace shellback::bearing
