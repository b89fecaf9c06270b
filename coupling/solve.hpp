#pragma once
/// One case, one tier, one result: what `run` calls.
#include "coupling/coefficients.hpp"
#include "coupling/control.hpp"
#include "coupling/film_heat.hpp"
#include "coupling/result.hpp"
#include "coupling/thermal_loop.hpp"

namespace shellback::coupling {

/// Temperature of the isothermal tier [K]: from the measured (or prescribed) shell-back temperature
/// T_supply + kappa (T_back - T_supply) if there is one, else the oil temperature of the case, else
/// the supply temperature (constant viscosity). Source: design 3, after seed 000 3.5; the published
/// relation itself is not available and not claimed.
[[nodiscard]] double equivalent_temperature(const Case& c);

/// What is raised where film and heat are followed from harmless operation on (heat_path.hpp).
enum class Raised { load, speed };

/// A point on that path.
struct Waymark {
  double part = 0.0;    ///< of the load or the speed asked for [-]
  double torque = 0.0;  ///< of friction, without sign [N m]
  double flow = 0.0;    ///< side flow [kg/s]
};

/// Where that path ended. `part` 0: nothing was followed.
struct PathEnd {
  Raised raised = Raised::load;
  double part = 0.0;
  Waymark first;        ///< its first point
  bool proven = false;  ///< beyond `part` there is no steady state; else the end is open
};

/// A solved scene, before it is summed up into a Result.
struct Solution {
  BearingModel model;
  LoadTarget target;
  FilmEquilibrium film;
  HeatState heat;                    ///< meaningful if model.physics.film_energy
  double T_film = 0.0;               ///< isothermal and lumped: the film's temperature [K]
  std::vector<HeatRoot> heat_roots;  ///< lumped: all that were found, rising in temperature
  Verdict verdict;
  EquilibriumCost cost;
  std::vector<HistoryEntry> history;
  double film_end = 0.0;  ///< load to which the film of a coarser grid was followed; 0: none [N]
  PathEnd followed;       ///< where film and heat had to be followed to the operation asked for
  std::optional<Coefficients> coefficients;  ///< if asked for, of the converged state
  std::vector<LevelRecord> levels;  ///< every grid of the ladder that converged, the last included
  double wall_s = 0.0;
};

/// Solves the case in one tier. `solids`: operators of a former solve of the same geometry.
[[nodiscard]] Solution solve_tier(const Case& c, Tier tier, const SolveControl& control = {},
                                  std::shared_ptr<const Solids> solids = nullptr);

/// What to do where a near solution is no start.
enum class Otherwise { from_cold, give_up };

/// Solves the case in one tier from the solution of a near one: the same bearing at another speed,
/// load, temperature or in a tier below; on its own grid at once, without the ladder of coarser
/// ones. Where `near` is no start (it did not converge, or this solve does not from it), starts
/// from cold, unless `otherwise` forbids it: then the failure is handed back. The operators of the
/// solids are shared where they serve.
[[nodiscard]] Solution solve_tier_from(const Case& c, Tier tier, const Solution& near,
                                       const SolveControl& control = {},
                                       Otherwise otherwise = Otherwise::from_cold);

/// Isothermal solution at a given film temperature, from cold.
[[nodiscard]] Solution solve_isothermal_at(const Case& c, double T,
                                           const SolveControl& control = {});

/// The scalars of a solution, as they are reported.
[[nodiscard]] std::vector<Quantity> quantities_of(const Solution& s, Tier tier);

/// Sums up.
[[nodiscard]] Result summarize(const Solution& s, Tier tier);

/// solve_tier and summarize in the tier of the case. Does not throw for lack of convergence: the
/// result carries the verdict and the last state.
[[nodiscard]] Result solve(const Case& c, const SolveControl& control = {});

}  // namespace shellback::coupling
