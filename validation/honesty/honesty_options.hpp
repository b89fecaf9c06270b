#pragma once
/// What is measured on whether error bars hold, and how.
#include <array>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "bearing/case.hpp"

namespace shellback::validation {

struct HonestyCase {
  bearing::Case input;
  std::string set;  ///< whose figures are told apart: "random bearings", say
};

struct HonestyOptions {
  std::vector<bearing::Tier> tiers;
  std::vector<std::array<int, 2>> grids;  ///< whose bars are tested
  std::array<int, 2> truth_grid{400, 50};
  int truth_nodes = 7;
  int at_once = 1;         ///< cases at the same time
  double budget_s = 32.0;  ///< processor time of a case
  const std::atomic<bool>* stop = nullptr;
  std::function<void(int done, int of)> progress;  ///< may be empty
};

}  // namespace shellback::validation
