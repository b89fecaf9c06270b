#pragma once
/// The film equation, (1) of reynolds.hpp, linearised: residual, matrix, response to the gap.
///
/// One unknown t per cell moves p, theta or both; the maps of the methods differ.
#include "core/ring_matrix.hpp"
#include "fluid/film_flux.hpp"

namespace shellback::fluid {

/// How the single unknown t of a cell moves p and theta: dp = a_p t, dtheta = a_theta t + b_theta.
struct UnknownMap {
  Field a_p;
  Field a_theta;
};

/// The unknowns of the active-set step: p in full cells, theta in cavitated ones.
[[nodiscard]] UnknownMap active_set_unknowns(const FilmState& state);

/// Matrix of the linearised (1) in the unknowns t; identity rows at supply cells.
void assemble_film(const FilmScene& scene, const FilmFlow& flow, const UnknownMap& unknowns,
                   RingMatrix& matrix);

/// Adds the film's response to a gap that follows the cell's own unknown, dh = compliance t:
/// a Winkler foundation [m per unit of t]. The same averages as in film_gap: exact.
void add_gap_compliance(const FilmScene& scene, const FilmFlow& flow, const Field& compliance,
                        RingMatrix& matrix);

/// Change of the net outflow of every cell [kg/s] by a change of the gap at the faces [m]; zero at
/// supply cells. Face arrays as in Gap.
[[nodiscard]] Field outflow_by_gap(const FilmScene& scene, const FilmFlow& flow,
                                   const std::vector<double>& phi_face,
                                   const std::vector<double>& z_face);
/// Change of the residual of (1), storage included, by a smooth change of the gap at the cells [m],
/// averaged to the faces as by to_faces, to the side edges by edge_gap [kg/s].
[[nodiscard]] Field residual_by_gap(const FilmScene& scene, const FilmFlow& flow, const Field& gap);
/// The same per unit of a component of the journal position, exact at the faces [kg/(s m)],
/// [kg/(s rad)].
[[nodiscard]] Field residual_by_position(const FilmScene& scene, const FilmFlow& flow,
                                         int component);

/// Residual of (1) with zeros at supply cells [kg/s], and the flow it is measured against: the
/// largest mass flow through a face around, Couette or all, or stored in a cell [kg/s].
[[nodiscard]] Field film_residual(const FilmScene& scene, const FilmFlow& flow);
[[nodiscard]] double flow_scale(const FilmFlow& flow);

/// Largest flow through a face by the pressure of one of its cells alone, what its derivative makes
/// of it [kg/s]: two of them cancel but for the difference of their pressures, so that a residual
/// is known to some round-offs of it.
[[nodiscard]] double flow_by_pressure(const FilmScene& scene, const FilmFlow& flow, const Field& p);

}  // namespace shellback::fluid
