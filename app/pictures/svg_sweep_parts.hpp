#pragma once
/// What the pictures of a sweep share: which points stand where.
#include <optional>
#include <string>
#include <vector>

#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_axes.hpp"
#include "app/study/sweep.hpp"

namespace shellback::app {

/// One line of a picture.
struct SweepLine {
  std::string label;                             ///< "load 4 kN"
  std::vector<double> x;                         ///< rising, in the unit of the x axis
  std::vector<const study::SweepPoint*> points;  ///< at these x
  std::vector<int> others;                       ///< indices on the axes but that of x
};

/// The axis drawn along x: the first that holds numbers, at least two; -1 if there is none.
[[nodiscard]] int x_axis_of(const std::vector<study::Axis>& axes);

/// All lines along axis `x`, in the order of the other axes.
[[nodiscard]] std::vector<SweepLine> lines_along(const study::Sweep& sweep, int x);

/// "speed [rpm]"
[[nodiscard]] std::string axis_title(const study::Axis& axis);

/// From the least to the largest value with a little room, logarithmic if the axis is so.
[[nodiscard]] Axis drawn_axis(const study::Axis& axis, double room);

/// Unit in which the quantity is drawn, and the values of all solved points in it.
struct DrawnQuantity {
  std::string name;
  DisplayUnit unit;
  double low = 0.0;                    ///< in `unit`
  double high = 0.0;                   ///< in `unit`
  double lowest = 0.0, highest = 0.0;  ///< with room for error bars, in `unit`
  /// Value at the point in `unit`; not-a-number if it is not solved.
  [[nodiscard]] double at(const study::SweepPoint& point) const;
  /// Its error bar in `unit`; not-a-number if it is not known.
  [[nodiscard]] double bar(const study::SweepPoint& point) const;
};
[[nodiscard]] std::optional<DrawnQuantity> drawn_quantity(const study::Sweep& sweep,
                                                          const std::string& name);

/// Both pictures draw below the heading, on the whole width of `svg` (1200 px).
void draw_sweep_lines(Svg& svg, const std::string& text, const bearing::Case& subject,
                      const study::Sweep& sweep, const Theme& theme);
/// Maps over the first two numeric axes, the others at their first value. Gives what was left out,
/// in words.
[[nodiscard]] std::string draw_sweep_maps(Svg& svg, const study::Sweep& sweep, const Theme& theme);

/// Diagonal cross where a point is not solved.
void draw_cross(Svg& svg, Point at, const std::string& colour);

}  // namespace shellback::app
