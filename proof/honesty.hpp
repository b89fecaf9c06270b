#pragma once
/// Are the error bars honest? Cases are solved with bars, then again on a much finer grid with more
/// nodes across the film, in the same tier and with the full physics: does the bar hold the
/// difference, and how many times too long is it? Each case has a process and a budget of its own,
/// so that the measurement comes to an end; what could not be judged is counted.
#include <array>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "proof/honesty_record.hpp"

namespace shellback::proof {

struct HonestyCase {
  coupling::Case input;
  std::string set;  ///< whose figures are told apart: "random bearings", say
};

struct HonestyOptions {
  std::vector<coupling::Tier> tiers;
  std::vector<std::array<int, 2>> grids;  ///< whose bars are tested
  std::array<int, 2> truth_grid{400, 50};
  int truth_nodes = 7;
  int at_once = 1;         ///< cases at the same time
  double budget_s = 32.0;  ///< processor time of a case
  const std::atomic<bool>* stop = nullptr;
  std::function<void(int done, int of)> progress;  ///< may be empty
};

/// Solves all; ends soon after `stop`, keeping the cases that are finished. Must be called while
/// this process has one thread (proof/child_pool.hpp).
[[nodiscard]] HonestyRecord measure_honesty(const std::vector<HonestyCase>& cases,
                                            const HonestyOptions& options);

}  // namespace shellback::proof
