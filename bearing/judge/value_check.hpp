#pragma once
/// One value against what it can be; refusals name key, value and range.
#include <array>
#include <string>

#include "bearing/finding.hpp"
#include "core/range.hpp"

namespace shellback::bearing {

/// Values of one section of the case; `section` is its dotted name.
class ValueCheck {
 public:
  ValueCheck(std::string section, Findings& to) : section_(std::move(section)), to_(to) {}

  /// Refuses what is not finite or not in the range. `unit` is one of shown.hpp.
  void number(const char* key, double value, const char* unit,
              const Range& range = kAnyValue) const;
  void temperature(const char* key, double value) const;
  void whole_number(const char* key, int value, std::array<int, 2> range) const;
  void refuse(const char* key, const std::string& problem, const std::string& cure = "") const;

 private:
  [[nodiscard]] std::string name(const char* key) const;

  std::string section_;
  Findings& to_;
};

}  // namespace shellback::bearing
