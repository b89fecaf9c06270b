#pragma once
/// A line cut into cells whose faces lie on given places: the edges of supplies.
#include <limits>
#include <vector>

namespace shellback {

/// A place on which a face lies [rad, any branch; m, |z| < B/2].
struct GridEdge {
  double at = 0.0;
  int strip = -1;       ///< its other edge has the same number; -1: not that of a strip
  bool yields = false;  ///< that of an opening at the bearing's end
  /// Diameter of the hole whose edge it is: axial cells beside it begin no wider than that over its
  /// rows of cells, since pressure falls off as a logarithm there.
  double beside = std::numeric_limits<double>::infinity();
  GridEdge(double place, int of = -1, bool yield = false) : at(place), strip(of), yields(yield) {}
};
using GridEdges = std::vector<GridEdge>;

/// Faces [unit of the edges, sorted] of `n` cells from the first to the last edge, one on each
/// edge, as even as can be but for at least `rows` cells in a hole (`cut` in one that mid-width
/// cuts, whose edges are the first two) and beside it, where there are cells for it, what grows
/// from them by a half at most. Throws InputError if there are more segments than cells.
[[nodiscard]] std::vector<double> fitted_faces(const GridEdges& edges, int n, int rows = 1,
                                               int cut = 1);

}  // namespace shellback
