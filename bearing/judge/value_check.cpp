#include "bearing/judge/value_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bearing/case_limits.hpp"
#include "bearing/shown.hpp"

namespace shellback::bearing {

std::string ValueCheck::name(const char* key) const { return section_ + "." + key; }

void ValueCheck::refuse(const char* key, const std::string& problem,
                        const std::string& cure) const {
  to_.refuse(name(key), problem, cure);
}

void ValueCheck::number(const char* key, double value, const char* unit, const Range& range) const {
  if (!std::isfinite(value)) {
    refuse(key, std::isnan(value) ? "it is not given, or no number"
                                  : fmt::format("{} is not a finite number", value));
  } else if (!range.holds(value)) {
    refuse(key, fmt::format("{} is not possible (it must {})", shown(value, unit), range.words));
  }
}

void ValueCheck::temperature(const char* key, double value) const {
  if (kValueRanges.temperature.holds(value)) return;
  refuse(key,
         fmt::format("{} K cannot be meant ({}; a bearing lives between -60 and 400 degC)", value,
                     shown(value, "degC")),
         "check the number and whether degC or K is meant");
}

void ValueCheck::whole_number(const char* key, int value, std::array<int, 2> range) const {
  if (value >= range[0] && value <= range[1]) return;
  refuse(key, fmt::format("{} does not lie within {} to {}", value, range[0], range[1]));
}

}  // namespace shellback::bearing
