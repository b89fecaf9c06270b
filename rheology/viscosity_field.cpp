// The loops over all nodes. This file alone is compiled with -ffast-math (see CMakeLists.txt),
// which lets the compiler call the vector versions of exp and log; nothing here relies on the
// semantics of infinities or non-numbers. In release builds the law functions are inlined into the
// loops: no copy of them compiled with these flags is left for other files to link against.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <variant>

#include "core/contract.hpp"
#include "rheology/pressure.hpp"
#include "rheology/shear.hpp"
#include "rheology/temperature.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::rheology {
namespace {

template <class Pressure, class Temperature>
void viscosity_loop(const Pressure pressure, const Temperature temperature, std::size_t n,
                    const double* __restrict T, const double* __restrict p,
                    double* __restrict eta) {
  for (std::size_t i = 0; i < n; ++i) {
    eta[i] = std::exp(log_viscosity(pressure, temperature, T[i], p[i]).value);
  }
}

template <class Pressure, class Temperature>
void slope_loop(const Pressure pressure, const Temperature temperature, std::size_t n,
                const double* __restrict T, const double* __restrict p, double* __restrict slope) {
  for (std::size_t i = 0; i < n; ++i) {
    slope[i] = log_viscosity(pressure, temperature, T[i], p[i]).dp;
  }
}

/// Nodes that iterate together: small enough for the first-level cache, large enough to fill the
/// vector unit [-].
constexpr std::size_t kBlock = 256;
/// Stress below which there is no thinning in any digit; keeps logarithms finite [Pa].
constexpr double kNoStress = 1e-290;
/// Largest Newton step after which the next one is below round-off, because the error squares [-].
constexpr double kLastStep = 1e-8;

/// Cross law at a logarithmic rate w = ln(K rate): ln f and d ln f / d w.
struct LogFactor {
  double value;
  double slope;
};
[[gnu::always_inline]] inline LogFactor log_factor(double r, double m, double w) {
  const double s = m * w;
  const double v = std::exp(-std::abs(s));  // u or 1/u, whichever is below 1
  const double top = s > 0.0 ? v + r : 1.0 + r * v;
  const double bottom = 1.0 + v;
  return {std::log(top / bottom), -m * (1.0 - r) * v / (top * bottom)};
}

/// Solves G(w) = w + ln f(w) - L = 0, L = ln(K |tau| / eta_low), w = ln(K rate), for a block.
///
/// Why it has one root and Newton finds it. G' = 1 + d ln f/d ln rate > 0 where the stress is
/// monotone (shear.hpp), G -> -inf and +inf at the ends (f lies between r and 1): one root. It
/// lies in [L, L - ln r]. ln f has its only inflection at w_i = -ln(r)/(2 m), where u = 1/sqrt(r):
/// G is concave below and convex above. G(w_i) tells the side of the root. Kept on that side,
/// Newton's first step lands beyond the root as seen from w_i, on the steep side of a convex
/// (concave) increasing function, and from there approaches it monotonically and quadratically.
class CrossBlock {
 public:
  CrossBlock(const Cross& law, std::size_t n) : law_(law), n_(n) {}

  void start(const double* __restrict eta_low, const double* __restrict tau,
             const double* __restrict guess) {
    const double r = law_.r;
    const double ln_r = r > 0.0 ? std::log(r) : -kFar;
    const double w_i = std::min(-0.5 * ln_r / law_.m, kFar);
    const double at_inflection = w_i + 0.5 * ln_r;  // w_i + ln f(w_i), f(w_i) = sqrt(r)
    for (std::size_t i = 0; i < n_; ++i) {
      const double K_tau = law_.K * std::max(std::abs(tau[i]), kNoStress);
      const double L = std::log(K_tau / eta_low[i]);
      const bool above = L > at_inflection;
      // No guess: the Newtonian rate L, left of the root, put on the root's side of w_i.
      const double w = std::log(K_tau / (guess[i] > 0.0 ? guess[i] : eta_low[i]));
      L_[i] = L;
      low_[i] = above ? std::max(L, w_i) : L;
      high_[i] = above ? L - ln_r : std::min(L - ln_r, w_i);
      w_[i] = std::min(std::max(w, low_[i]), high_[i]);
    }
  }

  /// One Newton step of every node; returns the largest |step| and leaves f after the step.
  double step() {
    const double r = law_.r, m = law_.m;
    double largest = 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
      const LogFactor f = log_factor(r, m, w_[i]);
      const double wish = w_[i] - (w_[i] + f.value - L_[i]) / (1.0 + f.slope);
      const double w = std::min(std::max(wish, low_[i]), high_[i]);
      const double d = w - w_[i];
      ln_f_[i] = f.value + f.slope * d;
      w_[i] = w;
      largest = std::max(largest, std::abs(d));
    }
    return largest;
  }

  void finish(const double* __restrict eta_low, double* __restrict eta) const {
    for (std::size_t i = 0; i < n_; ++i) eta[i] = eta_low[i] * std::exp(ln_f_[i]);
  }

 private:
  static constexpr double kFar = 1e4;  ///< beyond any logarithm of a double [-]
  Cross law_;
  std::size_t n_;
  alignas(64) std::array<double, kBlock> L_, low_, high_, w_, ln_f_;
};

}  // namespace

void viscosity(const Oil& oil, std::span<const double> T, std::span<const double> p,
               std::span<double> eta) {
  EXPECTS(T.size() == eta.size() && p.size() == eta.size());
  std::visit(
      [&](const auto& pressure, const auto& temperature) {
        viscosity_loop(pressure, temperature, eta.size(), T.data(), p.data(), eta.data());
      },
      oil.pressure, oil.temperature);
}

void pressure_slope(const Oil& oil, std::span<const double> T, std::span<const double> p,
                    std::span<double> slope) {
  EXPECTS(T.size() == slope.size() && p.size() == slope.size());
  std::visit(
      [&](const auto& pressure, const auto& temperature) {
        slope_loop(pressure, temperature, slope.size(), T.data(), p.data(), slope.data());
      },
      oil.pressure, oil.temperature);
}

void shear_thinned(const Oil& oil, std::span<const double> eta_low, std::span<const double> tau,
                   std::span<double> eta, int steps) {
  EXPECTS(eta_low.size() == eta.size() && tau.size() == eta.size());
  const Cross* law = std::get_if<Cross>(&oil.shear);
  if (law == nullptr || law->K == 0.0 || law->r == 1.0) {
    std::copy(eta_low.begin(), eta_low.end(), eta.begin());
    return;
  }
  if (!stress_is_monotone(*law)) {
    throw InputError(
        "the Cross law of the oil gives one shear stress at several shear rates "
        "(m (1 - sqrt r) must be below 1 + sqrt r); give a larger r or a smaller m");
  }
  for (std::size_t from = 0; from < eta.size(); from += kBlock) {
    const std::size_t n = std::min(kBlock, eta.size() - from);
    CrossBlock block(*law, n);
    block.start(&eta_low[from], &tau[from], &eta[from]);
    for (int k = 0; k < steps && block.step() > kLastStep; ++k) {
    }
    block.finish(&eta_low[from], &eta[from]);
  }
}

}  // namespace shellback::rheology
