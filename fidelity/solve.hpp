#pragma once
/// One case, one tier, one result with error bars: what `run` calls.
#include "fidelity/model_error.hpp"

namespace shellback::fidelity {

/// What the bars are made of.
struct BarRecord {
  std::optional<CoarseSolution> coarse;  ///< same tier, solved to the end
  /// Change of each quantity by two more nodes across the film, on the coarse grid.
  std::vector<coupling::Quantity> node_change;
  std::vector<coupling::LevelRecord> levels;  ///< grids used, the result's own the last
  ModelError model;
  double wall_s = 0.0;
};

/// Solves what the bars of a converged solution need.
[[nodiscard]] BarRecord measure_bars(const coupling::Solution& s, coupling::Tier tier,
                                     const coupling::SolveControl& control = {});

/// Puts the bars into the result: error_grid and error_model of each quantity, changes of the
/// effects, words on what is not known.
void put_bars(const BarRecord& record, coupling::Result& result);

/// coupling::summarize with bars; the cost stands in cost.bars_s, apart from the solve. Results
/// that did not converge get no bars.
[[nodiscard]] coupling::Result summarize(const coupling::Solution& s, coupling::Tier tier,
                                         const coupling::SolveControl& control = {});

/// Solves the case in its tier (isothermal, lumped, thd or tehd). Does not throw for lack of
/// convergence: the result carries the verdict and the last state.
[[nodiscard]] coupling::Result solve(const coupling::Case& c,
                                     const coupling::SolveControl& control = {});

}  // namespace shellback::fidelity
