#include "core/even_layers.hpp"

#include "core/contract.hpp"

namespace shellback {

CrossFilmNodes even_layers(int layers) {
  EXPECTS(layers >= 2 && layers <= 60);
  CrossFilmNodes set;
  const int n = layers + 1;
  const int last = layers;
  const double d = 1.0 / layers;
  set.n = n;
  const auto size = static_cast<std::size_t>(n) * n;
  for (auto* m : {&set.D, &set.Q, &set.S, &set.A}) m->assign(size, 0.0);
  for (int k = 0; k < n; ++k) {
    set.s.push_back(static_cast<double>(k) / layers);
    set.w.push_back(k == 0 || k == last ? 0.5 * d : d);
  }
  set.v = set.w;
  for (int k = 1; k < last; ++k) {
    set.D[k * n + k + 1] = 0.5 / d;
    set.D[k * n + k - 1] = -0.5 / d;
  }
  set.D[0] = set.D[last * n + last - 1] = -1.0 / d;
  set.D[1] = set.D[last * n + last] = 1.0 / d;
  for (int k = 0; k < last; ++k) {
    set.A[k * n + k] += 1.0 / d;
    set.A[(k + 1) * n + k + 1] += 1.0 / d;
    set.A[k * n + k + 1] -= 1.0 / d;
    set.A[(k + 1) * n + k] -= 1.0 / d;
  }
  set.Q[n] = d;
  for (int k = 1; k < last; ++k) {
    for (int l = 0; l < n; ++l) set.Q[(k + 1) * n + l] = set.Q[(k - 1) * n + l];
    set.Q[(k + 1) * n + k] += 2.0 * d;
  }
  for (int r = 0; r < n; ++r) {  // the alternating vector has length 1 in the weights w
    for (int c = 0; c < n; ++c) {
      const double sign = (r + c) % 2 == 0 ? 1.0 : -1.0;
      set.S[r * n + c] = (r == c ? 1.0 : 0.0) - sign * set.w[c];
    }
  }
  return set;
}

}  // namespace shellback
