#pragma once
/// Are the error bars honest? Cases are solved with bars, then again on a much finer grid with more
/// nodes across the film, in the same tier and with the full physics: does the bar hold the
/// difference, and how many times too long is it?
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "coupling/result.hpp"

namespace shellback::proof {

/// Order with which truths are carried to the limit of fine grids: between the medians that
/// 100 x 13, 200 x 25 and 400 x 50 cells show on random bearings, 1.1 (tehd) to 1.5 (isothermal).
inline constexpr double kLimitOrder = 1.3;

struct HonestyCase {
  coupling::Case input;
  std::string set;  ///< whose figures are told apart: "random bearings", say
};

struct HonestyOptions {
  std::vector<coupling::Tier> tiers;
  std::vector<std::array<int, 2>> grids;  ///< whose bars are tested
  std::array<int, 2> truth_grid{400, 50};
  int truth_nodes = 7;
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(int done, int of)> progress;  ///< one call at a time; may be empty
};

/// One reported quantity against its truth.
struct BarSample {
  int subject = 0;  ///< index of the case
  coupling::Tier tier = coupling::Tier::isothermal;
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
  coupling::Tier tier = coupling::Tier::isothermal;
  std::array<int, 2> grid{0, 0};
  std::string status;
  std::string reason;
};

/// What the bars of one solve cost.
struct BarCost {
  coupling::Tier tier = coupling::Tier::isothermal;
  std::array<int, 2> grid{0, 0};
  double solve_s = 0.0;
  double bars_s = 0.0;
};

struct HonestyRecord {
  std::vector<std::string> subjects;  ///< names of the cases
  std::vector<std::string> sets;      ///< of each of them
  std::vector<bool> finished;
  std::vector<BarSample> samples;
  std::vector<HonestyRefusal> refusals;
  std::vector<BarCost> costs;
};

/// Solves all; ends soon after `stop`, keeping the cases that are finished.
[[nodiscard]] HonestyRecord measure_honesty(const std::vector<HonestyCase>& cases,
                                            const HonestyOptions& options);

/// How well a set of bars holds.
struct Coverage {
  int count = 0;        ///< of bars
  double held = NAN;    ///< part of the bars that contain the truth [-]
  double median = NAN;  ///< of bar over true error [-]
  int unknown = 0;      ///< bars that are not known
};

/// Which bar against which truth: that of the grid against the fine grid, or against the limit of
/// fine grids (a truth twice as fine is itself off by a part of the bar); that of grid and model
/// together against the full physics on the fine grid.
enum class BarKind { grid, limit, total };

/// Bar and true error of a sample, both over its natural size; false: it has no such bar, or there
/// is nothing to test (given by the case, no truth, both exact).
struct BarAgainstError {
  double bar = 0.0;
  double error = 0.0;
};
[[nodiscard]] bool testable(const BarSample& s, BarKind kind);
[[nodiscard]] BarAgainstError bar_against_error(const BarSample& s, BarKind kind);

[[nodiscard]] Coverage coverage_of(const std::vector<BarSample>& samples, BarKind kind);

}  // namespace shellback::proof
