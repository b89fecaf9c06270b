#pragma once
/// Temperatures of wall skins (thermal/wall_skin.hpp) as nodal temperatures of a wall's mesh.
#include <Eigen/SparseCore>
#include <vector>

#include "core/grid.hpp"
#include "core/revolution_mesh.hpp"

namespace shellback::bearing {

/// Where the skin behind each axial cell of the film has its nodes.
struct SkinNodes {
  std::vector<double> depth;  ///< from the surface on [m]; beyond the last the skin is not warmer
  int count = 0;  ///< of nodes, those first in `depth`; at one more the skin ends with 0
};

/// The surface that a skin lies behind.
enum class SkinOf { bore, journal };

/// Entry (a, j count + s): temperature of the mesh's node a for 1 K of node s behind axial cell j,
/// straight between nodes [-]. On each radius of the mesh, with N the shape functions along it,
///   T_a = int N_a T r dr / int N_a r dr,                                               (1)
/// so that the integral of T is kept, and of what lies at the surface its place; along the axis
/// straight between the cells' middles, none beyond the film. Our own; textbook (lumped masses).
[[nodiscard]] Eigen::SparseMatrix<double> nodes_of_skins(const RevolutionMesh& mesh,
                                                         const FilmGrid& grid, SkinOf surface,
                                                         const SkinNodes& skin);

}  // namespace shellback::bearing
