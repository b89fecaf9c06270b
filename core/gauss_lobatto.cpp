#include "core/gauss_lobatto.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback {
namespace {

/// P_m(x) and P_{m-1}(x).
struct Legendre {
  double p;
  double previous;
};
Legendre legendre(int m, double x) {
  double p = 1.0;
  double previous = 0.0;
  for (int k = 1; k <= m; ++k) {
    const double next = ((2.0 * k - 1.0) * x * p - (k - 1.0) * previous) / k;
    previous = p;
    p = next;
  }
  return {p, previous};
}

/// Nodes on [-1, 1]: Newton on (1 - x^2) P'_{n-1}(x), from the Chebyshev-Lobatto nodes.
std::vector<double> nodes(int n) {
  std::vector<double> x(n);
  const int m = n - 1;
  for (int k = 0; k < n; ++k) {
    double t = -std::cos(kPi * k / m);
    for (int it = 0; it < 50 && k > 0 && k < m; ++it) {
      const Legendre L = legendre(m, t);
      const double f = m * (L.previous - t * L.p);  // (1 - t^2) P'_m
      const double df = -m * (m + 1.0) * L.p;       // its derivative
      const double dt = f / df;
      t -= dt;
      if (std::abs(dt) < 1e-16) break;
    }
    x[k] = t;
  }
  x.front() = -1.0;
  x.back() = 1.0;
  return x;
}

}  // namespace

CrossFilmNodes gauss_lobatto(int n) {
  EXPECTS(n >= 3 && n <= 32);
  CrossFilmNodes gl;
  gl.n = n;
  const int m = n - 1;
  const std::vector<double> x = nodes(n);
  std::vector<double> top(n);  // P_{n-1} at the nodes
  for (int k = 0; k < n; ++k) {
    top[k] = legendre(m, x[k]).p;
    gl.s.push_back(0.5 * (x[k] + 1.0));
    gl.w.push_back(1.0 / (m * n * top[k] * top[k]));
  }
  const auto size = static_cast<std::size_t>(n) * n;
  gl.D.assign(size, 0.0);
  gl.Q.assign(size, 0.0);
  gl.S.assign(size, 0.0);
  for (int i = 0; i < n; ++i) {
    double sum = 0.0;
    for (int j = 0; j < n; ++j) {
      if (i == j) continue;
      gl.D[i * n + j] = 2.0 * top[i] / (top[j] * (x[i] - x[j]));
      sum += gl.D[i * n + j];
    }
    gl.D[i * n + i] = -sum;  // a constant has no derivative, to round-off
  }
  // Running integrals: l_j = sum_k c_k P_k with c_k = w_j P_k(x_j)/norm_k, and
  // int_{-1}^x P_k = (P_{k+1} - P_{k-1})/(2k + 1).
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      double integral = 0.0;
      for (int k = 0; k < n; ++k) {
        const double norm = k == m ? 2.0 / m : 2.0 / (2.0 * k + 1.0);
        const double c = 2.0 * gl.w[j] * legendre(k, x[j]).p / norm;
        const double upper = legendre(k + 1, x[i]).p;
        const double lower = k == 0 ? -1.0 : legendre(k - 1, x[i]).p;
        integral += c * (upper - lower) / (2.0 * k + 1.0);
      }
      gl.Q[i * n + j] = 0.5 * integral;
      const double c_top = 2.0 * gl.w[j] * top[j] / (2.0 / m);
      gl.S[i * n + j] = (i == j ? 1.0 : 0.0) - c_top * top[i];
    }
  }
  gl.v = gl.w;
  gl.A = conduction_of(gl);
  return gl;
}

}  // namespace shellback
