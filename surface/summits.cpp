#include "surface/summits.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/round_off.hpp"
#include "surface/hertz_ellipse.hpp"

namespace shellback::surface {
namespace {

/// Part of the summits' variance that the surface's has more, times alpha (McCool) [-].
constexpr double kSummitVariance = 0.8968;

/// Mean squares of first and second differences along x.
void profile_moments(const HeightMap& map, double& m2, double& m4) {
  double first = 0.0, second = 0.0;
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i + 1 < map.nx; ++i) {
      const double d = (map.at(i + 1, j) - map.at(i, j)) / map.dx;
      first += d * d;
      if (i == 0) continue;
      const double dd =
          (map.at(i + 1, j) - 2.0 * map.at(i, j) + map.at(i - 1, j)) / (map.dx * map.dx);
      second += dd * dd;
    }
  }
  m2 = first / (static_cast<double>(map.nx - 1) * map.ny);
  m4 = second / (static_cast<double>(map.nx - 2) * map.ny);
}

/// Of neighbours of one height, as rounded ones are, the last in reading order is the summit.
bool is_summit(const HeightMap& map, int i, int j) {
  const double z = map.at(i, j);
  for (int b = -1; b <= 1; ++b) {
    for (int a = -1; a <= 1; ++a) {
      const bool behind = b > 0 || (b == 0 && a > 0);
      const double other = map.at(i + a, j + b);
      if ((a != 0 || b != 0) && (other > z || (behind && other == z))) return false;
    }
  }
  return true;
}

}  // namespace

SpectralMoments spectral_moments(const HeightMap& map) {
  SpectralMoments m;
  for (const double z : map.z) m.m0 += z * z / static_cast<double>(map.z.size());
  profile_moments(map, m.m2x, m.m4x);
  profile_moments(exchanged(map), m.m2y, m.m4y);
  return m;
}

SummitStatistics summits_of(const SpectralMoments& m) {
  const auto [low, high] = std::minmax({m.m2x, m.m2y});
  if (!(low > kRoundOff * high)) return {kNone, kNone, kNone, kNone};
  const double alpha = m.alpha();
  return {m.m4() / m.m2() / (6.0 * kPi * std::sqrt(3.0)),
          3.0 * std::sqrt(kPi) / (8.0 * std::sqrt(m.m4())),
          alpha > kSummitVariance ? std::sqrt((1.0 - kSummitVariance / alpha) * m.m0) : kNone,
          4.0 * std::sqrt(m.m0 / (kPi * alpha))};
}

std::vector<Summit> count_summits(const HeightMap& map) {
  std::vector<Summit> summits;
  for (int j = 1; j + 1 < map.ny; ++j) {
    for (int i = 1; i + 1 < map.nx; ++i) {
      if (!is_summit(map, i, j)) continue;
      const double z = map.at(i, j);
      const double xx = (map.at(i + 1, j) - 2.0 * z + map.at(i - 1, j)) / (map.dx * map.dx);
      const double yy = (map.at(i, j + 1) - 2.0 * z + map.at(i, j - 1)) / (map.dy * map.dy);
      const double xy = (map.at(i + 1, j + 1) - map.at(i + 1, j - 1) - map.at(i - 1, j + 1) +
                         map.at(i - 1, j - 1)) /
                        (4.0 * map.dx * map.dy);
      const Curvature curvature{-xx, -yy, -xy};
      if (curvature.determinant() > 0.0) summits.push_back({z, curvature});
    }
  }
  return summits;
}

SummitStatistics statistics_of(const std::vector<Summit>& summits, const HeightMap& map) {
  const auto n = static_cast<double>(summits.size());
  SummitStatistics s;
  s.density = n / (static_cast<double>(map.nx - 2) * map.dx * (map.ny - 2) * map.dy);
  Curvature sum;
  double squares = 0.0;
  for (const Summit& summit : summits) {
    s.height += summit.height / n;
    sum = sum + summit.curvature;
  }
  for (const Summit& summit : summits) squares += std::pow(summit.height - s.height, 2);
  s.radius = n > 0.0 ? n * sphere_alike(sum.mean() + sum.deviation(), sum.mean() - sum.deviation())
                     : kNone;
  if (summits.empty()) s.height = kNone;
  s.roughness = n > 1.0 ? std::sqrt(squares / (n - 1.0)) : kNone;
  return s;
}

}  // namespace shellback::surface
