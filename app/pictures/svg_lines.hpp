#pragma once
/// Curves in one frame, with a legend.
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/svg_axes.hpp"

namespace shellback::app {

struct Series {
  std::string name;  ///< empty: not in the legend
  std::vector<double> x;
  std::vector<double> y;  ///< a value that is not a number interrupts the line
  std::string colour;
  std::string dash;           ///< empty: solid
  std::vector<double> bar{};  ///< half-width of a band around it; empty: none
  bool dots = false;          ///< a point that no line joins is drawn as a dot, its bar upright
};

struct LinePlot {
  std::string title;
  Axis x;
  std::string y_title;
  std::vector<Series> series;
  bool from_zero = true;    ///< the y axis begins at 0 (pressure, gap) or hugs the data
  std::optional<Axis> y{};  ///< the y axis, if the data are not to choose it; `y_title` is not used
};

/// Draws into `box`, labels included. Gives the frame, for more to be drawn in it.
Frame draw_lines(Svg& svg, const Box& box, const LinePlot& plot, const Theme& theme);

}  // namespace shellback::app
