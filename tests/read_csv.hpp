#pragma once
/// Reader of validation/data: comment lines begin with #, the first other line names the columns.
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace shellback::test {

/// One line of a table: value by column name; NaN where a field is empty or not a number.
using CsvRow = std::map<std::string, double>;

namespace detail {

[[nodiscard]] inline std::vector<std::string> split_fields(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

[[nodiscard]] inline double number_or_nan(const std::string& field) {
  std::istringstream stream(field);
  double value = 0.0;
  return stream >> value ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace detail

/// All rows of a file below the source directory. Throws if the file is missing or has no rows: a
/// test over no rows would hold of anything.
[[nodiscard]] inline std::vector<CsvRow> read_csv(const std::string& path) {
  std::ifstream file(std::string(SHELLBACK_SOURCE_DIR) + "/" + path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<std::string> names;
  std::vector<CsvRow> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> fields = detail::split_fields(line);
    if (names.empty()) {
      names = fields;
      continue;
    }
    CsvRow row;
    for (std::size_t k = 0; k < names.size(); ++k) {
      row[names[k]] = k < fields.size() ? detail::number_or_nan(fields[k])
                                        : std::numeric_limits<double>::quiet_NaN();
    }
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error("no rows in " + path);
  return rows;
}

}  // namespace shellback::test
