#include "validation/honesty/honesty_record.hpp"

#include <algorithm>

namespace shellback::validation {

const char* to_string(CaseEnd end) {
  switch (end) {
    case CaseEnd::done:
      return "to the end";
    case CaseEnd::over_budget:
      return "over the budget";
    case CaseEnd::failed:
      return "failed";
    case CaseEnd::stopped:
      break;
  }
  return "stopped";
}

int HonestyRecord::count(CaseEnd end) const {
  return static_cast<int>(std::count(ends.begin(), ends.end(), end));
}

}  // namespace shellback::validation
