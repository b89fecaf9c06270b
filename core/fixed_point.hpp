#pragma once
/// Fixed points x = G(x) with Anderson acceleration, by SUNDIALS' KINSOL (KIN_FP).
#include <functional>
#include <limits>
#include <vector>

#include "core/round_off.hpp"

namespace shellback {

struct FixedPointOptions {
  int depth = 5;  ///< vectors kept, not more than x has components [-]
  int delay = 1;  ///< plain iterations before acceleration, doubled each time that it is lost [-]
  int max_iterations = kMostIterations;
  double tolerance = 1e-6;  ///< largest |G(x) - x| [-]
  /// The change may be this many times larger where it falls so fast that G(x) is within the
  /// tolerance of the fixed point: with rho the larger of the last two ratios of changes, the
  /// distance is about rho/(1 - rho) |G(x) - x| (Banach). 1: the change alone counts [-]
  double slack = 1.0;
  /// An x that lies further than this from the last G(x) in any component is not tried: least
  /// squares of changes that hardly differ throw it there. It begins anew at G(x) [-]
  double reach = std::numeric_limits<double>::infinity();
};

enum class FixedPointEnd { converged, iteration_limit, map_failed };

/// `map(x, g)` sets g = G(x) and returns false to give up. `x` holds the last iterate; where
/// `slack` has been made use of it is G(x) that is near enough.
[[nodiscard]] FixedPointEnd fixed_point(
    const std::function<bool(const std::vector<double>&, std::vector<double>&)>& map,
    const FixedPointOptions& options, std::vector<double>& x);

}  // namespace shellback
