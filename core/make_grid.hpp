#pragma once
/// How a bearing's surface is cut into cells: as even as places on which faces have to lie allow.
#include "core/fitted_faces.hpp"
#include "core/grid.hpp"

namespace shellback {

/// Axial cells that are finer at the side edges: faces at z = (B/2) tanh(a x)/tanh(a) for x evenly
/// spaced in [-1, 1]; a = 0: even. Contact and elastic pressure are steepest there. With a = 2 the
/// outermost cells are 0.15 of even ones, those at mid-width 2.07: set by the experiment of
/// docs/decisions/031.
inline constexpr double kEdgeGrading = 2.0;

/// Grid with `nt` x `full_nz` cells over the full bearing, as even as the edges allow once the
/// axial grading has been applied.
/// A face lies on each of `phi_edges` and `z_edges`, but edges closer together than a fifth of an
/// even cell are merged, whatever the grading; those of one strip never are: however narrow, it has
/// cells of its own. An axial edge that yields is left out where another, or mid-width, is nearer
/// than a fifth of an even cell and of its distance to the end, and where cells are too few; so are
/// edges of strips nearer to the end than that. A hole gets up to four rows of cells,
/// one for each eight along the bearing; cells beside it begin as wide and, where there are cells
/// for it, grow by a half at most. With `half`, only |z_edges| on z >= 0 is used. Throws InputError
/// if there are more edges than cells.
[[nodiscard]] FilmGrid make_grid(double radius, double width, int nt, int full_nz, bool half,
                                 const GridEdges& phi_edges = {}, const GridEdges& z_edges = {},
                                 double grading = 0.0);

}  // namespace shellback
