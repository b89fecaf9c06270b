#pragma once
/// Meridian section of a body of revolution, cut into eight-node serendipity rectangles.
///
/// Shared by conduction (thermal/) and elasticity (solid/), so that nodal temperatures of the one
/// are nodal temperatures of the other. Fields over the circumference are Fourier series in phi,
/// hence only the section (r, z) is meshed [textbook: semi-analytical finite elements].
///
/// The mesh is a tensor product: `rows` elements in r, `cols` in z. Nodes are numbered from the
/// smallest radius outwards in groups: group k holds corner line k (2 cols + 1 nodes on
/// r_face[k]) and then the mid-side nodes of row k (cols + 1); the last group is the outermost
/// corner line alone. Elements couple a group only to itself and to the head (the corner line)
/// of the next: the block tridiagonal form that core/block_cholesky.hpp factors.
#include <array>
#include <vector>

#include "core/eigen.hpp"
#include "core/grid.hpp"

namespace shellback {

struct RevolutionMesh {
  int rows = 0;                             ///< radial elements [-]
  int cols = 0;                             ///< axial elements [-]
  bool half = false;                        ///< z_face[0] = 0 is a plane of symmetry
  std::vector<double> r_face;               ///< rows + 1 radii, ascending [m]
  std::vector<double> z_face;               ///< cols + 1 axial positions, ascending [m]
  std::vector<int> layer;                   ///< material index of each row
  std::vector<double> r;                    ///< node radii [m]
  std::vector<double> z;                    ///< node axial positions [m]
  std::vector<std::array<int, 8>> element;  ///< node numbers, index row * cols + col

  [[nodiscard]] int nodes() const { return static_cast<int>(r.size()); }
  [[nodiscard]] int line_nodes() const { return 2 * cols + 1; }
  /// First node of group k, 0 <= k <= rows + 1; node m of corner line k is group_begin(k) + m.
  [[nodiscard]] int group_begin(int k) const { return k <= rows ? k * (3 * cols + 2) : nodes(); }
  /// Mid-side node m (0..cols) of row k, halfway between corner lines k and k + 1.
  [[nodiscard]] int mid_node(int k, int m) const { return group_begin(k) + line_nodes() + m; }
  [[nodiscard]] const std::array<int, 8>& at(int row, int col) const {
    return element[row * cols + col];
  }
};

/// Mesh on given radial and axial faces; `layer` gives the material of each radial row.
/// With `half`, z_face must begin at 0.
[[nodiscard]] RevolutionMesh make_revolution_mesh(std::vector<double> r_face,
                                                  std::vector<int> layer,
                                                  std::vector<double> z_face, bool half);

/// Radial faces and the layer of each row.
struct RadialRows {
  std::vector<double> face;  ///< ascending [m]
  std::vector<int> layer;    ///< one entry fewer
};
/// Rows from the bore radius outwards through layers of given thickness [m]: at least two to a
/// layer, the first of each layer no higher than `first` (or twice its neighbour, if larger),
/// growing outwards by a factor of at most two. `least`: rows of each layer that are wanted at
/// least; empty: two.
[[nodiscard]] RadialRows rows_outwards(double radius, const std::vector<double>& thickness,
                                       double first, const std::vector<int>& least = {});
/// Rows of a solid cylinder, from the axis r = 0 to `radius`, `first` being the height at the
/// surface and the growth of the rows towards the axis at most twofold.
[[nodiscard]] RadialRows rows_of_cylinder(double radius, double first);

/// Height of the surface row that resolves circumferential harmonics up to `harmonics` [m]:
/// the field of harmonic n decays over R / n, and a quadratic row of twice the shortest such
/// depth follows it to the accuracy that the axial elements have as well.
[[nodiscard]] double surface_row(double radius, int harmonics);

/// Axial faces of the elements under a film [m]: those of the film's cells, so that a pressure
/// which is constant on each cell has its jumps between elements; at least six elements to half the
/// width, cells being cut evenly where there are fewer. In a grid that mirrors itself about
/// mid-width z = 0 is a face too, so that a half grid has the mesh of the full one. `overhang` [m]
/// on each side (one side if the grid is half) is added in elements that double in length.
/// `per_cell`: elements of a cell at least.
[[nodiscard]] std::vector<double> axial_elements(const FilmGrid& grid, double overhang = 0.0,
                                                 int per_cell = 1);

/// Faces with `length` [m] added on each side (the high one if `half`) in elements that double in
/// length.
[[nodiscard]] std::vector<double> continued(std::vector<double> face, double length, bool half);

/// For each node of a mesh that goes on beyond another of the same rows, by as many elements on
/// each side: the other's node in its place, or at its end on the same radius.
[[nodiscard]] std::vector<int> nearest_along(const RevolutionMesh& longer,
                                             const RevolutionMesh& mesh);

/// Faces with every interval halved: the refinement of convergence studies.
[[nodiscard]] std::vector<double> halved(const std::vector<double>& face);
[[nodiscard]] RadialRows halved(const RadialRows& rows);

/// Gauss points on [-1, 1] and their weights, 2 or 3 of them.
struct GaussRule {
  std::vector<double> x, w;
};
[[nodiscard]] GaussRule gauss_rule(int order);

/// Shape functions of one element at one quadrature point.
struct ShapePoint {
  double r = 0.0, z = 0.0;  ///< place [m]
  double weight = 0.0;      ///< quadrature weight times area, without the factor r [m2]
  Eigen::Matrix<double, 8, 1> n, n_r, n_z;  ///< values [-], derivatives in r and z [1/m]
};
/// Gauss points in r and in z (2 or 3 each).
struct GaussOrder {
  int r = 2;
  int z = 2;
};
/// Points of the Gauss rule of order.r x order.z in element (row, col).
[[nodiscard]] std::vector<ShapePoint> shape_points(const RevolutionMesh& mesh, int row, int col,
                                                   GaussOrder order);

/// Integrals of the line's shape functions over the axial film cells, exact: entry (m, j) is
/// int over cell j of N_m(z) dz [m], (2 cols + 1) x nz. Load vector of a pressure that is
/// constant on each cell, and, divided by dz, the cell mean of a surface displacement: one
/// matrix for both makes the work of pressures on displacements symmetric.
[[nodiscard]] Eigen::MatrixXd cell_integrals(const RevolutionMesh& mesh, const FilmGrid& grid);

}  // namespace shellback
