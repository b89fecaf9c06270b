#pragma once
/// What is found out about tier `auto`: its answers beside their truth.
#include <string>
#include <vector>

#include "validation/honesty/honesty_record.hpp"

namespace shellback::validation {

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

}  // namespace shellback::validation
