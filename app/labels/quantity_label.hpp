#pragma once
/// How a reported quantity is shown to people: words, engineering unit, figures.
///
/// Inside and in JSON all is SI; tables and pictures show um, MPa, degC, W or kW, l/min, deg.
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bearing/result.hpp"

namespace shellback::app {

/// shown = (SI value - offset) * scale.
struct DisplayUnit {
  std::string unit;
  double scale = 1.0;
  double offset = 0.0;
  [[nodiscard]] double operator()(double si) const { return (si - offset) * scale; }
};

/// "friction torque" for friction_torque; a name that is not in the table gets its underscores
/// replaced by blanks.
[[nodiscard]] std::string quantity_label(const std::string& name);

/// Unit for showing the quantity `name` that is kept in `si_unit`. `largest` is the largest
/// magnitude to be shown [si_unit]: it decides between W and kW, N and kN.
[[nodiscard]] DisplayUnit display_unit(const std::string& name, const std::string& si_unit,
                                       double largest = 0.0);

/// "µm" for "um", "°C" for "degC", "m³/s" for "m3/s": for pages, where the table is plain ASCII.
[[nodiscard]] std::string typeset_unit(const std::string& unit);

/// `digits` significant figures, without exponent between 1e-4 and 1e6; "n/a" if not a number.
[[nodiscard]] std::string figures(double value, int digits = 4);

/// "200 × 25", for pages; "none" if no film was solved.
[[nodiscard]] std::string grid_words(const std::array<int, 2>& grid);

/// A time that an event or a period takes: "12.5 ms", "7 s".
[[nodiscard]] std::string duration_words(double t);

/// Error bars of one value, in the row's unit; not-a-number: not known.
struct ShownBars {
  double grid = 0.0;
  double model = 0.0;
  double total = 0.0;
  double limit = 0.0;  ///< no bar: what the grids lead to
  double time = 0.0;   ///< of a load cycle's steps
};

/// What was measured of a quantity, in its unit; a torque, which is measured by its magnitude, has
/// the sign of what is computed.
[[nodiscard]] std::optional<double> measured_value(const bearing::Measured& m,
                                                   const bearing::Quantity& q);

/// The measured torque, which is a magnitude, with the sign of what is computed: that of the speed
/// [N m].
[[nodiscard]] std::optional<double> measured_torque(const bearing::Case& c);

/// One row of a comparison: a quantity in all results and its measured value.
struct QuantityRow {
  std::string name;
  std::string label;
  DisplayUnit unit;
  std::vector<std::optional<double>> values;  ///< per result, in `unit`; none: tier knows it not
  std::optional<double> measured;             ///< in `unit`
  std::vector<ShownBars> bars{};              ///< per result
};

/// True if any value of the row has a bar.
[[nodiscard]] bool has_bars(const QuantityRow& row);

/// "+-0.012" with two figures; empty if the bar is not known.
[[nodiscard]] std::string bar_figures(double bar);

/// All quantities of `results` in the order in which they first appear.
[[nodiscard]] std::vector<QuantityRow> quantity_rows(const bearing::Measured& measured,
                                                     const std::vector<bearing::Result>& results);

/// Name of each result's column: its tier, numbered if a tier appears more than once.
[[nodiscard]] std::vector<std::string> column_names(const std::vector<bearing::Result>& results);

/// All distinct lines that `lines_of` gives for the columns, those of some of them with their
/// names: "thd, tehd: the film is not laminar".
[[nodiscard]] std::vector<std::string> lines_of_columns(
    const std::vector<bearing::Result>& results,
    const std::function<std::vector<std::string>(const bearing::Result&)>& lines_of);

/// Difference of `value` against `reference`: "+3.1 %", or "+2.4 K" for temperatures in degC.
[[nodiscard]] std::string difference(const DisplayUnit& unit, double value, double reference);

/// "converged", with what no oil survives said behind it, or "NOT CONVERGED: iteration limit".
[[nodiscard]] std::string status_line(const bearing::Result& result);

/// ASCII for text tables, or with the signs of print (µm, °, ×, −) for pages and pictures.
enum class Writing { plain, typeset };

/// One speed, or from the lowest to the highest of a load cycle.
[[nodiscard]] std::string speed_words(const bearing::Case& c);

/// Bearing and operating point in one line, in engineering units.
[[nodiscard]] std::string describe_case(const bearing::Case& c, Writing writing);

/// `number` with a true minus sign.
[[nodiscard]] std::string typeset_number(std::string number);

/// A step's change with its sign [N m], to a ten-thousandth of the larger torque or finer.
[[nodiscard]] std::string signed_change(const bearing::FrictionSplit& split, double change);

/// The same as a torque against the motion, positive however the journal turns [N m].
[[nodiscard]] bearing::FrictionSplit against_the_motion(bearing::FrictionSplit split);

/// "calibrated equivalent temperature 106.2 degC: there the isothermal torque is the full one", or
/// over which temperatures it is which torques, none of them the full one.
[[nodiscard]] std::string calibration_words(const bearing::Comparison& comparison, Writing writing);

/// What the steps leave unexplained: to - from - sum of the steps [N m].
[[nodiscard]] double unexplained(const bearing::FrictionSplit& split);

/// Part of the larger torque above which the rest counts as a gap in the split [-]: a tenth of
/// what three printed figures resolve.
inline constexpr double kNegligibleRest = 1e-4;

}  // namespace shellback::app
