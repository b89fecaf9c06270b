#pragma once
/// Does tier `auto` keep what it promises, and what does it cost?
///
/// Random bearings of proof/population.hpp are solved as full TEHD with 7 nodes across the film on
/// 800 x 100 cells (the truth) and on 400 x 50, and as tier auto at several tolerances. Within:
/// friction torque and smallest film both lie within the tolerance of the truth. Limit held: the
/// bars of both hold the limit of fine grids, to which the two full solutions are carried as in
/// proof/honesty.hpp. Cost is processor time of the solving thread, all in one run; that of the
/// truth is that of a user who runs tier tehd on that grid, its ladder of coarser grids included.
#include <atomic>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace shellback::proof {

/// Tier auto on one case at one tolerance.
struct AutoAnswer {
  double tolerance = 0.0;  ///< [-]
  bool converged = false;
  bool met = false;           ///< as it claims itself
  bool holds_limit = false;   ///< both bars hold the limit of fine grids
  double off_friction = 0.0;  ///< relative distance to the truth [-]
  double off_h_min = 0.0;     ///< [-]
  double bar_friction = 0.0;  ///< claimed [-]
  double bar_h_min = 0.0;     ///< claimed [-]
  double seconds = 0.0;
  int factorizations = 0;
  std::string chosen;  ///< tier and grid
  [[nodiscard]] bool within() const;
};

/// One case. `truth_converged` false: nothing to compare with, the case is left out.
struct AutoTrial {
  int seed = 0;
  bool truth_converged = false;
  double truth_seconds = 0.0;  ///< full TEHD on 800 x 100
  double usual_seconds = 0.0;  ///< full TEHD on 400 x 50
  int truth_factorizations = 0;
  double usual_friction = 0.0;  ///< relative distance of 400 x 50 to the truth [-]
  double usual_h_min = 0.0;     ///< [-]
  std::vector<AutoAnswer> answers;
};

struct AutoStudy {
  int first_seed = 1;
  int cases = 200;
  int threads = 1;
  std::vector<double> tolerances{0.1, 0.03, 0.01, 0.003};
  const std::atomic<bool>* stop = nullptr;     ///< ends early, what is finished is kept
  std::function<void(int done, int of)> told;  ///< may be empty
};

[[nodiscard]] std::vector<AutoTrial> judge_auto(const AutoStudy& study);

/// What one tolerance came to over the trials with a truth.
struct AutoSummary {
  double tolerance = 0.0;
  int trials = 0;
  double within = 0.0;       ///< share of trials within tolerance [-]
  double met = 0.0;          ///< share that claims to have met it [-]
  double met_within = 0.0;   ///< share within, of those that claim [-]
  double holds_limit = 0.0;  ///< share whose bars hold the limit of fine grids [-]
  double mean_seconds = 0.0;
  double median_seconds = 0.0;
  double cheaper_usual = 0.0;  ///< mean cost of 400 x 50 over that of auto [-]
  double cheaper_truth = 0.0;  ///< mean cost of 800 x 100 over that of auto [-]
  double mean_tamed = 0.0;     ///< the mean of cost over that of 800 x 100, turned over [-]
  double median_usual = 0.0;   ///< median over trials of the ratio to 400 x 50 [-]
  double median_truth = 0.0;   ///< median over trials of the ratio to 800 x 100 [-]
};
[[nodiscard]] std::vector<AutoSummary> summarize(const std::vector<AutoTrial>& trials);

/// The summary as a table of text; every miss below it.
void write_auto_honesty(std::ostream& out, const std::vector<AutoTrial>& trials);

}  // namespace shellback::proof
