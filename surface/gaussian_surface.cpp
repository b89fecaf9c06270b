#include "surface/gaussian_surface.hpp"

#include <random>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::surface {
namespace {

/// Standard normal numbers by Box and Muller; std::normal_distribution differs between libraries.
std::vector<double> white_noise(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  const auto uniform = [&bits] {
    constexpr double kUnit = 0x1p-53;
    return (static_cast<double>(bits() >> 11U) + 0.5) * kUnit;
  };
  std::vector<double> out(n);
  for (double& x : out) {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    x = radius * std::cos(2.0 * kPi * uniform());
  }
  return out;
}

/// Weights from -reach to reach; their squares add up to 1.
std::vector<double> kernel(double lambda, CorrelationShape shape) {
  constexpr double kReach = 3.0;  // lambdas; exp(-2 ln2 9) = 4e-6
  std::vector<double> w;
  if (shape == CorrelationShape::linear) {
    w.assign(static_cast<std::size_t>(std::max(1L, std::lround(2.0 * lambda))), 1.0);
  } else {
    const int reach = std::max(1, static_cast<int>(std::ceil(kReach * lambda)));
    for (int k = -reach; k <= reach; ++k) {
      w.push_back(std::exp(-2.0 * std::log(2.0) * k * k / (lambda * lambda)));
    }
  }
  double squares = 0.0;
  for (const double x : w) squares += x * x;
  for (double& x : w) x /= std::sqrt(squares);
  return w;
}

/// Periodic convolution of every line in x.
HeightMap smoothed(const HeightMap& map, const std::vector<double>& w) {
  HeightMap out = map;
  const int half = static_cast<int>(w.size()) / 2;
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) {
      double sum = 0.0;
      for (int k = 0; k < static_cast<int>(w.size()); ++k) {
        const int a = ((i + k - half) % map.nx + map.nx) % map.nx;
        sum += w[static_cast<std::size_t>(k)] * map.at(a, j);
      }
      out.z[out.index(i, j)] = sum;
    }
  }
  return out;
}

}  // namespace

HeightMap gaussian_surface(const GaussianSurface& g) {
  EXPECTS(g.nx > 0 && g.ny > 0 && g.lambda_x > 0.0 && g.lambda_y > 0.0);
  HeightMap map{g.nx, g.ny, g.dx, g.dy, {}};
  map.z = white_noise(static_cast<std::size_t>(g.nx) * static_cast<std::size_t>(g.ny), g.seed);
  map = smoothed(map, kernel(g.lambda_x / g.dx, g.shape));
  map = exchanged(smoothed(exchanged(map), kernel(g.lambda_y / g.dy, g.shape)));
  for (double& z : map.z) z *= g.Rq;
  return map;
}

}  // namespace shellback::surface
