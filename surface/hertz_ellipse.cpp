#include "surface/hertz_ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/constants.hpp"

namespace shellback::surface {
namespace {

/// ln(k1/k2) and phi for pressed ellipses from a circle to long ones.
struct EllipseTable {
  std::vector<double> x{0.0}, phi{1.0};

  EllipseTable() {
    constexpr int kRows = 2000;       // straight lines between them: within 1e-6
    constexpr double kLongest = 9.6;  // -ln of b/a: curvatures 1e6 to 1
    for (int n = 1; n <= kRows; ++n) {
      const double k = std::exp(-kLongest * n / kRows);
      const double e = std::sqrt(1.0 - k * k);
      const double K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
      const double along = K - E, across = E / (k * k) - K;
      x.push_back(std::log(across / along));
      phi.push_back(kPi / std::sqrt(2.0) * std::pow(along * across, 0.25) / (e * std::pow(K, 1.5)));
    }
  }
};

}  // namespace

double ellipse_factor(double ratio) {
  static const EllipseTable table;
  const double x = std::clamp(std::log(ratio), 0.0, table.x.back());
  const auto right = std::upper_bound(table.x.begin() + 1, table.x.end() - 1, x);
  const std::size_t n = right - table.x.begin();
  const double part = (x - table.x[n - 1]) / (table.x[n] - table.x[n - 1]);
  return table.phi[n - 1] + part * (table.phi[n] - table.phi[n - 1]);
}

double hertz_factor(double k1, double k2) {
  const auto [low, high] = std::minmax(k1, k2);
  return ellipse_factor(high / low) / std::sqrt(std::sqrt(low * high));
}

double sphere_alike(double k1, double k2) {
  const auto [low, high] = std::minmax(k1, k2);
  return std::pow(ellipse_factor(high / low), 2.0 / 3.0) / std::sqrt(low * high);
}

}  // namespace shellback::surface
