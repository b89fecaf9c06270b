#pragma once
/// All cells of the stability map for other programs.
#include <string>

#include "validation/stress/stress_map.hpp"

namespace shellback::validation {

/// One line per cell.
[[nodiscard]] std::string stress_csv(const StressMap& map);
[[nodiscard]] std::string stress_json(const StressMap& map);

}  // namespace shellback::validation
