#pragma once
/// Grooves and holes: where the film pressure is given by the supply.
///
/// Cells inside a patch are full and carry its pressure; a patch of no circumferential extent is
/// a line on the face between two cells. Make the grid with the patches' edges, so that their
/// extents are met exactly; a hole is the set of cells whose positions lie inside its circle
/// (at least one cell).
///
/// A drilling of the journal turns with it: its mouth is no set of cells. Oil enters cell c through
///   m = G (p_mouth - p)                                                       [kg/s]  (1)
/// where G is large for cells whose unknown lies inside the mouth, and otherwise what makes the
/// links to such cells, of length d, as if p_mouth stood where the mouth's edge cuts them, at the
/// distance r from the unknown:
///   G = sum of K L (1/r - 1/d)                                             [kg/(s Pa)] (2)
/// K the conductance of a square of film, L the width of the link. As the mouth moves, r and with
/// it the flow change without jumps. Valid while the mouth is wider than a cell's diagonal. Where
/// two reach over one unknown it is the nearer one's, of equally near ones that of the higher
/// pressure.
#include <vector>

#include "core/fitted_faces.hpp"
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
  bool moving = false;  ///< the mouth of a drilling: phi changes, and it takes no cell
};

/// Where oil of a moving patch enters a cell, (1).
struct Mouth {
  int cell = 0;
  int patch = 0;
  double conductance = 0.0;  ///< G [kg/(s Pa)]
};

struct SupplyMap {
  std::vector<SupplyPatch> patches;
  std::vector<int> cell;  ///< per cell: patch it lies in, -1 for film
  std::vector<int> line;  ///< per west face of a cell: patch of the line on it, -1 for none
  /// Per patch: the first of those that it touches, one by way of another; itself if none.
  std::vector<int> touching;
  bool has_lines = false;
  std::vector<Mouth> mouths;  ///< of moving patches as they stand; several a cell between them
  /// Distance from the unknown of a film cell to the edge of the patch in the cell beside it, along
  /// the link between the two [m]; per west face of a cell, and per axial face, i (nz + 1) + j.
  /// Half the film cell where a face is the edge; the circle itself where a round hole's edge cuts
  /// links. Zero on faces that do not part film and patch.
  std::vector<double> phi_reach, z_reach;
};

/// Positions on which faces should lie: the ends of every patch [rad], [m].
[[nodiscard]] GridEdges phi_edges(const std::vector<SupplyPatch>& patches);
[[nodiscard]] GridEdges z_edges(const std::vector<SupplyPatch>& patches);

/// Part of a link that its film unknown keeps from the edge of a patch: bounds the film matrix, and
/// moves the edge by less than a thousandth of a cell; r of (2) is no shorter, either [-].
inline constexpr double kShortestReach = 1e-3;

/// 1 in the cells that supplies take, elsewhere 0 [-].
[[nodiscard]] Field in_supply(const SupplyMap& map);

/// Sum over the patches that touch, under the first of them; 0 under the others. `of_patch` of any
/// unit, `touching` as in SupplyMap.
[[nodiscard]] std::vector<double> sum_over_touching(const std::vector<int>& touching,
                                                    const std::vector<double>& of_patch);

/// Marks cells and faces of patches that do not move. Throws InputError if two patches overlap.
[[nodiscard]] SupplyMap map_supplies(const FilmGrid& grid, const std::vector<SupplyPatch>& patches);

/// Largest diagonal of a cell [m]: mouths of a smaller diameter are taken as wide as that.
[[nodiscard]] double cell_diagonal(const FilmGrid& grid);

/// The mouths of moving patches where they stand now, by (2). `conductance`: K per cell,
/// rho h^3 phi g [kg/(s Pa)].
void place_mouths(const FilmGrid& grid, const Field& conductance, SupplyMap& supply);

}  // namespace shellback::fluid
