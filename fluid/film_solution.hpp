#pragma once
/// What all methods for the film equation take and give.
#include <functional>

#include "core/outcome.hpp"
#include "core/ring_matrix.hpp"
#include "fluid/film_flux.hpp"

namespace shellback::fluid {

/// Sets the oil's coefficients for the state that the film has now.
using OilLaw = std::function<void(const FilmState&, FilmCoefficients&)>;

struct ReynoldsOptions {
  double tolerance = 1e-12;  ///< largest residual over flow_scale [-]
  int max_iterations = 60;  ///< plus one per line of cells in a moving film without rotation, whose
                            ///< edge may settle line by line
};

struct FilmSolution {
  FilmState state;
  FilmFlow flow;
  FilmCoefficients oil;
  RingFactor factor;  ///< of the last matrix: reusable for sensitivities
  int factorizations = 0;
};

}  // namespace shellback::fluid
