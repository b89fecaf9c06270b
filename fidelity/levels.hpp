#pragma once
/// The same case on the grids beside that of its result: what the bars of the grid are made of.
#include <mutex>

#include "fidelity/coarse_solution.hpp"

namespace shellback::fidelity {

/// Operators of the solids on coarse grids, kept from one solution to the next that is near to it:
/// setting them up takes as long as solving the film there. May be used by several threads.
class KeptSolids {
 public:
  /// Those of the case's bodies on the grid; null: none are kept.
  [[nodiscard]] std::shared_ptr<const coupling::Solids> find(const coupling::Case& c,
                                                             std::array<int, 2> grid) const;
  void keep(const CoarseSolution& s);

 private:
  struct Entry {
    std::optional<coupling::Shell> shell;
    std::optional<coupling::Shaft> shaft;
    std::array<int, 2> grid{0, 0};
    std::shared_ptr<const coupling::Solids> solids;
  };
  mutable std::mutex guard_;
  std::vector<Entry> entries_;  ///< the latest last
};

struct Levels {
  /// Same tier, solved to the end on the coarsest grid that has a solution; on the result's own
  /// grid where no coarser one has.
  std::optional<CoarseSolution> coarse;
  std::vector<coupling::LevelRecord> all;  ///< from the coarsest to the finest
};

/// Three grids if possible, the result's own the last; where no coarser grid gives a solution (too
/// few cells for the supplies, contact that they cannot place), its own and one that is finer.
/// Coarse grids are solved from cold, each for itself, and from `s` where that fails. With `kept`
/// the other way round: at a few Newton iterations each, for many near solutions.
[[nodiscard]] Levels levels_around(const coupling::Solution& s, coupling::Tier tier,
                                   const coupling::SolveControl& control, KeptSolids* kept);

}  // namespace shellback::fidelity
