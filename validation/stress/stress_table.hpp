#pragma once
/// The stability map as text: a page with tables (Markdown), counts for a terminal.
#include <string>

#include "validation/stress/stress_map.hpp"

namespace shellback::validation {

/// docs/stability-map.md. `picture` is the link to the picture (empty: none).
[[nodiscard]] std::string stress_page(const StressMap& map, const std::string& picture,
                                      const std::string& command);

/// How many cells of each method ended how, for a terminal.
[[nodiscard]] std::string stress_summary(const StressMap& map);

}  // namespace shellback::validation
