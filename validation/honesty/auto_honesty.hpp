#pragma once
/// Does tier `auto` keep what it promises, and what does it cost?
///
/// Random bearings of validation/honesty/population.hpp are solved as tier auto at several
/// tolerances, then as full TEHD with 7 nodes across the film on 400 x 50 and on 800 x 100 cells
/// (the truth). Within: friction torque and smallest film both lie within the tolerance of the
/// truth. Truth held, limit held: the bars of both hold the truth, and the limit of fine grids, to
/// which the two full solutions are carried as in validation/honesty/honesty.hpp. Cost is processor
/// time of the solving thread, all in one run; that of the truth is that of a user who runs tier
/// tehd on that grid, its ladder of coarser grids included. Each bearing has a process and a budget
/// of its own; what the budget does not reach is counted as not judged.
#include <atomic>
#include <functional>
#include <vector>

#include "validation/honesty/auto_record.hpp"

namespace shellback::validation {

struct AutoStudy {
  int first_seed = 1;
  int cases = 200;
  int at_once = 1;         ///< cases at the same time
  double budget_s = 32.0;  ///< processor time of a case
  std::vector<double> tolerances{0.1, 0.03, 0.01, 0.003};
  const std::atomic<bool>* stop = nullptr;     ///< ends early, what is finished is kept
  std::function<void(int done, int of)> told;  ///< may be empty
};

/// Trials by seed, stopped ones left out. Must be called while this process has one thread
/// (validation/honesty/child_pool.hpp).
[[nodiscard]] std::vector<AutoTrial> judge_auto(const AutoStudy& study);

}  // namespace shellback::validation
