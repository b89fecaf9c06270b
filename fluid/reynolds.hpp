#pragma once
/// Pressure and fill ratio of a film of given gap: JFO cavitation by semismooth Newton.
///
///   sum over faces m + stored = 0 in every cell, stored zero without end of step (1)
///   p >= p_cav,  0 <= theta <= 1,  (p - p_cav)(1 - theta) = 0                   (2)
///
/// One unknown per cell: p where the film is full, theta where it is cavitated. Each step solves
/// the linearised (1) for these unknowns, then moves cells across: p < p_cav becomes cavitated,
/// theta > 1 becomes full. Pressures advance along the local Barus curve,
/// p <- p - ln(1 - alpha dp)/alpha, that is, linearly in q = (1 - exp(-alpha p))/alpha: for Barus
/// oil of one temperature the step is exact, and a step with alpha dp >= 1 shows that the film
/// has no steady pressure at this gap. If an active set comes back, the step is replaced by one
/// on the Fischer-Burmeister form of (2) with line search.
/// Sources: methods 1.2; Newton on complementarity: textbook.
#include <functional>

#include "core/outcome.hpp"
#include "core/ring_matrix.hpp"
#include "fluid/film_flux.hpp"

namespace shellback::fluid {

/// Sets the oil's coefficients for the state that the film has now.
using OilLaw = std::function<void(const FilmState&, FilmCoefficients&)>;

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
/// a Winkler foundation [m per unit of t]. The same averages as to_faces: exact.
void add_gap_compliance(const FilmScene& scene, const FilmFlow& flow, const Field& compliance,
                        RingMatrix& matrix);

/// Change of the net outflow of every cell [kg/s] by a change of the gap at the faces [m]; zero at
/// supply cells. Face arrays as in Gap.
[[nodiscard]] Field outflow_by_gap(const FilmScene& scene, const FilmFlow& flow,
                                   const std::vector<double>& phi_face,
                                   const std::vector<double>& z_face);
/// Change of the residual of (1), storage included, by a smooth change of the gap at the cells [m],
/// averaged to the faces as by to_faces [kg/s].
[[nodiscard]] Field residual_by_gap(const FilmScene& scene, const FilmFlow& flow, const Field& gap);
/// The same per unit of a component of the journal position, exact at the faces [kg/(s m)],
/// [kg/(s rad)].
[[nodiscard]] Field residual_by_position(const FilmScene& scene, const FilmFlow& flow,
                                         int component);

/// Residual of (1) with zeros at supply cells [kg/s], and the flow it is measured against: the
/// largest mass flow through a face, Couette or all, or stored in a cell [kg/s].
[[nodiscard]] Field film_residual(const FilmScene& scene, const FilmFlow& flow);
[[nodiscard]] double flow_scale(const FilmScene& scene, const FilmFlow& flow);

/// Effect of an update on the state.
struct UpdateReport {
  int moved = 0;         ///< cells that changed between full and cavitated
  int beyond_barus = 0;  ///< cells whose step left the range of the pressure law, alpha dp >= 1
  int worst_cell = -1;   ///< one of them
};

constexpr double kMostBarus = 0.99;  ///< of advance: largest alpha dp of a step [-]

/// Applies the step t (scaled by `fraction`) and moves cells across. alpha dp is held to at most
/// `most_barus`, below 1; a cell that asks for more is counted.
UpdateReport advance(const FilmScene& scene, const FilmCoefficients& oil, const Field& step,
                     double fraction, FilmState& state, double most_barus = kMostBarus);

/// Full film at ambient pressure, supply cells at theirs: the cold start.
[[nodiscard]] FilmState cold_film(const FilmScene& scene);
/// Puts the supply pressures into a state (after interpolation from another grid, say).
void impose_supply(const FilmScene& scene, FilmState& state);

struct ReynoldsOptions {
  double tolerance = 1e-12;  ///< largest residual over flow_scale [-]
  int max_iterations = 60;  ///< plus one per line of cells in a moving film without rotation, whose
                            ///< edge may settle line by line
};

struct FilmSolution {
  FilmState state;
  FilmFlow flow;
  FilmCoefficients oil;
  RingFactor factor;  ///< of the last matrix: reusable for sensitivities
  int factorizations = 0;
  int fallback_steps = 0;  ///< Fischer-Burmeister steps taken
};

/// Solves (1)-(2) from `guess`. Does not throw for lack of convergence: read the verdict.
[[nodiscard]] Outcome<FilmSolution> solve_reynolds(const FilmScene& scene, const Gap& gap,
                                                   const Field& step, const OilLaw& oil,
                                                   const FilmState& guess,
                                                   const ReynoldsOptions& options = {});

/// "phi 212.4 deg, z 0.31 mm" for a cell.
[[nodiscard]] std::string place_of(const FilmGrid& grid, int cell);

}  // namespace shellback::fluid
