#include "validation/honesty/auto_record.hpp"

#include <cmath>

namespace shellback::validation {

bool AutoAnswer::within() const {
  return converged && std::abs(off_friction) <= tolerance && std::abs(off_h_min) <= tolerance;
}

}  // namespace shellback::validation
