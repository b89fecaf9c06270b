#pragma once
/// p-theta relaxation: the discrete film equations of fluid/reynolds.hpp, cell after cell.
///
/// In every cell the equation is solved for its pressure with theta = 1; where that falls below
/// the cavitation pressure, for its theta at that pressure. Cells follow each other in the
/// direction of motion, so that theta travels downstream in one sweep. Pressures are over-relaxed
/// by Young's factor 2/(1 + sqrt(1 - mu^2)) for the Jacobi spectral radius mu of an even film on
/// the same grid, theta is not. Between evaluations of the oil the equations are linearised. No
/// matrix is factorised; the sweeps needed grow with the number of cells along an axis.
/// Source: textbook (Gauss-Seidel on complementarity; Young's factor). The fixed point is the
/// solution of solve_reynolds, cell for cell.
#include "fluid/reynolds.hpp"

namespace shellback::validation {

struct RelaxationOptions {
  double tolerance = 1e-10;      ///< largest residual over flow_scale [-]
  long max_sweeps = 20000;       ///< then: Status::iteration_limit
  int between = 10;              ///< sweeps from one evaluation of oil and flow to the next
  double over_relaxation = 0.0;  ///< of the pressures, in (0, 2); 0: Young's factor
};

struct RelaxedFilm {
  fluid::FilmState state;
  long sweeps = 0;
};

/// Relaxes from `guess`. Does not throw for lack of convergence: read the verdict.
[[nodiscard]] Outcome<RelaxedFilm> relax_p_theta(const fluid::FilmScene& scene,
                                                 const fluid::Gap& gap, const Field& profile,
                                                 const fluid::OilLaw& oil,
                                                 const fluid::FilmState& guess,
                                                 const RelaxationOptions& options = {});

/// Young's factor for the grid [-]; see above.
[[nodiscard]] double young_factor(const FilmGrid& grid);

}  // namespace shellback::validation
