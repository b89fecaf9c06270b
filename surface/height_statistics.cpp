#include "surface/height_statistics.hpp"

#include <algorithm>
#include <numeric>

#include "core/contract.hpp"

namespace shellback::surface {

HeightStatistics height_statistics(const HeightMap& map) {
  const auto n = static_cast<double>(map.z.size());
  const double mean = std::accumulate(map.z.begin(), map.z.end(), 0.0) / n;
  HeightStatistics s;
  double m2 = 0.0, m3 = 0.0, m4 = 0.0;
  s.highest = -INFINITY, s.lowest = INFINITY;
  for (const double height : map.z) {
    const double z = height - mean, z2 = z * z;
    s.Ra += std::abs(z) / n;
    m2 += z2 / n, m3 += z2 * z / n, m4 += z2 * z2 / n;
    s.highest = std::max(s.highest, z), s.lowest = std::min(s.lowest, z);
  }
  if (!(m2 > 0.0)) {
    throw InputError("all heights of the map are equal: there is no roughness to be described");
  }
  s.Rq = std::sqrt(m2);
  s.skewness = m3 / (m2 * s.Rq);
  s.kurtosis = m4 / (m2 * m2);
  return s;
}

}  // namespace shellback::surface
