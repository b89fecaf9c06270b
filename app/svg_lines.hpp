#pragma once
/// Curves in one frame, with a legend.
#include <string>
#include <vector>

#include "app/svg_axes.hpp"

namespace shellback::app {

struct Series {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;  ///< a value that is not a number interrupts the line
  std::string colour;
  std::string dash;  ///< empty: solid
};

struct LinePlot {
  std::string title;
  Axis x;
  std::string y_title;
  std::vector<Series> series;
  bool from_zero = true;  ///< the y axis begins at 0 (pressure, gap) or hugs the data
};

/// Draws into `box`, labels included.
void draw_lines(Svg& svg, const Box& box, const LinePlot& plot, const Theme& theme);

/// Width of a line of text [px], from mean letter widths: exact enough to keep labels apart.
[[nodiscard]] double text_width(std::string_view words, double size);

}  // namespace shellback::app
