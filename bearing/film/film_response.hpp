#pragma once
/// The solved film, linearised: how pressure, fill ratio and elastic shell answer a change of the
/// gap or of the oil in the cells.
///
///   J u + J_h (g + d) = -s             film                                          (1)
///   d = C P,  P = u_F + p_a' (g + d)   elasticity, contact                           (2)
/// u the film unknown of every cell (p in full ones, u_F; theta in cavitated ones), d the elastic
/// widening, g a given change of the gap, s a given storage of oil [kg/s], P the total pressure. J,
/// J_h are those of the Newton matrix, in which viscosity follows pressure by the local slope
/// alpha. What that matrix leaves out, for shear-thinning oil the dependence on shear rate, comes
/// in by defect correction: the film residual of the state moved along the answer, by difference.
/// Oil that does not thin needs none (tests: 1e-5). Which cells are full is held, too: pressure and
/// its gradient vanish together where the film ruptures, so that its edge moves the force in second
/// order only. With the Winkler foundation tau in place of C the system is one factorised matrix;
/// GMRES acts on the difference (C - tau) P alone, as in bearing/film/bordered_film.hpp. Source:
/// methods 2.1, 2.2 (the same reduction as the Newton step); otherwise textbook.
#include "bearing/film/bordered_film.hpp"

namespace shellback::bearing {

/// Answer of the film to one change.
struct FilmResponse {
  Field theta;    ///< change of the fill ratio [-]
  Field elastic;  ///< of the elastic widening; empty: rigid [m]
  Field total;    ///< of film and contact pressure [Pa]
};

class LinearFilm {
 public:
  /// Linearises an evaluated state; `thermal_deformation` as it was evaluated with. `tolerance`: of
  /// the pressures of an answer, of their largest [-].
  LinearFilm(const BearingModel& model, const OperatingPoint& point, const FilmEquilibrium& state,
             const Field& thermal_deformation, double tolerance);
  [[nodiscard]] bool good() const { return good_; }  ///< false: singular matrix

  /// Answer to a change of journal position component `k`, per unit [1/m], [1/rad].
  [[nodiscard]] FilmResponse to_position(int k);
  /// Answer to storage s in the cells, the journal held [per kg/s].
  [[nodiscard]] FilmResponse to_storage(const Field& s);
  /// Total pressure of to_storage to a few per cent: without the defect correction [Pa per kg/s].
  [[nodiscard]] Field pressure_by_storage(const Field& s);

  [[nodiscard]] bool converged() const { return converged_; }  ///< all solves so far

 private:
  using Answer = BorderedFilm::Answer;
  /// (1) and (2) with the Newton matrix.
  [[nodiscard]] Answer solve(const Field& a, const Field& r, double tolerance);
  /// The same with all derivatives; `component` of the position that moves by one, -1: none.
  [[nodiscard]] FilmResponse sharpened(const Field& a, const Field& r, const Field& stored,
                                       int component);
  /// Change of the film residual along an answer, per unit.
  [[nodiscard]] Field residual_along(const Answer& x, int component) const;

  const BearingModel& model_;
  const OperatingPoint& point_;
  const FilmEquilibrium& s_;
  const Field& thermal_deformation_;
  Field residual_;  ///< of the state, if the oil thins; else empty [kg/s]
  double tolerance_;
  EquilibriumCost cost_;  ///< of the factorisation
  RingFactor factor_;
  BorderedFilm film_;  ///< the journal held
  bool good_ = false;
  bool converged_ = true;
};

}  // namespace shellback::bearing
