#include "core/between.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace shellback {

Between between(const std::vector<double>& places, double x) {
  const int n = static_cast<int>(places.size());
  if (x <= places.front()) return {0, 0, 0.0};
  if (x >= places.back()) return {n - 1, n - 1, 0.0};
  const int right =
      static_cast<int>(std::upper_bound(places.begin(), places.end(), x) - places.begin());
  const double at = places[right - 1];
  return {right - 1, right, (x - at) / (places[right] - at)};
}

Between between_around(const std::vector<double>& angles, double x) {
  const int n = static_cast<int>(angles.size());
  const double turn = 2.0 * kPi;
  x -= turn * std::floor((x - angles.front()) / turn);
  x = std::max(x, angles.front());  // by a last digit it may lie before
  const int right =
      static_cast<int>(std::upper_bound(angles.begin(), angles.end(), x) - angles.begin());
  const double at = angles[right - 1];
  const double end = right < n ? angles[right] : angles.front() + turn;
  return {right - 1, right < n ? right : 0, (x - at) / (end - at)};
}

}  // namespace shellback
