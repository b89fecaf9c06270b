#pragma once
/// `shellback init`: the shipped cases, to start from.
#include <iosfwd>
#include <string>

namespace shellback::app {

/// Lists the shipped cases, each with the first line of its file.
void list_cases(std::ostream& out);

/// Writes the shipped case to `path` (empty: NAME.toml here) and says so on `out`. Throws
/// InputError if there is no such case or the name promises another format, FileError if the file
/// exists already or cannot be written.
void write_case(const std::string& name, const std::string& path, std::ostream& out);

}  // namespace shellback::app
