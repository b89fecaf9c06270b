#pragma once
/// Where a place lies between those of a table.
#include <vector>

namespace shellback {

/// The two neighbours and the weight of the right one, in [0, 1].
struct Between {
  int left = 0;
  int right = 0;
  double weight = 0.0;
};

/// Of x in `places`, sorted, at least one; beyond the first and the last those alone.
[[nodiscard]] Between between(const std::vector<double>& places, double x);

/// Of the angle x [rad, any branch] in `angles`, sorted, at least one, all within a turn: around.
[[nodiscard]] Between between_around(const std::vector<double>& angles, double x);

}  // namespace shellback
