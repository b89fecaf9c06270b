#pragma once
/// What is found out about error bars: every bar beside its truth, solves that gave no result, and
/// how each case ended.
#include <array>
#include <string>
#include <vector>

#include "bearing/case.hpp"

namespace shellback::validation {

/// Order with which truths are carried to the limit of fine grids: between the medians that
/// 100 x 13, 200 x 25 and 400 x 50 cells show on random bearings, 1.1 (tehd) to 1.5 (isothermal).
inline constexpr double kLimitOrder = 1.3;

/// One reported quantity against its truth.
struct BarSample {
  int subject = 0;  ///< index of the case
  bearing::Tier tier = bearing::Tier::isothermal;
  std::array<int, 2> grid{0, 0};
  std::string quantity;
  double value = 0.0;
  double size = 0.0;  ///< natural size, to compare quantities [unit of value]
  double error_grid = 0.0;
  double error_model = 0.0;      ///< NaN: unknown, or the tier is the full physics
  double truth_tier = 0.0;       ///< fine grid, same tier; NaN: not solved
  double truth_limit = 0.0;      ///< same tier, carried to fine grids with kLimitOrder; NaN: not
  double truth_full = 0.0;       ///< fine grid, full physics; NaN: not solved
  bool given = false;            ///< the tier takes it from the case: its grid bar tells nothing
  bool richest = false;          ///< the tier is the full physics
  std::vector<double> levels{};  ///< the values that the grid bar is made of, coarsest first
  std::vector<double> sizes{};   ///< their cell sizes N^(-1/2) [-]
  double node_change = 0.0;      ///< by more nodes, on the coarse grid; NaN: not measured
  double model_change = 0.0;     ///< by the full physics, on the coarse grid; NaN: not measured
};

/// A solve that gave no result.
struct HonestyRefusal {
  int subject = 0;
  bearing::Tier tier = bearing::Tier::isothermal;
  std::array<int, 2> grid{0, 0};
  std::string status;
  std::string reason;
};

/// What the bars of one solve cost.
struct BarCost {
  bearing::Tier tier = bearing::Tier::isothermal;
  std::array<int, 2> grid{0, 0};
  double solve_s = 0.0;
  double bars_s = 0.0;
};

/// How the work on a case ended.
enum class CaseEnd {
  done,         ///< all that can be judged is
  over_budget,  ///< what it took was not granted; bars whose truth is missing are not judged
  failed,       ///< crash or exception: nothing is known of it
  stopped,      ///< from outside; not counted
};
[[nodiscard]] const char* to_string(CaseEnd end);

/// All that one case gave.
struct HonestySubject {
  CaseEnd end = CaseEnd::stopped;
  std::string why;           ///< of a failure
  double processor_s = 0.0;  ///< spent on it
  std::vector<BarSample> samples;
  std::vector<HonestyRefusal> refusals;
  std::vector<BarCost> costs;
};

/// All cases.
struct HonestyRecord {
  double budget_s = 0.0;              ///< processor time granted to a case
  std::vector<std::string> subjects;  ///< names of the cases
  std::vector<std::string> sets;      ///< of each of them
  std::vector<CaseEnd> ends;
  std::vector<std::string> whys;  ///< of failures
  std::vector<double> processor_s;
  std::vector<BarSample> samples;
  std::vector<HonestyRefusal> refusals;
  std::vector<BarCost> costs;
  /// Cases that ended so.
  [[nodiscard]] int count(CaseEnd end) const;
};

}  // namespace shellback::validation
