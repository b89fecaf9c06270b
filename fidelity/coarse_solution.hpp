#pragma once
/// Solutions on coarse grids of the ladder, to the end: on these the error bars are measured.
///
/// One coarse solve of the film costs a few Newton iterations of the fine grid; what another number
/// of nodes or richer physics changes there is nearly what it changes on the fine grid.
#include <optional>

#include "coupling/solve.hpp"

namespace shellback::fidelity {

struct CoarseSolution {
  coupling::Case input;  ///< the case with the coarse grid
  coupling::Tier tier = coupling::Tier::isothermal;
  coupling::Solution solution;
  std::vector<coupling::Quantity> quantities;
};

/// Grids coarser than `fine` that are worth a solve, from the coarsest on: those of the solver's
/// own ladder, or, below a fine grid too coarse for three of these, grids of 0.7 times the cells in
/// each direction, down to 20 x 3.
[[nodiscard]] std::vector<std::array<int, 2>> coarse_grids(std::array<int, 2> fine);

/// The same for the supplies of the case: where a grid cannot resolve their edges, it gets as many
/// more cells as it takes, along and then around; grids that come to the fine one are left out.
[[nodiscard]] std::vector<std::array<int, 2>> coarse_grids(const coupling::Case& c);

/// A grid finer than that of the case by as little as tells the two apart.
[[nodiscard]] std::array<int, 2> next_finer(std::array<int, 2> grid);

/// The case on `grid` in one tier, from cold; none if that does not converge or the grid cannot
/// carry the supplies.
[[nodiscard]] std::optional<CoarseSolution> solve_coarse(const coupling::Case& c,
                                                         coupling::Tier tier,
                                                         std::array<int, 2> grid,
                                                         const coupling::SolveControl& control);

/// The case of `s`, solved, on another grid: from `s` itself, which is a few Newton iterations
/// away; none if that does not converge or the grid cannot carry the supplies. `solids`: operators
/// of a former solve on that grid, if there was one.
[[nodiscard]] std::optional<CoarseSolution> solve_beside(
    const coupling::Solution& s, coupling::Tier tier, std::array<int, 2> grid,
    std::shared_ptr<const coupling::Solids> solids, const coupling::SolveControl& control);

/// The changed case (other physics, other nodes, same bearing and grid) from the solution `near`;
/// from cold if that does not converge; none if this does not either.
[[nodiscard]] std::optional<CoarseSolution> solve_changed(const coupling::Case& changed,
                                                          coupling::Tier tier,
                                                          const CoarseSolution& near,
                                                          const coupling::SolveControl& control);

/// Value of `name` in `list`; not-a-number if it is not there.
[[nodiscard]] double value_in(const std::vector<coupling::Quantity>& list, const std::string& name);

}  // namespace shellback::fidelity
