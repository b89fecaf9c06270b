#pragma once
/// A surface in colour with axes, colour bar, outlines and marked points.
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/svg_axes.hpp"
#include "app/pictures/svg_contour.hpp"

namespace shellback::app {

struct Mark {
  Point at;  ///< in values of the axes
  std::string label;
};

struct FieldMap {
  std::string title;
  std::string unit;  ///< of the values, at the colour bar
  Surface surface;
  ColourScale scale;
  Axis x;
  Axis y;
  std::vector<std::vector<Point>> outlines;  ///< closed, in values of the axes; may leave the box
  std::optional<Surface> full_film;  ///< fill ratio; a dashed line is drawn where the film ends
  std::vector<Mark> marks;
};

/// Draws into `box`, labels included. A surface that holds values that are not numbers is not
/// drawn; a line of text says so.
void draw_map(Svg& svg, const Box& box, const FieldMap& map, const Theme& theme);

/// The parts of it. Where the surface lies in `box`:
[[nodiscard]] Frame map_frame(const Box& box, const FieldMap& map);
/// The colours, and the dashed end of the full film; to be clipped to the frame.
void draw_film(Svg& svg, const Frame& frame, const FieldMap& map, int bands = 40);
/// Outlines, marks and colour bar.
void draw_surroundings(Svg& svg, const Frame& frame, const FieldMap& map, const Theme& theme);

/// Vertical bar right of `plot` with ticks and unit.
void draw_colour_bar(Svg& svg, const Box& plot, const ColourScale& scale, const std::string& unit,
                     const Theme& theme);

}  // namespace shellback::app
