#pragma once
/// The stability map as text: a page with tables (Markdown), all cells (CSV, JSON).
#include <string>

#include "proof/stress_map.hpp"

namespace shellback::proof {

/// docs/stability-map.md. `picture` is the link to the picture (empty: none).
[[nodiscard]] std::string stress_page(const StressMap& map, const std::string& picture,
                                      const std::string& command);

/// One line per cell.
[[nodiscard]] std::string stress_csv(const StressMap& map);
[[nodiscard]] std::string stress_json(const StressMap& map);

/// How many cells of each method ended how, for a terminal.
[[nodiscard]] std::string stress_summary(const StressMap& map);

/// The `shellback run` command line that repeats a cell.
[[nodiscard]] std::string repeat_command(const StressScene& scene, const StressStep& step,
                                         const StressMethod& method);

/// What ended the row: the reason of the first refusal or fault of the default, in a few words.
[[nodiscard]] std::string end_of_row(const StressRow& row);

/// Reason without its numbers and asides, at most `most` characters.
[[nodiscard]] std::string in_short(const std::string& why, std::size_t most);

}  // namespace shellback::proof
