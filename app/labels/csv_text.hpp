#pragma once
/// A text as a field of a CSV table.
#include <string>

namespace shellback::app {

/// In quotes if it holds a comma, a quote or the end of a line (RFC 4180).
[[nodiscard]] std::string csv_text(const std::string& text);

}  // namespace shellback::app
