#include "core/not_a_number.hpp"

#include <algorithm>
#include <cmath>

namespace shellback {

std::optional<NotANumber> find_not_a_number(FieldName name, std::span<const double> field,
                                            int per_cell) {
  const auto bad =
      std::find_if(field.begin(), field.end(), [](double x) { return !std::isfinite(x); });
  if (bad == field.end()) return std::nullopt;
  return NotANumber{name, static_cast<int>(bad - field.begin()) / per_cell};
}

}  // namespace shellback
