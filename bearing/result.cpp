#include "bearing/result.hpp"

namespace shellback::bearing {

bool Result::has(const std::string& name) const { return quantity_in(quantities, name) != nullptr; }

double Result::value(const std::string& name) const { return value_in(quantities, name); }

}  // namespace shellback::bearing
