#pragma once
/// Bearings of the library that something is known of: the shipped cases, and those with which the
/// ledger and the chart work (validation/, but for the scenes that are driven to where films end).
#include <filesystem>
#include <vector>

namespace shellback::validation {

/// Their case files, sorted. Throws FileError if the library is not found.
[[nodiscard]] std::vector<std::filesystem::path> known_cases();

}  // namespace shellback::validation
