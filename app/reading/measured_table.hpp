#pragma once
/// Measured points from a table beside a case: where the bearing ran, and what was measured there.
///
///   speed [rpm], load [kN], oil_temperature [degC], friction_torque [N m], friction_torque_sd [N
///   m] 300, 2, 80, 0.21, 0.004
///
/// Columns that say where: speed, load, load_angle, oil_temperature, supply_temperature,
/// supply_pressure (of every supply). Columns that are measured: quantities of the result, each
/// with its standard deviation (NAME_sd) or none. shell_back_temperature is given to tier
/// isothermal (whose film temperature follows from it) and compared with the others.
/// Problems are InputError at file:line:column.
#include <string>
#include <vector>

#include "app/reading/overrides.hpp"
#include "app/study/identify.hpp"

namespace shellback::app {

/// A column that says where: the keys that it sets, and a value for every point.
struct MeasuredInput {
  std::string column;  ///< "speed"
  study::Axis axis;    ///< of its numbers over the points; its key is the first of `keys`
  std::vector<std::string> keys;  ///< "operation.speed"
};

struct MeasuredTable {
  std::string path;
  std::vector<MeasuredInput> inputs;
  std::vector<study::MeasuredPoint> points;  ///< those of one curve behind one another
  std::vector<std::string> places;           ///< "data.csv:4" of every point
  std::vector<std::string> quantities;       ///< measured ones, in the order of the columns
  bool deviations_known = false;

  /// What the point at place `at` changes in the case; a fraction lies between two of one curve.
  [[nodiscard]] std::vector<Override> overrides_at(double at) const;
};

/// Reads the table for a case with so many supplies. Curves are points that share all inputs but
/// speed (or, without one, the first input), sorted along it. Throws FileError, InputError as
/// CsvTable does and for: no column that says where or none that is measured, a deviation that is
/// not positive or belongs to nothing, several quantities not all of which have one.
/// `omega`: speed of the case, which holds where the table has none; only its sign counts.
[[nodiscard]] MeasuredTable read_measured_table(const std::string& path, int supplies,
                                                bool isothermal, double omega = 0.0);

}  // namespace shellback::app
