#pragma once
/// Results that cannot be told apart: their difference is within the bars of their grids
/// (fidelity::told_apart). Judged for friction torque and smallest film.
#include <string>
#include <vector>

#include "app/study/sweep.hpp"

namespace shellback::app {

/// Two results of a comparison, or two points of a sweep, whose order is open.
struct Indistinct {
  std::string quantity;
  int first = 0;  ///< index of Comparison::results or Sweep::points
  int second = 0;
  int axis = 0;  ///< sweep: the one on which they differ
};

/// Every pair.
[[nodiscard]] std::vector<Indistinct> indistinct(const bearing::Comparison& comparison);

/// Pairs that differ on one axis only: neighbours where it holds numbers, every pair where it holds
/// words (materials, tiers, grids).
[[nodiscard]] std::vector<Indistinct> indistinct(const study::Sweep& sweep);

/// One sentence each; for neighbours on an axis of numbers a count.
[[nodiscard]] std::vector<std::string> indistinct_words(const bearing::Comparison& comparison);
[[nodiscard]] std::vector<std::string> indistinct_words(const study::Sweep& sweep);

}  // namespace shellback::app
