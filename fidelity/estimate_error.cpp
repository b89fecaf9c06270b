#include "fidelity/estimate_error.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::fidelity {

EstimateBars estimate_bars(const coupling::Case&, const Estimate&, const Indicators& n) {
  EstimateBars b;
  b.torque = 0.05 + 0.1 * n.heating;
  b.h_min = 0.1 + 0.2 * n.heating;
  return b;
}

}  // namespace shellback::fidelity
