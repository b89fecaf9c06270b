#include "core/cross_film_nodes.hpp"

namespace shellback {

std::vector<double> conduction_of(const CrossFilmNodes& set) {
  const int n = set.n;
  std::vector<double> a(static_cast<std::size_t>(n) * n, 0.0);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      for (int m = 0; m < n; ++m) a[r * n + c] += set.D[m * n + r] * set.w[m] * set.D[m * n + c];
    }
  }
  return a;
}

}  // namespace shellback
