#pragma once
/// Does tier `auto` keep what it promises, and what does it cost?
///
/// Random bearings of proof/population.hpp are solved as tier auto at several tolerances, then as
/// full TEHD with 7 nodes across the film on 400 x 50 and on 800 x 100 cells (the truth). Within:
/// friction torque and smallest film both lie within the tolerance of the truth. Truth held, limit
/// held: the bars of both hold the truth, and the limit of fine grids, to which the two full
/// solutions are carried as in proof/honesty.hpp. Cost is processor time of the solving thread, all
/// in one run; that of the truth is that of a user who runs tier tehd on that grid, its ladder of
/// coarser grids included. Each bearing has a process and a budget of its own; what the budget does
/// not reach is counted as not judged.
#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "proof/honesty_record.hpp"

namespace shellback::proof {

/// Tier auto on one case at one tolerance.
struct AutoAnswer {
  double tolerance = 0.0;  ///< [-]
  bool converged = false;
  bool met = false;             ///< as it claims itself
  double friction = 0.0;        ///< friction torque [N m]
  double h_min = 0.0;           ///< smallest film [m]
  double error_friction = 0.0;  ///< its whole bar [N m]
  double error_h_min = 0.0;     ///< [m]
  double bar_friction = 0.0;    ///< claimed, relative [-]
  double bar_h_min = 0.0;       ///< claimed, relative [-]
  double seconds = 0.0;
  int factorizations = 0;
  std::string tier;    ///< chosen; empty: none
  std::string chosen;  ///< tier and grid
  /// Against the truth, once it is known:
  double off_friction = 0.0;  ///< relative distance to it [-]
  double off_h_min = 0.0;     ///< [-]
  bool holds_truth = false;   ///< both bars hold it
  bool holds_limit = false;   ///< both bars hold the limit of fine grids
  [[nodiscard]] bool within() const;
};

/// One case. Without a converged truth there is nothing to compare with.
struct AutoTrial {
  int seed = 0;
  CaseEnd end = CaseEnd::stopped;
  std::string why;           ///< of a failure, or of a truth that was refused
  double processor_s = 0.0;  ///< spent on it
  bool truth_converged = false;
  double truth_seconds = 0.0;  ///< full TEHD on 800 x 100
  double usual_seconds = 0.0;  ///< full TEHD on 400 x 50
  int truth_factorizations = 0;
  double usual_friction = 0.0;        ///< relative distance of 400 x 50 to the truth [-]
  double usual_h_min = 0.0;           ///< [-]
  std::vector<AutoAnswer> answers{};  ///< those that the budget reached, by tolerance
};

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
/// (proof/child_pool.hpp).
[[nodiscard]] std::vector<AutoTrial> judge_auto(const AutoStudy& study);

}  // namespace shellback::proof
