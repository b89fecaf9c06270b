#include "validation/chart/chart_reference.hpp"

#include <cmath>

namespace shellback::validation {

ReferenceValue reference_value(double coarse, double medium, double fine) {
  const double ratio = (medium - coarse) / (fine - medium);
  const bool second_order = ratio > std::exp2(1.5) && ratio < std::exp2(2.5);
  if (!second_order) return {fine, std::abs(fine - medium), false};
  const double best = fine + (fine - medium) / 3.0;
  return {best, std::abs(best - (medium + (medium - coarse) / 3.0)), true};
}

}  // namespace shellback::validation
