#pragma once
/// Where a sequence leads to that nears its limit by a few modes.
#include <optional>
#include <vector>

namespace shellback {

/// An iterate of a fixed point x = G(x).
struct Iterate {
  std::vector<double> x, g;  ///< x and G(x)
};

/// Where two or more iterates lead, in a sequence or not:
///   s = sum_j gamma_j g_j,   |sum_j gamma_j (g_j - x_j)| least,   sum_j gamma_j = 1.
/// Exact for a linear G and a sequence of n + 1 iterates that nears, or leaves, its limit in n
/// modes, however slowly. None if the differences are not finite, or all alike. Source: textbook
/// (Anderson's acceleration; of a sequence it is Sidi's reduced rank extrapolation).
[[nodiscard]] std::optional<std::vector<double>> extrapolated(const std::vector<Iterate>& of);

}  // namespace shellback
