#pragma once
/// One steady case, one tier, one result with error bars.
#include "fidelity/grid_sequence.hpp"
#include "fidelity/land_error.hpp"
#include "fidelity/left_out.hpp"
#include "fidelity/quantities.hpp"

namespace shellback::fidelity {

/// What the bars are made of.
struct BarRecord {
  std::array<int, 2> grid{0, 0};            ///< that of the result
  std::optional<bearing::Solution> coarse;  ///< same tier, solved to the end; grid_sequence.hpp
  /// What more nodes across the film change each quantity by, on the coarse grid.
  std::vector<bearing::Quantity> node_change;
  std::vector<bearing::LevelRecord> levels;  ///< grids used, from the coarsest on
  double edge = 0.0;                         ///< of the smallest film, edge_error.hpp [m]
  LandError lands;                           ///< of few cells beside supplies
  CellsOfSupplies alike;                     ///< that all grids give them; 0: not as many
  ModelError model;
  double wall_s = 0.0;
};

/// Which bars: a bar of the physics left out takes the solves of all richer physics.
enum class WantedBars { grid, grid_and_model };

/// Solves what the bars of a converged solution need. With `kept`, for many near solutions, the
/// operators of the solids on coarse grids are kept.
[[nodiscard]] BarRecord measure_bars(const bearing::Solution& s, bearing::Tier tier,
                                     const bearing::SolveControl& control = {},
                                     WantedBars bars = WantedBars::grid_and_model,
                                     KeptSolids* kept = nullptr);

/// Puts the bars into the result: error_grid and error_model of each quantity, changes of the
/// effects, words on what is not known.
void put_bars(const BarRecord& record, bearing::Result& result);

/// bearing::summarize with bars; the cost stands in cost.bars_s, apart from the solve. Results
/// that did not converge get no bars.
[[nodiscard]] bearing::Result summarize(const bearing::Solution& s, bearing::Tier tier,
                                        const bearing::SolveControl& control = {},
                                        WantedBars bars = WantedBars::grid_and_model,
                                        KeptSolids* kept = nullptr);

/// Solves the case in its tier (isothermal, lumped, thd or tehd). Does not throw for lack of
/// convergence: the result carries the verdict and the last state.
[[nodiscard]] bearing::Result solve(const bearing::Case& c,
                                    const bearing::SolveControl& control = {});

}  // namespace shellback::fidelity
