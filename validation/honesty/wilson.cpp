#include "validation/honesty/wilson.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::validation {

ShareInterval wilson(double held, double count, double z) {
  if (!(count > 0.0)) return {};
  const double p = held / count;
  const double z2 = z * z / count;
  const double middle = p + 0.5 * z2;
  const double half = std::sqrt(z2 * (p * (1.0 - p) + 0.25 * z2));
  return {std::max(0.0, (middle - half) / (1.0 + z2)), std::min(1.0, (middle + half) / (1.0 + z2))};
}

}  // namespace shellback::validation
