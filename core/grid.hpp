#pragma once
/// The developed bearing surface, cut into cells.
///
/// phi runs circumferentially (counter-clockwise from +X, the direction of positive rotation),
/// z axially with 0 at mid-width. Cells form a tensor grid: phi in [phi_face[0],
/// phi_face[0] + 2 pi], periodic; z in [-B/2, B/2], or, for a scene that is symmetric about
/// mid-width, in [0, B/2] (`half`). Widths need not be equal, so that faces can lie on the
/// edges of supplies. Cell (i, j) has index i * nz + j: one axial line after another.
///
/// A half grid of a full grid with an odd number of axial cells begins with the half of the
/// middle cell: its unknown sits on the plane of symmetry (z[0] = 0), its width is half. Its
/// discrete solution is therefore that of the full grid, to round-off.
#include <limits>
#include <vector>

namespace shellback {

/// One value per cell, index i * nz + j.
using Field = std::vector<double>;

struct FilmGrid {
  int nt = 0;                    ///< circumferential cells [-]
  int nz = 0;                    ///< axial cells that are solved [-]
  bool half = false;             ///< only z >= 0 is solved; integrals count it twice
  double radius = 0.0;           ///< bearing radius R [m]
  double width = 0.0;            ///< full bearing width B [m]
  std::vector<double> phi_face;  ///< nt + 1 circumferential face positions [rad]
  std::vector<double> phi;       ///< nt cell positions [rad]
  std::vector<double> dphi;      ///< nt cell widths [rad]
  std::vector<double> z_face;    ///< nz + 1 axial face positions [m]
  std::vector<double> z;         ///< nz positions of the unknowns [m]
  std::vector<double> dz;        ///< nz cell widths [m]

  [[nodiscard]] int cells() const { return nt * nz; }
  [[nodiscard]] int index(int i, int j) const { return i * nz + j; }
  [[nodiscard]] int next(int i) const { return i + 1 == nt ? 0 : i + 1; }
  [[nodiscard]] int previous(int i) const { return i == 0 ? nt - 1 : i - 1; }
  [[nodiscard]] double area(int i, int j) const { return radius * dphi[i] * dz[j]; }
  [[nodiscard]] double area(int cell) const { return area(cell / nz, cell % nz); }
  [[nodiscard]] double multiplicity() const { return half ? 2.0 : 1.0; }
  /// Axial cells over the full width [-].
  [[nodiscard]] int full_nz() const { return half ? (z[0] == 0.0 ? 2 * nz - 1 : 2 * nz) : nz; }
};

/// Axial cells that are finer at the side edges: faces at z = (B/2) tanh(a x)/tanh(a) for x evenly
/// spaced in [-1, 1]; a = 0: even. Contact and elastic pressure are steepest there. With a = 2 the
/// outermost cells are 0.15 of even ones, those at mid-width 2.07: set by the experiment of
/// docs/decisions/031.
inline constexpr double kEdgeGrading = 2.0;

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

/// Grid with `nt` x `full_nz` cells over the full bearing, as even as the edges allow once the
/// axial grading has been applied.
/// A face lies on each of `phi_edges` and `z_edges`, but edges closer together than a fifth of an
/// even cell are merged, whatever the grading; those of one strip never are: however narrow, it has
/// cells of its own. An axial edge that yields is left out where another, or mid-width, is nearer
/// than a fifth of an even cell and of its distance to the end, and where cells are too few; so are
/// edges of strips nearer to the end than that. A hole gets up to four rows of cells,
/// one for each eight along the bearing; cells beside it begin as wide and grow by a half at most.
/// With `half`, only |z_edges| on z >= 0 is used. Throws InputError if there are more edges than
/// cells.
[[nodiscard]] FilmGrid make_grid(double radius, double width, int nt, int full_nz, bool half,
                                 const GridEdges& phi_edges = {}, const GridEdges& z_edges = {},
                                 double grading = 0.0);

/// Field on the full-width grid from one on a half grid (unchanged if the grid is full).
[[nodiscard]] FilmGrid full_grid(const FilmGrid& grid);
[[nodiscard]] Field mirror_to_full(const FilmGrid& grid, const Field& half_field);

/// Mean over the area of all cells.
[[nodiscard]] double area_mean(const FilmGrid& grid, const Field& field);

/// Field moved from one grid to another of the same bearing by bilinear interpolation between
/// cell positions, periodic in phi, constant beyond the outermost axial cells.
[[nodiscard]] Field interpolate(const FilmGrid& from, const Field& field, const FilmGrid& to);

}  // namespace shellback
