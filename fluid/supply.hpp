#pragma once
/// Grooves and holes: where the film pressure is given by the supply.
///
/// Cells inside a patch are full and carry its pressure; a patch of no circumferential extent is
/// a line on the face between two cells. Make the grid with the patches' edges, so that their
/// extents are met exactly; a hole is the set of cells whose positions lie inside its circle
/// (at least one cell).
#include <vector>

#include "core/grid.hpp"

namespace shellback::fluid {

/// One region of given pressure.
struct SupplyPatch {
  double phi = 0.0;       ///< circumferential position of its middle [rad]
  double z = 0.0;         ///< axial position of its middle [m]
  double arc = 0.0;       ///< circumferential extent [rad]; 0: a line; >= 2 pi: all round
  double length = 0.0;    ///< axial extent [m]
  bool round = false;     ///< a circle inscribed in arc x length
  double pressure = 0.0;  ///< gauge [Pa]
  double depth = 0.0;     ///< added to the gap for friction [m]
  /// Fill ratio of the oil that the journal drags out of it; below 1 only in a vessel that has come
  /// down to the cavitation pressure [-]
  double fill = 1.0;
};

struct SupplyMap {
  std::vector<SupplyPatch> patches;
  std::vector<int> cell;  ///< per cell: patch it lies in, -1 for film
  std::vector<int> line;  ///< per west face of a cell: patch of the line on it, -1 for none
  bool has_lines = false;
  /// Distance from the unknown of a film cell to the edge of the patch in the cell beside it, along
  /// the link between the two [m]; per west face of a cell, and per axial face, i (nz + 1) + j.
  /// Half the film cell where a face is the edge; the circle itself where a round hole's edge cuts
  /// links. Zero on faces that do not part film and patch.
  std::vector<double> phi_reach, z_reach;
};

/// Positions on which faces should lie: the ends of every patch [rad], [m].
[[nodiscard]] std::vector<double> phi_edges(const std::vector<SupplyPatch>& patches);
[[nodiscard]] std::vector<double> z_edges(const std::vector<SupplyPatch>& patches);

/// Marks cells and faces. Throws InputError if two patches overlap.
[[nodiscard]] SupplyMap map_supplies(const FilmGrid& grid, const std::vector<SupplyPatch>& patches);

}  // namespace shellback::fluid
