#pragma once
/// A solved scene, before it is summed up into a Result.
#include <optional>
#include <vector>

#include "bearing/coefficients.hpp"
#include "bearing/film/equilibrium.hpp"
#include "bearing/heat_state.hpp"
#include "bearing/result.hpp"

namespace shellback::bearing {

/// Part of what is raised beyond which no steady state was found or none exists, on one grid.
struct Limit {
  std::array<int, 2> grid{0, 0};
  ending::Raised raised = ending::Raised::load;
  double part = 0.0;    ///< of what the case asks for [-]
  bool proven = false;  ///< beyond it there is none on this grid
  bool bound = false;   ///< by a bound of the equations
};

/// A state that was reached, without what follows from it.
struct Reached {
  FilmEquilibrium film;
  HeatState heat;
};

struct Solution {
  BearingModel model;
  OperatingPoint point;
  FilmEquilibrium film;
  HeatState heat;                    ///< meaningful if model.physics.film_energy
  double T_film = 0.0;               ///< isothermal and lumped: the film's temperature [K]
  std::vector<HeatRoot> heat_roots;  ///< lumped: all that were found, rising in temperature
  Verdict verdict;
  EquilibriumCost cost;
  std::vector<HistoryEntry> history;
  std::vector<Limit> limits;                 ///< of each grid on which a branch was followed
  std::optional<Coefficients> coefficients;  ///< if asked for, of the converged state
  std::vector<LevelRecord>
      levels;  ///< every grid of the sequence that converged, the last included
  double wall_s = 0.0;
};

}  // namespace shellback::bearing
