#pragma once
/// What the trials of tier auto came to: shares with their intervals, costs, misses, and what could
/// not be judged.
#include <iosfwd>
#include <string>
#include <vector>

#include "validation/honesty/auto_honesty.hpp"
#include "validation/honesty/wilson.hpp"

namespace shellback::validation {

/// A share that was counted.
struct Share {
  int held = 0;
  int of = 0;
  [[nodiscard]] double value() const;  ///< NaN: of none
  [[nodiscard]] ShareInterval interval() const { return wilson(held, of); }
};

/// What one tolerance came to.
struct AutoSummary {
  double tolerance = 0.0;
  Share without_truth;  ///< of the converged answers: those without a converged truth
  Share no_answer;      ///< of all trials: those that the budget or a failure kept from an answer
  /// Over the answers with a truth:
  Share within;       ///< tolerance
  Share met;          ///< claims to have met it
  Share met_within;   ///< within, of those that claim
  Share holds_truth;  ///< both bars hold the truth
  Share holds_limit;  ///< both bars hold the limit of fine grids
  double mean_seconds = 0.0;
  double median_seconds = 0.0;
  double cheaper_usual = 0.0;  ///< mean cost of 400 x 50 over that of auto [-]
  double cheaper_truth = 0.0;  ///< mean cost of 800 x 100 over that of auto [-]
  double mean_tamed = 0.0;     ///< the mean of cost over that of 800 x 100, turned over [-]
  double median_usual = 0.0;   ///< median over trials of the ratio to 400 x 50 [-]
  double median_truth = 0.0;   ///< median over trials of the ratio to 800 x 100 [-]
};
[[nodiscard]] std::vector<AutoSummary> summarize(const std::vector<AutoTrial>& trials,
                                                 const std::vector<double>& tolerances);

/// The tables; every case not judged and every miss below.
void write_auto_honesty(std::ostream& out, const std::vector<AutoTrial>& trials,
                        const AutoStudy& study);

/// Summary with intervals and all trials.
[[nodiscard]] std::string auto_honesty_json(const std::vector<AutoTrial>& trials,
                                            const AutoStudy& study);

}  // namespace shellback::validation
