#pragma once
/// The designed or measured bore: how far it lies outside the cylinder of radius R.
///
/// Two kinds. `profile` may jump (grooves, dimples): constant on each cell, its jumps on faces.
/// The smooth rest enters the gap as a displacement, known where the film equation needs it, and is
/// of second order up to the side edges:
///   shape(phi, z) = table + d_r (x_r/l_r)^2 + d_c x_c/l_c,   x = max(0, |z| - (B/2 - l))      (1)
/// table: shape and wear, bilinear between its points, periodic in phi, constant beyond its axial
/// ends; edge relief of depth d_r over the length l_r, a parabola; chamfer d_c over l_c, a cone.
/// Positive opens the gap [m]. Textbook.
#include "bearing/case.hpp"
#include "core/grid.hpp"
#include "fluid/film_flux.hpp"
#include "fluid/gap.hpp"

namespace shellback::bearing {

/// `profile` at the cells' middles [m]; empty: none.
[[nodiscard]] Field profile_of_cells(const Bearing& b, const FilmGrid& grid);

/// (1) at one place [m].
[[nodiscard]] double shape_at(const Bearing& b, double phi, double z);

/// (1) at cells and faces [m]; all empty: a cylinder.
[[nodiscard]] fluid::Gap shape_of(const Bearing& b, const FilmGrid& grid);

/// How that shape opens from axial faces to the cells beside them; empty: a cylinder.
[[nodiscard]] fluid::ShapeBeside shape_beside_faces(const FilmGrid& grid, const fluid::Gap& shape);

/// What a grid cannot show of the smooth shape: its largest distance from straight lines between
/// middles and faces of cells, at the points of its tables and where an edge's opening begins.
struct MissedShape {
  double depth = 0.0;  ///< [m]
  double phi = 0.0, z = 0.0;
};
[[nodiscard]] MissedShape missed_shape(const Bearing& b, const FilmGrid& grid);

/// The volume of the profile on the grid less that of its table, over that of its magnitude [-].
[[nodiscard]] double missed_profile(const Bearing& b, const FilmGrid& grid);

/// How far a rigid journal that is not tilted can move towards each of n even angles before it
/// meets the bore [m]: min of (c + shape)/cos(phi - theta) over the half turn about theta and the
/// width, on a mesh of n x 33 places. A cylinder: c everywhere.
[[nodiscard]] std::vector<double> room_around(const Bearing& b, int n);

/// True if profile and shape are the same on both sides of mid-width.
[[nodiscard]] bool bore_is_symmetric(const Bearing& b);

}  // namespace shellback::bearing
