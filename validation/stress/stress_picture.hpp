#pragma once
/// The stability map as a picture: scenes down, severity across, the default in large with values
/// and reasons, the other methods beside it in small.
#include <string>

#include "validation/stress/stress_map.hpp"

namespace shellback::validation {

[[nodiscard]] std::string stress_svg(const StressMap& map);

}  // namespace shellback::validation
