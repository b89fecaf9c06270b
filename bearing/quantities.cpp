#include "bearing/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellback::bearing {

double Quantity::discretisation() const {
  return error_grid + (std::isfinite(error_time) ? error_time : 0.0);
}

double Quantity::error() const {
  double sum = std::numeric_limits<double>::quiet_NaN();
  for (const double bar : {error_grid, error_time, error_model}) {
    if (std::isfinite(bar)) sum = bar + (std::isfinite(sum) ? sum : 0.0);
  }
  return sum;
}

const Quantity* quantity_in(const std::vector<Quantity>& list, const std::string& name) {
  const auto q = std::find_if(list.begin(), list.end(),
                              [&](const Quantity& known) { return known.name == name; });
  return q == list.end() ? nullptr : &*q;
}

double value_in(const std::vector<Quantity>& list, const std::string& name) {
  const Quantity* q = quantity_in(list, name);
  return q == nullptr ? NAN : q->value;
}

const QuantityEntry* find_quantity(std::string_view name) {
  const auto* entry = std::find_if(std::begin(kQuantities), std::end(kQuantities),
                                   [&](const QuantityEntry& r) { return r.name == name; });
  return entry == std::end(kQuantities) ? nullptr : entry;
}

std::vector<Quantity> listed(const Quantities& values) {
  std::vector<Quantity> list;
  for (const QuantityEntry& e : kQuantities) {
    const double value = values.*e.member;
    if (std::isfinite(value)) {
      list.push_back({std::string(e.name), value, std::string(e.unit)});
    }
  }
  return list;
}

Quantities typed(const std::vector<Quantity>& list) {
  Quantities values;
  for (const Quantity& q : list) {
    if (const QuantityEntry* entry = find_quantity(q.name)) values.*entry->member = q.value;
  }
  return values;
}

}  // namespace shellback::bearing
