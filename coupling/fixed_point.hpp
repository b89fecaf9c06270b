#pragma once
/// Fixed points x = G(x) with Anderson acceleration, by SUNDIALS' KINSOL (KIN_FP).
#include <functional>
#include <vector>

namespace shellback::coupling {

struct FixedPointOptions {
  int depth = 5;  ///< vectors kept, not more than x has components [-]
  int delay = 1;  ///< plain iterations before acceleration [-]
  int max_iterations = 100;
  double tolerance = 1e-6;  ///< largest |G(x) - x| [-]
};

enum class FixedPointEnd { converged, iteration_limit, map_failed };

/// `map(x, g)` sets g = G(x) and returns false to give up. `x` holds the last iterate.
[[nodiscard]] FixedPointEnd fixed_point(
    const std::function<bool(const std::vector<double>&, std::vector<double>&)>& map,
    const FixedPointOptions& options, std::vector<double>& x);

}  // namespace shellback::coupling
