#include <cmath>

#include "bearing/over_time/cycle.hpp"

namespace shellback::bearing {

const CycleQuantity* quantity_named(const CycleResult& r, const std::string& name) {
  for (const CycleQuantity& q : r.quantities) {
    if (q.quantity.name == name) return &q;
  }
  return nullptr;
}

double value_of(const CycleResult& r, const std::string& name) {
  const CycleQuantity* known = quantity_named(r, name);
  return known == nullptr ? NAN : known->quantity.value;
}

std::vector<Quantity> quantities_of(const CycleResult& r) {
  std::vector<Quantity> all;
  for (const CycleQuantity& q : r.quantities) all.push_back(q.quantity);
  return all;
}

Result head_of(const CycleResult& r) {
  Result head;
  head.verdict = r.verdict;
  head.tier = r.tier;
  head.title = r.title;
  head.effects = r.effects;
  head.limiters = r.limiters;
  head.warnings = r.warnings;
  head.assumptions = r.assumptions;
  head.grid = r.grid;
  head.cost = r.cost;
  head.audit.mass = r.audit.mass;
  head.audit.load = r.audit.load;
  head.audit.energy = r.audit.energy;
  head.audit.moment = r.audit.moment;
  head.choice = r.choice;
  return head;
}

Result as_result(const CycleResult& r) {
  Result result = head_of(r);
  result.quantities = quantities_of(r);
  return result;
}

}  // namespace shellback::bearing
