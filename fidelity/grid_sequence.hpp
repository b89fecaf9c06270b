#pragma once
/// The same case beside its result: on other grids, with more nodes. What the bars are made of.
///
/// One coarse solve of the film costs a few Newton iterations of the fine grid; what another number
/// of nodes or richer physics changes there is nearly what it changes on the fine grid.
#include <cmath>

#include "bearing/steady/solve.hpp"
#include "fidelity/kept_solids.hpp"

namespace shellback::fidelity {

/// Cells around and along the full width.
using Grid = std::array<int, 2>;

/// Size of its cells, in a unit of its own.
[[nodiscard]] inline double cell_size(const Grid& g) { return 1.0 / std::sqrt(g[0] * g[1]); }

/// Beyond it one more grid takes longer than all else; what no sequence of grids tells is solved
/// there as it is.
inline constexpr Grid kUsualGrid{400, 50};

/// Refinement of each direction between grids that can be told apart, where they are not halved
/// [-].
inline constexpr double kRefinement = 1.4;
inline constexpr int kMoreNodes = 2;  ///< across the film; their number stays odd [-]

/// Grids coarser than that of the case, from the coarsest on, each axis about halved, or 0.7 of it
/// where that leaves fewer than two; down to 20 x 3. Where a grid cannot resolve the edges of the
/// supplies, or shows no foot of an opening at the ends that the case's own grid shows, it gets as
/// many more cells as it takes, along and then around; grids that come to the fine one are left
/// out.
[[nodiscard]] std::vector<Grid> coarse_grids(const bearing::Case& c);

/// The last two of them: what bars of whole runs in time are made of.
[[nodiscard]] std::vector<Grid> nearest_coarse_grids(const bearing::Case& c);

/// The next finer one than that of the case, kRefinement times in each direction, along as far as
/// there may be cells; none beyond the usual grid.
[[nodiscard]] std::optional<Grid> finer_grid(const bearing::Case& c);

/// The case, in the tier and on the grid that it names, from a solution that is near (other grid,
/// physics or nodes, same bearing), from cold if that does not converge; none if this does not
/// either or the grid cannot carry the supplies. Tells nothing, stops with the others. `work`: the
/// work of it is added [cells].
[[nodiscard]] std::optional<bearing::Solution> solve_near(const bearing::Case& c,
                                                          const bearing::Solution& near,
                                                          const bearing::SolveControl& control,
                                                          double* work = nullptr);

/// The solution with two more nodes across the film; none if there is none.
[[nodiscard]] std::optional<bearing::Solution> with_more_nodes(
    const bearing::Solution& s, const bearing::SolveControl& control);

/// Scalars in the tier that the solution's case names.
[[nodiscard]] std::vector<bearing::Quantity> scalars(const bearing::Solution& s);

struct GridSequence {
  /// Same tier, solved to the end on the coarsest grid that has a solution; on the result's own
  /// grid where no coarser one has.
  std::optional<bearing::Solution> coarse;
  std::vector<bearing::LevelRecord> levels;  ///< from the coarsest to the finest
};

/// Three grids if possible, the result's own the last; where no coarser grid gives a solution (too
/// few cells for the supplies, contact that they cannot place), its own and one that is finer. The
/// finer one, too, on less than 200 x 25 cells where heat is mostly made by summits: a coarse grid
/// may then stand on another branch than fine ones, and its coarser ones with it.
/// Each is solved from `s`. `kept` may be null.
[[nodiscard]] GridSequence grid_sequence(const bearing::Solution& s,
                                         const bearing::SolveControl& control, KeptSolids* kept);

}  // namespace shellback::fidelity
