#pragma once
/// What the paper states in words, beside ours: met, not met, or not known.
///
/// Each range is the paper's number with the room that its wording leaves; nothing is turned until
/// ours lies inside.
#include <string>
#include <vector>

#include "validation/rig/rig_study.hpp"

namespace shellback::validation {

enum class Met { yes, no, unknown };
[[nodiscard]] const char* to_string(Met met);

struct RigStatement {
  std::string section;  ///< of the paper
  std::string words;    ///< the statement
  std::string range;    ///< within which ours meets it, and why
  std::string ours;
  Met met = Met::unknown;
};

[[nodiscard]] std::vector<RigStatement> rig_statements(const RigStudy& study);

}  // namespace shellback::validation
