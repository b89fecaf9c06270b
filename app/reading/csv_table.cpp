#include "app/reading/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/reading/did_you_mean.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

constexpr const char* kMark = "shellback";  ///< last column of our own tables
constexpr std::string_view kNotFinished = "# not finished";
constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";  ///< some spreadsheets begin with it

/// "load_x [kN]" in its two parts; no unit: nothing behind. Any other words belong to the name.
std::pair<std::string, std::string> split_name(const std::string& text) {
  const std::size_t open = text.find('[');
  if (open == std::string::npos || text.find_first_of("[]", open + 1) != text.size() - 1) {
    return {text, ""};
  }
  const std::size_t last = text.find_last_not_of(' ', open == 0 ? 0 : open - 1);
  return {text.substr(0, last == std::string::npos ? 0 : last + 1),
          text.substr(open + 1, text.size() - open - 2)};
}

/// Whether a cell may stand in the column of our mark: the version, or nothing.
bool is_mark(const std::string& text) {
  return text.empty() || std::count(text.begin(), text.end(), '.') == 2;
}

/// Cells of nothing at the end of a line, as some programs end every line with a separator.
void drop_empty_end(std::size_t columns, std::vector<CsvCell>& cells) {
  while (cells.size() > columns && cells.back().text.empty()) cells.pop_back();
}

/// Where the field that begins at `begin` ends: at a separator outside of quotes, or the line's
/// end.
std::size_t end_of_field(const std::string& line, std::size_t begin, char separator) {
  bool quoted = false;
  for (std::size_t k = begin; k < line.size(); ++k) {
    if (line[k] == '"') quoted = !quoted;
    if (line[k] == separator && !quoted) return k;
  }
  return line.size();
}

}  // namespace

char separator_of(const std::string& line) {
  for (const char c : {';', '\t'}) {
    if (line.find(c) != std::string::npos) return c;
  }
  return ',';
}

std::vector<CsvCell> split_cells(const std::string& line, char separator) {
  std::vector<CsvCell> cells;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = end_of_field(line, begin, separator);
    std::string_view text = std::string_view(line).substr(begin, end - begin);
    if (text.ends_with('\r')) text.remove_suffix(1);
    text = trimmed(text);
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') {
      text = trimmed(text.substr(1, text.size() - 2));
    }
    const bool none = text.empty();
    const auto column = none ? begin : static_cast<std::size_t>(text.data() - line.data());
    cells.push_back({std::string(text), column + 1});
    if (end == line.size()) return cells;
    begin = end + 1;
  }
}

double number_of(const std::string& field, const std::string& unit) {
  constexpr Kind kBare{
      "a plain number", {}, "none here, the first line of the table names it", "12.5"};
  const double number = parse_quantity(field, unit == "1" ? kNumber : kBare);
  if (unit == "1" || !field.ends_with('%')) return number;
  throw UnitError(fmt::format("{} is a share, but the column is in {}; write the number alone",
                              in_quotes(field), unit));
}

CsvTable::CsvTable(const std::string& path, const std::vector<CsvKind>& possible,
                   const std::string& example, TextKind use)
    : path_(path), example_(example) {
  std::string text = read_text_file(path, use);
  if (text.starts_with(kByteOrderMark)) text.erase(0, 3);
  std::size_t begin = 0;
  for (int number = 1; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string::npos && line.starts_with(kNotFinished)) {
      not_finished_ = line.substr(std::string_view("# ").size());
    }
    if (first == std::string::npos || line[first] == '#') continue;
    if (header_ == 0) {
      header_ = number;
      read_header(line, possible);
    } else {
      read_row(line, number);
    }
  }
  if (header_ == 0) {
    throw InputError(path + ":1:1", fmt::format("the table is empty; its first line names columns "
                                                "and units: {}",
                                                example));
  }
}

void CsvTable::read_header(const std::string& line, const std::vector<CsvKind>& possible) {
  std::vector<std::string> names;
  for (const CsvKind& known : possible) names.emplace_back(known.name);
  separator_ = separator_of(line);
  std::vector<CsvCell> cells = split_cells(line, separator_);
  drop_empty_end(1, cells);
  marked_ = cells.size() > 1 && cells.back().text == kMark;
  if (marked_) cells.pop_back();
  for (const CsvCell& cell : cells) {
    taken_.push_back(!cell.text.starts_with('#'));
    if (!taken_.back()) continue;
    const auto [name, unit] = split_name(cell.text);
    const std::string place = fmt::format("{}:{}:{}", path_, header_, cell.column);
    const auto known = std::find(names.begin(), names.end(), name);
    const std::string bare = name.substr(0, name.find_first_of(" ("));
    if (unit.empty() && bare != name &&
        std::find(names.begin(), names.end(), bare) != names.end()) {
      throw InputError(place, fmt::format("{} is no column and its unit in brackets; write for "
                                          "example {}",
                                          in_quotes(name), example_));
    }
    if (known == names.end()) {
      throw InputError(
          place,
          fmt::format("the column {} is not known{}; the first line names "
                      "columns and units, for example {}; one that begins with # is left out",
                      in_quotes(name), choices_for(name, names, "possible are"), example_));
    }
    if (find(name) != nullptr) {
      throw InputError(place, fmt::format("there are two columns {}; keep one of them", name));
    }
    const Kind kind = possible[static_cast<std::size_t>(known - names.begin())].kind;
    if (unit.empty()) {
      throw InputError(
          place, fmt::format("the column {} names no unit; write for example {}", name, example_));
    }
    try {
      if (kind.absolute) static_cast<void>(parse_quantity("300 " + unit, kind));
      columns_.push_back({name, unit, kind, kind.absolute ? 1.0 : unit_factor(unit, kind), {}, {}});
    } catch (const UnitError& error) {
      throw InputError(place, error.what());
    }
  }
}

void CsvTable::read_row(const std::string& line, int number) {
  std::vector<CsvCell> cells = split_cells(line, separator_);
  drop_empty_end(taken_.size() + (marked_ ? 1 : 0), cells);
  const bool has_mark = marked_ && cells.size() > taken_.size() && is_mark(cells.back().text);
  if (has_mark) cells.pop_back();
  drop_empty_end(taken_.size(), cells);
  const auto place = [&](const CsvCell& cell) {
    return fmt::format("{}:{}:{}", path_, number, cell.column);
  };
  if (cells.size() != taken_.size()) {
    const CsvCell& odd = cells[std::min(cells.size() - 1, taken_.size())];
    throw InputError(place(odd),
                     fmt::format("this row has {} fields, but the first line names {} "
                                 "columns; give each column one number, with its "
                                 "decimals after a point; fields end at {}, as in the "
                                 "first line",
                                 cells.size(), taken_.size(),
                                 separator_ == '\t' ? "a tab" : fmt::format("\"{}\"", separator_)));
  }
  auto column = columns_.begin();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!taken_[k]) continue;
    if (cells[k].text.empty()) {
      throw InputError(place(cells[k]), fmt::format("the {} is missing here; fill the gap or take "
                                                    "the row out",
                                                    column->name));
    }
    read_cell(*column++, cells[k], place(cells[k]));
  }
  lines_.push_back(number);
}

void CsvTable::read_cell(Column& column, const CsvCell& cell, const std::string& place) {
  try {
    const double number = number_of(cell.text, column.unit);
    column.values.push_back(column.kind.absolute
                                ? parse_quantity(cell.text + " " + column.unit, column.kind)
                                : number * column.factor);
  } catch (const UnitError& error) {
    throw InputError(place, error.what());
  }
  if (!std::isfinite(column.values.back())) {
    throw InputError(place, "this number is too large to be computed with");
  }
  column.cells.push_back(cell);
}

const CsvTable::Column* CsvTable::find(const std::string& name) const {
  const auto at = std::find_if(columns_.begin(), columns_.end(),
                               [&](const Column& column) { return column.name == name; });
  return at == columns_.end() ? nullptr : &*at;
}

bool CsvTable::has(const std::string& name) const { return find(name) != nullptr; }

const std::vector<double>& CsvTable::column(const std::string& name) const {
  const Column* found = find(name);
  if (found == nullptr) {
    fail_header(
        fmt::format("there is no column {}; the first line names columns and units, for "
                    "example {}",
                    name, example_));
  }
  return found->values;
}

std::string CsvTable::written(std::size_t row, const std::string& name) const {
  const Column& column = *find(name);
  return column.cells[row].text + (column.unit == "1" ? "" : " " + column.unit);
}

std::string CsvTable::place(std::size_t row, const std::string& name) const {
  const Column* column = find(name);
  return fmt::format("{}:{}:{}", path_, lines_[row],
                     column == nullptr ? 1 : column->cells[row].column);
}

void CsvTable::fail(std::size_t row, const std::string& name, const std::string& problem) const {
  throw InputError(place(row, name), problem);
}

void CsvTable::fail_header(const std::string& problem) const {
  throw InputError(fmt::format("{}:{}:1", path_, header_), problem);
}

}  // namespace shellback::app
