#pragma once
/// A table of expected values: comma-separated text with a header line of column names.
///
/// Lines that begin with # are comments (the table's source stands there) and empty lines are
/// skipped. A cell is a number, a quotient of two numbers ("1/9"), a text that nobody asks for as
/// a number, or empty: no value. Every error is an InputError with file and line.
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace shellback::validation {

struct TableLine {
  int number = 0;                 ///< in the file, from 1
  std::vector<std::string> cell;  ///< one per column; "" where the line ends early
};

class Table {
 public:
  /// Takes a table apart; `path` names it in messages. Throws InputError: no header, a column
  /// named twice, a line with more cells than columns, no lines.
  Table(const std::string& text, std::string path);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] const std::vector<TableLine>& lines() const { return lines_; }
  [[nodiscard]] bool has(const std::string& column) const;

  /// The number in a line (counted from 0 over `lines`), none where the cell is empty. Throws
  /// InputError if there is no such column or the cell is no finite number.
  [[nodiscard]] std::optional<double> number(std::size_t line, const std::string& column) const;

  /// All cells of a line that are numbers, by column.
  [[nodiscard]] std::map<std::string, double> numbers(std::size_t line) const;

 private:
  [[nodiscard]] std::size_t index_of(const std::string& column) const;

  std::string path_;
  std::vector<std::string> columns_;
  std::vector<TableLine> lines_;
};

/// The table in a file. Throws FileError if it cannot be read, InputError as the constructor.
[[nodiscard]] Table read_table(const std::string& path);

}  // namespace shellback::validation
