#pragma once
/// `shellback init`: the shipped cases, to start from.
#include <iosfwd>
#include <string>

namespace shellback::app {

/// Lists the shipped cases, each with the first line of its file.
void list_cases(std::ostream& out);

/// Writes the shipped case to `path` (empty: NAME.toml here), the tables that it refers to beside
/// it, and says so on `out`. Throws InputError if there is no such case or the name promises
/// another format, FileError if one of the files exists already (as another one) or cannot be
/// written; then nothing has been written over.
void write_case(const std::string& name, const std::string& path, std::ostream& out);

}  // namespace shellback::app
