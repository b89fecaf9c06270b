#pragma once
/// The table of a load cycle: rows over crank angle or time, checked, closed over the period.
///
/// Columns: angle or time; load_x and load_y, or load and direction (counter-clockwise from +X);
/// speed, if given. The load acts on the journal. Rows of a cycle run from 0 to before the end of
/// the period, which is the first row again; two rows at one time are a jump. Problems are
/// InputError at file:line:column.
#include <string>
#include <vector>

#include "app/reading/csv_table.hpp"
#include "bearing/load_cycle.hpp"

namespace shellback::app {

class LoadTable {
 public:
  /// Reads the file. Throws FileError if that fails, InputError as CsvTable does and for columns
  /// that do not go together or fewer than two rows.
  explicit LoadTable(const std::string& path);

  /// Whether its rows stand over crank angle, not time.
  [[nodiscard]] bool told_in_angle() const { return angle_; }

  /// The cycle; crank angle over `speed` is time [rad/s], 1 where the rows stand over time;
  /// `period`: infinite of a single event [s]. Throws InputError for rows that are not sorted, lie
  /// out of the period, stand three at a time, do not return to the first, leave a stretch without
  /// a row (bearing/row_gaps.hpp), or begin after 0 where nothing tells what is before; for jumps
  /// in a spline.
  [[nodiscard]] bearing::LoadCycle cycle(double speed, double period,
                                         bearing::LoadInterpolation interpolation);

  /// What is unusual about its end, found by cycle(): a shorter stretch without a row.
  [[nodiscard]] const std::vector<std::string>& doubts() const { return doubts_; }

  /// Throws InputError at the row where the load of `cycle` vanishes, unless its journal has mass.
  void expect_mass(const bearing::LoadCycle& cycle) const;

 private:
  struct Row {
    double t = 0.0;         ///< [s]
    bearing::LoadNow load;  ///< speed 0 without its column
    std::size_t line = 0;   ///< row of the table that it comes from
  };
  void expect_columns() const;
  void make_rows(double speed);
  void expect_within(std::size_t k, double period) const;
  void expect_order(bearing::LoadInterpolation interpolation) const;
  /// Between two rows; of more than a millionth of the largest, or of none.
  struct Change {
    double load = 0.0;   ///< [N]
    double speed = 0.0;  ///< [rad/s]
    bool of_load = false;
    bool of_speed = false;
    [[nodiscard]] bool any() const { return of_load || of_speed; }
  };
  [[nodiscard]] Change change(const Row& a, const Row& b) const;
  void judge_gaps(double period);
  void judge_directions(bearing::LoadInterpolation interpolation);
  void close(double period, bearing::LoadInterpolation interpolation);
  void expect_periodic() const;
  void move_to_front();
  void begin_at_zero(double period, bearing::LoadInterpolation interpolation);

  CsvTable table_;
  bool angle_;
  std::string when_;  ///< name of the column of angle or time
  std::vector<Row> rows_;
  std::vector<std::string> doubts_;
};

}  // namespace shellback::app
