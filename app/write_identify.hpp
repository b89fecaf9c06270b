#pragma once
/// Identified keys for terminals and scripts.
#include <iosfwd>
#include <string>

#include "app/labels/identify_words.hpp"

namespace shellback::app {

/// Keys with deviations and bounds, correlations, directions, every point; --set lines at the end.
void write_identify_table(std::ostream& out, const IdentifyView& v);

/// All of it, SI but for the keys, which are in the case's unit.
[[nodiscard]] std::string identify_json(const IdentifyView& v);

/// One line a measured value: point, inputs as measured, measured, deviation, computed at the start
/// and with the fitted keys (SI, empty where not found).
[[nodiscard]] std::string identify_csv(const IdentifyView& v);

}  // namespace shellback::app
