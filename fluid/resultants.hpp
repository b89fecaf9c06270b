#pragma once
/// Force, moment, friction and flows of a film.
///
/// Pressure acts on the journal against the outward normal of the shell:
///   F = - int (p + p_a) (cos phi, sin phi) dA                                   [N]
///   M_x = int z (p + p_a) sin phi dA,  M_y = - int z (p + p_a) cos phi dA       [N m]
/// Tangential traction on the journal (braking positive motion: positive) and on the shell (along
/// the motion), with the harmonic viscosity eta = 1/g0 across the film:
///   tau_j = eta U phi_total/h + [chi hT + sigma phi_s/2] dp/dx                    [Pa]
///   tau_s = eta U phi_total/h - [(1 - chi) hT - sigma phi_s/2] dp/dx              [Pa]
/// For smooth surfaces U/F0 +- the pressure terms [textbook]. For rough ones it is the viscous
/// stress of seed 000 Eq. 4 and the pressure on the flanks of the asperities together
/// (fluid/flow_factors.hpp; seed 001, text after Eq. 1): the traction that brakes the shaft, and
/// with which moment and power balance. The Couette part is multiplied by the fill of the cell in
/// the cavitated film (striated), or not (`full`).
#include <array>

#include "fluid/film_flux.hpp"

namespace shellback::fluid {

/// F_x, F_y [N], M_x, M_y [N m] on the journal, whole bearing. Components that vanish by symmetry
/// on a half grid (the moments) are zero.
using Wrench = std::array<double, 4>;

/// Wrench of the pressure field `p` (film plus contact) [Pa].
[[nodiscard]] Wrench wrench(const FilmDomain& scene, const Field& p);
/// Weight of cell (i, j) in component k of the wrench: d wrench_k / d p_ij [m2] or [m3].
[[nodiscard]] double wrench_weight(const FilmDomain& scene, int k, int i, int j);

/// Difference p_east - p_west across the west face of each cell over the distance between the two
/// unknowns, halves at supply lines: circumferential pressure gradient at cells [Pa/m].
[[nodiscard]] Field pressure_gradient_x(const FilmScene& scene, const FilmState& state);
/// The same where the gap jumps on faces: the halves share the difference as they carry the flow,
/// m of each alike (`flow` of this state). By distance alone, the moment that the pressure exerts
/// on the jump is lost to first order.
[[nodiscard]] Field pressure_gradient_x(const FilmScene& scene, const FilmState& state,
                                        const FilmFlow& flow);
/// Pressure on the face between cell l and the cell r east of it [Pa]: a supply's if there is one,
/// else that of halves in series (film_flux.hpp).
[[nodiscard]] double face_pressure(const FilmScene& scene, const FilmState& state,
                                   const FilmFlow& flow, int l, int r);
[[nodiscard]] Field pressure_gradient_z(const FilmScene& scene, const FilmState& state);

struct ShearStress {
  Field journal;  ///< [Pa]
  Field shell;    ///< [Pa]
};

/// Mean fill ratio over each cell [-]: half the sum of what is carried through its two faces. In
/// the steady film theta itself is what is carried through the downstream face; taking it at the
/// cell's middle shifts the cavitated zone by half a cell and makes the torque of first order. A
/// supply line feeds full film; patches keep their own value.
[[nodiscard]] Field cell_fill(const FilmScene& scene, const FilmState& state);

enum class CavitatedShear { filled, full };

/// Traction of both surfaces at every cell. `h` is the nominal gap [m], depth of supply patches
/// included by the caller; `g0` the mean fluidity across the film [1/(Pa s)], `chi` the Couette
/// share [-], `gradient_x` dp/dx [Pa/m].
[[nodiscard]] ShearStress shear_stress(const FilmScene& scene, const Field& h, const Field& g0,
                                       const Field& chi, const FilmState& state,
                                       const Field& gradient_x, CavitatedShear rule);

/// Torque of a stress field about the bearing axis [N m], whole bearing.
[[nodiscard]] double torque(const FilmDomain& scene, const Field& tau);

/// Oil flows [kg/s], whole bearing, from the face flows of the solved system.
struct OilFlows {
  double supply = 0.0;        ///< out of all patches, net
  double side = 0.0;          ///< out of the side edges, net
  double side_inflow = 0.0;   ///< part of the edges' flow that comes in
  double stored = 0.0;        ///< change of the oil in the film: supply - side at a solution
  std::vector<double> patch;  ///< net out of each patch
  /// Part of that which its own cells take as the gap there opens (bearing/film/pockets.hpp);
  /// empty: none
  std::vector<double> pocket;
};
[[nodiscard]] OilFlows oil_flows(const FilmScene& scene, const FilmFlow& flow);

}  // namespace shellback::fluid
