#include "bearing/result.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::bearing {

namespace {

auto find(const Result& r, const std::string& name) {
  return std::find_if(r.quantities.begin(), r.quantities.end(),
                      [&](const Quantity& q) { return q.name == name; });
}

}  // namespace

bool Result::has(const std::string& name) const { return find(*this, name) != quantities.end(); }

double Result::value(const std::string& name) const {
  const auto q = find(*this, name);
  return q == quantities.end() ? NAN : q->value;
}

}  // namespace shellback::bearing
