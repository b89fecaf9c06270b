#pragma once
/// All cells of the stability map for other programs.
#include <string>

#include "proof/stress_map.hpp"

namespace shellback::proof {

/// One line per cell.
[[nodiscard]] std::string stress_csv(const StressMap& map);
[[nodiscard]] std::string stress_json(const StressMap& map);

}  // namespace shellback::proof
