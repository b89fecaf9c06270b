#pragma once
/// Mass flow through every face of the film, and its derivatives.
///
/// Averaged generalized Reynolds flux per width, journal speed U, shell at rest [kg/(m s)]:
///   m_x = rho { theta_f [U chi hT + U/2 sigma phi_s] - phi_x h^3 g dp/dx }
///   m_z = -rho phi_z h^3 g dp/dz
/// Over a step dt a cell stores oil, per area [kg/(m2 s)]:
///   (M - M_before)/dt,   M = rho(p) theta hT                                    [kg/m2]
/// in conservative form: what a cell holds at the end of one step is what it holds at the
/// beginning of the next. A step without end is the steady film. Source: seed 000 Eq. 1; backward
/// Euler, textbook.
///
/// with the Dowson integrals F0 = int 1/eta dy, F1 = int y/eta dy,
/// F2 = int (y/eta)(y - F1/F0) dy, the fluidity g = F2/h^3 [1/(Pa s)] (1/(12 eta) if eta is
/// uniform) and the Couette share chi = 1 - F1/(h F0) [-] (1/2 if uniform); hT the average gap of
/// rough surfaces, phi_* the flow factors. Sources: seed 000 Eq. 1; methods 1.1.
///
/// Discretisation. h at faces is centred (second order), theta_f is the fill ratio of the upstream
/// cell (in time such that its oil is carried with second order, fill_front.hpp), the fluidity of
/// a face is the logarithmic mean of its cells: for Barus oil that is the exact mean of
/// exp(-alpha p) between the two pressures, so that the flux is linear in
/// q = (1 - exp(-alpha p))/alpha. Where the gap jumps on a face, the two half cells are in
/// series: pressure and flow are continuous, and in full film the jump costs no accuracy. (Where
/// the film ruptures on a jump the flow is first order: the empty cell's pressure stands half a
/// cell behind it.) Where the shape of the bore opens or closes along the axis, a half cell of
/// length l counts as l f(x), x = what it opens by over the average gap at the face:
/// f = int (h_face/h)^3 dz/l = (1 + x/2)/(1 + x)^2 for a straight gap, 2 - f(-x) where it closes. A
/// chamfer within one cell takes no more pressure than it does.
#include <array>
#include <limits>
#include <vector>

#include "core/grid.hpp"
#include "fluid/carried_fill.hpp"
#include "fluid/flow_factors.hpp"
#include "fluid/gap.hpp"
#include "fluid/gap_transport.hpp"
#include "fluid/supply.hpp"

namespace shellback::fluid {

enum class SideEdges {
  flooded,  ///< oil at ambient pressure stands outside: it may flow in
  dry,      ///< nothing flows in
};

/// The step in time at whose end the film stands, and the oil with which it began. Default: a step
/// without end.
struct FilmStorage {
  double dt = std::numeric_limits<double>::infinity();  ///< [s]
  Field before;   ///< M per cell at the beginning; empty: a step without end [kg/m2]
  Field front{};  ///< f of fill_front.hpp; empty: each cell's own fill ratio is carried [-]
  [[nodiscard]] bool finite() const { return !before.empty(); }
};

/// What the smooth shape of the bore (gap.hpp) has at the two unknowns beside an axial face more
/// than on it [m]; index i * (nz + 1) + j. Empty: a cylinder.
struct ShapeBeside {
  Field below;  ///< towards -z
  Field above;
};

/// Cells, edges and surfaces of a film: the same at every instant.
struct FilmDomain {
  FilmGrid grid;
  Angles angles{FilmGrid{}};
  double p_cavitation = 0.0;  ///< [Pa]
  double p_edge = 0.0;        ///< pressure at the side edges [Pa]
  SideEdges edges = SideEdges::flooded;
  RoughPair rough;  ///< smooth: sigma = 0
  ShapeBeside shape_beside{};
};

/// What stays the same while one film is solved.
struct FilmScene : FilmDomain {
  SupplyMap supply;
  double speed = 0.0;  ///< surface speed of the journal U, positive in +phi [m/s]
  FilmStorage storage;
};

/// Oil at its present state, per cell.
struct FilmCoefficients {
  Field fluidity;         ///< g [1/(Pa s)]
  Field chi;              ///< Couette share [-]
  Field alpha;            ///< -d ln g / d p [1/Pa]
  Field density;          ///< [kg/m3]
  Field compressibility;  ///< d ln(density) / d p; empty: none [1/Pa]
  /// What oil that thins flows more by for more slope of pressure around and along, over g h^3:
  /// d ln g / d ln(dp/ds), and around what its Couette share does, -U (d chi/d(dp/ds))/(g h^2);
  /// empty: none [-]. Of the derivatives alone (film_flux.cpp).
  Field thins_around, thins_along;
};

/// Pressure and fill ratio. `full` says which of them is the unknown of a cell.
struct FilmState {
  Field p;      ///< gauge [Pa]
  Field theta;  ///< liquid fraction [-]
  std::vector<char> full;
};

/// A face's mass flow and its derivatives. Per unit: whole face, not per width.
struct FaceFlow {
  double m = 0.0;        ///< mass flow in +phi or +z [kg/s]
  double couette = 0.0;  ///< what the journal would carry out of full film [kg/s]
  double carried = 0.0;  ///< and what it carries, a part of m [kg/s]
  double d_left = 0.0;   ///< d m / d p on the - side [kg/(s Pa)]
  double d_right = 0.0;  ///< d m / d p on the + side
  double d_theta = 0.0;  ///< d m / d theta of the upstream cell [kg/s]
  double d_h = 0.0;      ///< d m / d h of the face [kg/(s m)]
  double rise = 0.0;     ///< of the pressure, from the unknown on the - side to the face [Pa]
};

/// Flow out of the cell west of a supply line and into the line; `FilmFlow::phi` of that face
/// then holds the flow out of the line into the cell east of it.
struct LineFace {
  int face = 0;   ///< index of the west face
  int patch = 0;  ///< supply patch
  FaceFlow west;
};

/// What the journal carries out of cell k.
[[nodiscard]] inline CarriedFill carried_out_of(const FilmScene& scene, const FilmState& state,
                                                int k) {
  const Field& front = scene.storage.front;
  return carried_fill(state.theta[k], front.empty() ? 0.0 : front[k]);
}

struct FilmFlow {
  std::vector<FaceFlow> phi;  ///< west faces, index i * nz + j
  std::vector<FaceFlow> z;    ///< axial faces, index i * (nz + 1) + j
  std::vector<LineFace> lines;
  Field fed;              ///< into the cells of scene.supply.mouths, in their order [kg/s]
  Field stored;           ///< d(oil in the cell)/dt, zero in supply cells; empty: steady [kg/s]
  Field stored_by_theta;  ///< its derivatives: by theta of the cell [kg/s],
  Field stored_by_p;      ///< by its pressure [kg/(s Pa)],
  Field stored_by_gap;    ///< by its gap [kg/(s m)]
  std::vector<EdgeSlopes> edge;            ///< of the gap, as in Gap
  std::vector<BentFace> bent_phi, bent_z;  ///< the same
};

/// M of every cell [kg/m2]; zero in supply cells, whose oil is the supply's.
[[nodiscard]] Field oil_content(const FilmScene& scene, const Gap& gap, const FilmCoefficients& oil,
                                const FilmState& state);

/// How the oil in a cell changes with its gap, rho theta hT' dA [kg/m], and with its fill ratio,
/// rho hT dA [kg]. Zero in supply cells.
struct OilStore {
  Field by_gap;
  Field by_theta;
};
[[nodiscard]] OilStore oil_store(const FilmScene& scene, const Gap& gap,
                                 const FilmCoefficients& oil, const FilmState& state);

/// Evaluates all faces. `profile` as in film_gap.
void evaluate_flow(const FilmScene& scene, const Gap& gap, const Field& profile,
                   const FilmCoefficients& oil, const FilmState& state, FilmFlow& flow);

/// Net mass flow out of every cell, less what a drilling feeds into it [kg/s]: in the film at a
/// solution minus what is stored (zero in the steady film); at supply cells the flow fed in.
[[nodiscard]] Field net_outflow(const FilmScene& scene, const FilmFlow& flow);

}  // namespace shellback::fluid
