#include "validation/draw.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::validation {

double Draw::unit() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
double Draw::between(double low, double high) { return low + (high - low) * unit(); }
double Draw::log_between(double low, double high) {
  return low * std::exp(unit() * std::log(high / low));
}
bool Draw::chance(double probability) { return unit() < probability; }
int Draw::index(int count) { return std::min(static_cast<int>(unit() * count), count - 1); }

}  // namespace shellback::validation
