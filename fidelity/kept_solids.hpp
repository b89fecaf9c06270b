#pragma once
/// Operators of the solids on coarse grids, kept from one solution to the next that is near to it:
/// setting them up takes as long as solving the film there. Whether they are those of the bodies at
/// hand, make_bearing judges. May be used by several threads.
#include <map>
#include <mutex>

#include "bearing/bearing.hpp"

namespace shellback::fidelity {

class KeptSolids {
 public:
  using Kept = std::shared_ptr<const bearing::Solids>;

  /// The latest of the grid; null: none.
  [[nodiscard]] Kept find(const std::array<int, 2>& grid) const {
    const std::lock_guard lock(guard_);
    const auto kept = solids_.find(grid);
    return kept == solids_.end() ? nullptr : kept->second;
  }
  void keep(const bearing::BearingModel& model) {
    const std::lock_guard lock(guard_);
    if (model.solids) solids_[model.input.model.grid] = model.solids;
  }

 private:
  mutable std::mutex guard_;
  std::map<std::array<int, 2>, Kept> solids_;
};

}  // namespace shellback::fidelity
