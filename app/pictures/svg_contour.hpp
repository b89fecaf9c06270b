#pragma once
/// Filled contours by marching squares.
#include <functional>
#include <string>
#include <vector>

#include "app/pictures/svg.hpp"
#include "app/pictures/svg_colour.hpp"
#include "core/grid.hpp"

namespace shellback::app {

/// Values on a tensor grid; both coordinates rise. Index i * y.size() + j.
struct Surface {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> value;
  [[nodiscard]] double at(int i, int j) const {
    return value[static_cast<std::size_t>(i) * y.size() + static_cast<std::size_t>(j)];
  }
};

/// Where (x, y) of a surface lies on the picture [px].
using Place = std::function<Point(double x, double y)>;

/// A film field on the unrolled bearing: x in [0, 360] deg, y in [-B/2, B/2] in mm. Cell values
/// stand at the cell positions; the seam is interpolated, the rims are extrapolated by half a
/// cell, within the range of the field's values.
[[nodiscard]] Surface unrolled(const FilmGrid& grid, const Field& field);

/// A quantity over phi and another coordinate, `values` index i * y.size() + k: x in [0, 360] deg.
[[nodiscard]] Surface around(const FilmGrid& grid, const std::vector<double>& y,
                             const std::vector<double>& values);

/// Closed paths around {value >= level}, linear within each cell, on the picture. The sides of
/// the surface count as boundary. Points that lie on a line within a twentieth of a pixel are
/// left out.
[[nodiscard]] std::string superlevel_path(const Surface& surface, double level, const Place& place);

/// The surface in colour: `bands` equal steps of the scale, each painted over the one below.
void draw_bands(Svg& svg, const Surface& surface, const ColourScale& scale, const Place& place,
                int bands = 40);

/// Whether all values are finite; a field of a failed solve need not be.
[[nodiscard]] bool drawable(const std::vector<double>& values);

}  // namespace shellback::app
