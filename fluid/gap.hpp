#pragma once
/// Film thickness: eccentricity, tilt, profile, displacement of the surfaces.
///
///   h = c + profile(phi,z) + shape(phi,z) + d(phi,z) - (e_x + psi_y z) cos phi - (e_y - psi_x z)
///   sin phi   [m]
///
/// e = journal centre minus shell centre at mid-width [m]; psi_x, psi_y = rotation of the journal
/// axis about X and Y [rad]; `profile` = designed or measured deviation of the shell, taken
/// constant per cell, so that its jumps lie on faces; `shape` = the same where it is smooth
/// (relief, crowning, wear), known at cells and faces; d = elastic and thermal widening of the gap,
/// smooth. Positive h is a gap; negative nominal h is legal for rough surfaces in contact. Source:
/// methods 2.1; the signs from design 2 (displacement of the journal towards phi closes the gap
/// there).
#include <array>

#include "core/grid.hpp"
#include "core/outcome.hpp"
#include "fluid/supply.hpp"

namespace shellback::fluid {

/// Position of the journal axis: e_x, e_y [m], psi_x, psi_y [rad].
struct JournalPosition {
  std::array<double, 4> q{};
  [[nodiscard]] double ex() const { return q[0]; }
  [[nodiscard]] double ey() const { return q[1]; }
  [[nodiscard]] double psi_x() const { return q[2]; }
  [[nodiscard]] double psi_y() const { return q[3]; }
};

/// How the gap on a side edge follows what it is made of [-].
struct EdgeSlopes {
  double own = 1.0;   ///< with the displacement of the last cell
  double line = 1.0;  ///< what the straight line through the last two cells adds to that
};

/// A face between film and supply, or at the foot of an opening of the bore, whose gap is not the
/// mean of both cells' (film_gap).
struct BentFace {
  int face = 0;  ///< index in phi_face or z_face
  int cell = 0;  ///< of the film, or of the land beside the opening
  EdgeSlopes slope;
};

/// The gap where the film equation needs it. Face values leave the steps out; the limits on the
/// two sides of a face are the face value plus the profile of the cell on that side.
struct Gap {
  Field cell;                    ///< at cell positions, profile included [m]
  Field phi_face;                ///< on west faces, index i * nz + j, without profile [m]
  Field z_face;                  ///< on axial faces, index i * (nz + 1) + j, without profile [m]
  std::vector<EdgeSlopes> edge;  ///< of line i: 2 i on z_face 0, 2 i + 1 on z_face nz; empty: ones
  std::vector<BentFace> bent_phi, bent_z;  ///< beside supplies
};

/// Places on the side edges and beside supplies where the line is bent (edge_gap): a limiter that
/// acts.
[[nodiscard]] int bent_edges(const Gap& gap);

/// Change of the gap at (cos phi, sin phi, z) per unit change of component k of the position:
/// 0 e_x, 1 e_y, 2 psi_x, 3 psi_y.
[[nodiscard]] inline double gap_slope(int k, double cos_phi, double sin_phi, double z) {
  switch (k) {
    case 0:
      return -cos_phi;
    case 1:
      return -sin_phi;
    case 2:
      return z * sin_phi;
    default:
      return -z * cos_phi;
  }
}

/// Cosines and sines of cell and face positions, computed once per grid.
struct Angles {
  std::vector<double> cos_cell, sin_cell;  ///< nt
  std::vector<double> cos_face, sin_face;  ///< nt, west faces
  explicit Angles(const FilmGrid& grid);
};

/// gap_slope of component k at all cells [-] or, of tilts, [m].
[[nodiscard]] Field gap_slopes(const FilmGrid& grid, const Angles& angles, int k);

/// The gap of a rigid bearing plus the smooth displacement d (cells; empty: none), the profile
/// (cells; empty: none) and the shape (none: a cylinder). Displacements are averaged to faces,
/// continued to the edges as edge_gap says; the shape is taken as it is there. `summits`: height
/// below the mean planes from which on rough surfaces have no room left [m]. At the edge of a
/// supply (none: null), and at the foot of an opening of the bore along the axis, the mean is a
/// line that leads from the land's cell to ground that no film presses upon, where the land may be
/// pressed away by more than the gap that is left: bent as on side edges.
[[nodiscard]] Gap film_gap(const FilmGrid& grid, const Angles& angles, double clearance,
                           const JournalPosition& position, const Field& displacement,
                           const Field& profile, const Gap* shape = nullptr, double summits = 0.0,
                           const SupplyMap* supply = nullptr);

/// The gap on a side edge and its slopes. `own` is the gap there with the displacement of the last
/// cell, `line` what the straight line through the displacements of the last two adds [m]; with
/// H = own + summits
///   h = own + line                    line >= -H/2
///   h = H^2/(-4 line) - summits       below, value and slope going on: H > 0 leaves a gap      (1)
/// A line that takes more than half of the gap within half a cell says that cells do not resolve
/// how the surfaces close towards the edge (decision 040), not that they meet. Where H <= 0 already
/// the line is left out.
struct EdgeGap {
  double h = 0.0;  ///< [m]
  EdgeSlopes slope;
};
inline constexpr double kMostOfEdge = 0.5;  ///< that a line may take [-]
[[nodiscard]] EdgeGap edge_gap(double own, double line, double summits);

/// A smooth cell field on the faces: mean of the two cells by distance; on side edges continued
/// linearly from the two outermost cells; on the plane of symmetry the cell's own value.
/// phi_face, z_face as in Gap.
void to_faces(const FilmGrid& grid, const Field& cells, std::vector<double>& phi_face,
              std::vector<double>& z_face);

/// Smallest film over cells, both sides of the faces around and side edges, and where it is. Inside
/// a supply the gap is deeper by that: a groove does not close where the lands beside it are
/// pressed away from the shaft.
struct SmallestGap {
  double h = 0.0;    ///< [m]
  double phi = 0.0;  ///< from 0 to 2 pi [rad]
  double z = 0.0;    ///< [m]
  [[nodiscard]] FilmPlace place() const { return {phi, z}; }
};
[[nodiscard]] SmallestGap smallest_gap(const FilmGrid& grid, const Gap& gap, const Field& profile,
                                       const SupplyMap& supply);
/// The gap of every cell, in supplies their depth included [m].
[[nodiscard]] Field nominal_depth(const Gap& gap, const SupplyMap& supply);
/// The middle of a cell; -1: no place.
[[nodiscard]] FilmPlace place_of(const FilmGrid& grid, int cell);

}  // namespace shellback::fluid
