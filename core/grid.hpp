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

/// The grid of both halves (a full grid: itself), and the field there of one on a half grid.
[[nodiscard]] FilmGrid full_grid(const FilmGrid& grid);
[[nodiscard]] Field mirror_to_full(const FilmGrid& grid, const Field& half_field);

/// x A of each cell: what lies in it of a field that is given per area.
[[nodiscard]] Field per_cell(const FilmGrid& grid, Field per_area);

/// Integral of x dA over the whole surface, both halves: the sum of x A over the cells.
[[nodiscard]] double area_integral(const FilmGrid& grid, const Field& field);

/// Mean over the area of all cells.
[[nodiscard]] double area_mean(const FilmGrid& grid, const Field& field);

/// Mean over the width of nz values, one a ring of cells.
[[nodiscard]] double axial_mean(const FilmGrid& grid, const std::vector<double>& of_rings);

/// Field moved from one grid to another of the same bearing by bilinear interpolation between
/// cell positions, periodic in phi, constant beyond the outermost axial cells.
[[nodiscard]] Field interpolate(const FilmGrid& from, const Field& field, const FilmGrid& to);

}  // namespace shellback
