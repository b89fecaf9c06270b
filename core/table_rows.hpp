#pragma once
/// The rows of a table that is built into the program.
#include <vector>

namespace shellback {

/// One vector a row of numbers parted by commas; lines that begin with '#' or a letter are none.
[[nodiscard]] std::vector<std::vector<double>> table_rows(const char* text);

}  // namespace shellback
