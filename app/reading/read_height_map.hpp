#pragma once
/// A height map from a text file, in SI units.
///
/// Two layouts, told apart by the first line that is no comment:
///
///   matrix    heights, a row of the map per line from top to bottom, with the sizes in the header
///             (Gwyddion's ASCII matrix; `# Pitch: 0.5 um` instead of both sizes):
///               # Width: 100 um
///               # Height: 80 um
///               # Value units: nm
///   columns   x, y, z with units in the first line, every point once, in any order:
///               x [um], y [um], z [nm]
///
/// Fields end at a comma, semicolon or tab, in a line without these at blanks. A field that is
/// empty, `nan` or `bad` (any case) is a hole, and so is a point of the grid that is not given.
/// `z` heights rise out of the solid.
#include <string>

#include "surface/height_map.hpp"

namespace shellback::app {

/// Which way of the map the surfaces move.
enum class Motion { x, y };

/// With the motion along x of the map given back. Throws FileError if the file cannot be read;
/// InputError with file:line:column for: no or wrong units, no size, rows of unequal length, a
/// field that is no number, points that lie on no even grid or twice in one place, fewer than 8
/// points each way or more than 4 million, a file beyond 200 MB.
[[nodiscard]] surface::HeightMap read_height_map(const std::string& path, Motion motion);

}  // namespace shellback::app
