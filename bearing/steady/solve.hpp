#pragma once
/// One steady case, one tier, one result.
#include "bearing/control.hpp"
#include "bearing/film/solution.hpp"
#include "bearing/heat/film_heat.hpp"

namespace shellback::bearing {

/// Temperature of the isothermal tier [K]: from the measured (or prescribed) shell-back temperature
/// T_supply + kappa (T_back - T_supply) if there is one, else the oil temperature of the case, else
/// the supply temperature (constant viscosity). Source: design 3, after seed 000 3.5; the published
/// relation itself is not available and not claimed.
[[nodiscard]] double equivalent_temperature(const Case& c);
/// Whether tier isothermal passes over a supply's temperature (but for the density at which flows
/// are told by volume): that of the oil is given as another.
[[nodiscard]] bool passes_over_supply(const Case& c, Tier tier);

/// Work after which a search on the case's own grid is given up [cells]: twenty times that of a
/// usual solve, which takes as many film iterations, counted on the finest grid, as 90 to 95 % of
/// random bearings need (docs/decisions/022).
[[nodiscard]] double price_of_search(const Case& c, Tier tier);

/// Solves the steady state of the case in one tier, whatever its load cycle. `solids`: operators of
/// a former solve of the same geometry. Throws InputError for the tiers estimate and auto, which
/// fidelity/solve_case.hpp serves.
[[nodiscard]] Solution solve_tier(const Case& c, Tier tier, const SolveControl& control = {},
                                  std::shared_ptr<const Solids> solids = nullptr);

/// What to do where a near solution is no start.
enum class Otherwise { from_cold, failure };

/// Solves the case in one tier from the solution of a near one: the same bearing at another speed,
/// load, temperature or in a tier below; on its own grid at once, without the sequence of coarser
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
/// result carries the verdict and the last state. Throws InputError for a case with a load cycle.
[[nodiscard]] Result solve(const Case& c, const SolveControl& control = {});

}  // namespace shellback::bearing
