#pragma once
/// The film of a solution once more, with temperatures and deformation held: on a finer grid, or
/// with one effect taken out.
///
/// A solution's temperatures, elastic widening and thermal deformation are given fields here; film,
/// contact and journal position are solved anew. On the solution's own grid with everything in,
/// the answer is the solution itself. On a finer grid it shows what the film's discretisation was
/// worth, without the effect, what the effect is worth directly (what it does to temperatures
/// and deformation is not counted); both at the price of a rigid isothermal film.
#include <atomic>

#include "bearing/steady/solve.hpp"

namespace shellback::fidelity {

/// What of the solution the film keeps.
struct Held {
  bearing::Physics physics;  ///< of which effects; without film_energy: columns at their mean
  bool heated = true;        ///< false: everywhere at the supply temperature
  double warmer = 0.0;       ///< added to every temperature [K]
};

/// `s` must have converged. The returned solution has no heat; `heat.thermal_deformation` is all
/// the widening.
[[nodiscard]] bearing::Solution held_film(const bearing::Solution& s, std::array<int, 2> grid,
                                          const Held& held,
                                          const std::atomic<bool>* stop = nullptr);

}  // namespace shellback::fidelity
