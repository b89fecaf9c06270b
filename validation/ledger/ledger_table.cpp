#include "validation/ledger/ledger_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "app/reading/case_text.hpp"
#include "app/reading/did_you_mean.hpp"
#include "core/contract.hpp"

namespace shellback::validation {
namespace {

std::string trimmed(const std::string& text) {
  const char* blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

std::optional<double> plain_number(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> number_or_quotient(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return plain_number(text);
  const auto above = plain_number(text.substr(0, slash));
  const auto below = plain_number(text.substr(slash + 1));
  if (!above || !below || *below == 0.0) return std::nullopt;
  return *above / *below;
}

std::string place(const std::string& path, int line) { return fmt::format("{}:{}:1", path, line); }

}  // namespace

Table::Table(const std::string& text, std::string path) : path_(std::move(path)) {
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (trimmed(line).empty() || line.front() == '#') continue;
    std::vector<std::string> cells = cells_of(line);
    if (columns_.empty()) {
      for (std::size_t k = 0; k < cells.size(); ++k) {
        if (std::count(cells.begin(), cells.end(), cells[k]) > 1) {
          throw InputError(place(path_, number),
                           "the column " + app::in_quotes(cells[k]) + " is named twice");
        }
      }
      columns_ = std::move(cells);
      continue;
    }
    if (cells.size() > columns_.size()) {
      throw InputError(
          place(path_, number),
          fmt::format("{} cells, but the header names {} columns", cells.size(), columns_.size()));
    }
    cells.resize(columns_.size());
    lines_.push_back({number, std::move(cells)});
  }
  if (lines_.empty()) {
    throw InputError(place(path_, 1),
                     "this table has no lines: a ledger entry over nothing would "
                     "hold of anything; give a header and at least one line");
  }
}

bool Table::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::size_t Table::index_of(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) {
    throw InputError(path_, "there is no column " + app::in_quotes(column) +
                                app::choices_for(column, columns_, "columns are"));
  }
  return static_cast<std::size_t>(found - columns_.begin());
}

std::optional<double> Table::number(std::size_t line, const std::string& column) const {
  const TableLine& from = lines_.at(line);
  const std::string& cell = from.cell[index_of(column)];
  if (cell.empty()) return std::nullopt;
  const auto value = number_or_quotient(cell);
  if (!value) {
    throw InputError(place(path_, from.number),
                     fmt::format("column {}: {} is no number; write one, or leave the cell empty",
                                 column, app::in_quotes(cell)));
  }
  return value;
}

std::map<std::string, double> Table::numbers(std::size_t line) const {
  std::map<std::string, double> numbers;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (const auto value = number_or_quotient(lines_.at(line).cell[k]))
      numbers[columns_[k]] = *value;
  }
  return numbers;
}

Table read_table(const std::string& path) {
  return {app::read_text_file(path, app::TextKind::table), path};
}

}  // namespace shellback::validation
