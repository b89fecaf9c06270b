#pragma once
/// A text or a number as a field of a CSV table.
#include <string>

namespace shellback::app {

/// In quotes if it holds a comma, a quote or the end of a line (RFC 4180).
[[nodiscard]] std::string csv_text(const std::string& text);

/// All digits that tell one number from the next; empty if it is none.
[[nodiscard]] std::string csv_number(double value);

}  // namespace shellback::app
