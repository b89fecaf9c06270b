// The loops over all nodes. This file alone is compiled with -ffast-math (see CMakeLists.txt),
// which lets the compiler call the vector versions of exp and log; nothing here relies on the
// semantics of infinities or non-numbers. In release builds the law functions are inlined into the
// loops: no copy of them compiled with these flags is left for other files to link against.
#include <algorithm>
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

/// Shear rate below which there is no thinning in any digit; keeps logarithms finite [-].
constexpr double kNoRate = 1e-290;

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

void shear_factors(const Oil& oil, std::span<const double> rate, std::span<double> factor,
                   std::span<double> slope) {
  EXPECTS(rate.size() == factor.size() && rate.size() == slope.size());
  const Cross* law = std::get_if<Cross>(&oil.shear);
  if (law == nullptr) {
    std::fill(factor.begin(), factor.end(), 1.0);
    std::fill(slope.begin(), slope.end(), 0.0);
    return;
  }
  const double K = law->K, r = law->r, m = law->m;
  for (std::size_t i = 0; i < rate.size(); ++i) {
    const double s = m * std::log(std::max(K * rate[i], kNoRate));
    const double v = std::exp(-std::abs(s));  // u or 1/u, whichever is below 1
    const double top = s > 0.0 ? v + r : 1.0 + r * v;
    const double bottom = 1.0 + v;
    factor[i] = top / bottom;
    slope[i] = -m * (1.0 - r) * v / (top * bottom);
  }
}

}  // namespace shellback::rheology
