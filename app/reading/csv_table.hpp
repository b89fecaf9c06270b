#pragma once
/// A table of numbers beside a case: names and units in its first line, every number with a place.
///
///   # comment
///   angle [deg], load_x [N], load_y [N]
///   0, 12.5, -3000
///
/// Fields end at what separates those of the first line: a semicolon, else a tab, else a comma;
/// quotes around a field count for nothing but the separators in them, nor do fields of nothing at
/// the end of a line. Lines that begin with #, columns behind the first whose name does, and empty
/// lines are left out. So is a last column `shellback`, the mark of our own tables
/// (app/result_mark.hpp). Decimals stand after a point. All errors are InputError at
/// file:line:column.
#include <string>
#include <vector>

#include "app/reading/case_text.hpp"
#include "app/reading/units.hpp"

namespace shellback::app {

/// A field of a line and where it begins, counted from 1.
struct CsvCell {
  std::string text;
  std::size_t column = 1;
};

/// Semicolon, tab or comma, the first of them that the line has.
[[nodiscard]] char separator_of(const std::string& line);

/// The fields of a line without blanks and quotes around them.
[[nodiscard]] std::vector<CsvCell> split_cells(const std::string& line, char separator);

/// The number of a field in a column of `unit`, as it stands there; a share ("50 %") only where
/// the unit is "1". Throws UnitError.
[[nodiscard]] double number_of(const std::string& field, const std::string& unit);

/// A column that a table may have; its unit is one of the kind.
struct CsvKind {
  const char* name;
  Kind kind;
};

class CsvTable {
 public:
  /// Reads the file. `possible` are the columns that it may have, in any order; `example` is a
  /// first line that would do; `use` is who names the table. Throws FileError if the file cannot be
  /// read, InputError for: no first line, a column that is unknown (did you mean) or named twice, a
  /// unit that is missing or wrong, a row with more or fewer fields than columns, a field that is
  /// empty or no finite number.
  CsvTable(const std::string& path, const std::vector<CsvKind>& possible,
           const std::string& example, TextKind use = TextKind::table_of_case);

  [[nodiscard]] std::size_t rows() const { return lines_.size(); }
  /// What a table of ours says of a run that wrote it and was not finished; else empty.
  [[nodiscard]] const std::string& not_finished() const { return not_finished_; }
  [[nodiscard]] bool has(const std::string& name) const;
  /// The column's numbers in SI units; fails at the first line if there is no such column.
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
  /// The number as it is written, with its unit: "12.5 deg".
  [[nodiscard]] std::string written(std::size_t row, const std::string& name) const;
  [[nodiscard]] std::string place(std::size_t row, const std::string& name) const;

  [[noreturn]] void fail(std::size_t row, const std::string& name,
                         const std::string& problem) const;
  /// At the first line.
  [[noreturn]] void fail_header(const std::string& problem) const;

 private:
  struct Column {
    std::string name;
    std::string unit;
    Kind kind;
    double factor = 1.0;  ///< to SI; of a temperature the unit's zero counts, too
    std::vector<double> values;
    std::vector<CsvCell> cells;
  };
  void read_cell(Column& column, const CsvCell& cell, const std::string& place);
  void read_header(const std::string& line, const std::vector<CsvKind>& possible);
  void read_row(const std::string& line, int number);
  [[nodiscard]] const Column* find(const std::string& name) const;

  std::string path_;
  std::string example_;
  int header_ = 0;  ///< its line; 0: not read yet
  std::string not_finished_;
  char separator_ = ',';
  bool marked_ = false;      ///< the last column is our mark
  std::vector<bool> taken_;  ///< of the columns before the mark, those that are not left out
  std::vector<Column> columns_;
  std::vector<int> lines_;  ///< of the rows
};

}  // namespace shellback::app
