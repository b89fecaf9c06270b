#pragma once
/// One Newton step of film, journal and elastic surfaces: three residual blocks, one linear system.
///
///   J du + J_h (dd + B dq)                  = -R                                     (1)
///   dd - C dP                               =  r_d,  dP = du_F + p_a'(dd + B dq)     (2)
///   L dP - k dq                             =  a                                     (3)
/// J, J_h derivatives of the film residual (storage included) by its unknowns and by the gap,
/// B = dh/dq, L the quadrature of force and moment, r_d = C(p + p_a) - d, k = m/dt^2 of a journal
/// with mass over a finite step, a the wanted change of force. Along a path of loads the load's
/// logarithm is one more unknown and the length of the path one more row of (3).
///
/// With the Winkler foundation tau in place of C the system is solved exactly: cell by cell
///   dd = kappa (b + tau (du_F + p_a' B dq)),   kappa = 1/(1 - tau p_a'),             (4)
/// one factorised film matrix J + J_h kappa tau, and a small border for dq. Only (2) is then
/// wrong, by (C - tau) dP: GMRES acts on the right-hand side b of (2) alone,
///   b - (C - tau) dP(b) = r_d.                                                        (5)
/// Rigid surfaces: C = tau = 0, nothing is wrong, no GMRES.
/// Source: methods 2.1, 2.2; the reduction (5) is ours.
#include <functional>

#include "bearing/film/equilibrium.hpp"
#include "core/gmres.hpp"

namespace shellback::bearing {

/// Change of the unknowns. Elastic displacement only for elastic bearings.
struct NewtonStep {
  bool good = false;          ///< false: singular matrix
  Field film;                 ///< t of fluid/reynolds.hpp, per cell
  std::array<double, 4> q{};  ///< of the journal position [m], [rad]
  double ln_load = 0.0;       ///< of the logarithm of the load's factor [-]
  Field elastic;              ///< [m]
};

/// The factorised film on a Winkler foundation, with its answers to the journal's movement.
class BorderedFilm {
 public:
  /// For an evaluated state; `journal`: components of its position that may move.
  BorderedFilm(const BearingModel& model, const fluid::FilmScene& scene,
               const FilmEquilibrium& state, int journal, RingFactor& factor,
               EquilibriumCost& cost);
  [[nodiscard]] bool good() const { return good_; }
  /// Compliance of each cell of the foundation: mean elastic one and that of an elasto-plastic
  /// layer [m/Pa]; empty: rigid.
  [[nodiscard]] const Field& foundation() const { return tau_; }

  struct Answer {
    Field u;        ///< film unknowns
    Field d;        ///< displacement; empty: rigid [m]
    Field P;        ///< total pressure [Pa]
    Field contact;  ///< part of it in contact; empty: rigid [Pa]
  };
  /// For right-hand sides a of (1) and b of (2) (empty: zero), the journal held.
  [[nodiscard]] Answer held(const Field& a, const Field& b) const;
  /// Adds the answer to the journal's movement dq.
  void move(const std::array<double, 4>& dq, Answer& x) const;
  /// d wrench / dq, film and surfaces following; film counts in cells that are `full`.
  [[nodiscard]] std::array<std::array<double, 4>, 4> stiffness(const std::vector<char>& full) const;

 private:
  [[nodiscard]] bool free(int k) const { return s_.film.full[k] && scene_.supply.cell[k] < 0; }

  const fluid::FilmScene& scene_;
  const FilmEquilibrium& s_;
  int m_;
  Field tau_;    ///< [m/Pa]; empty: rigid
  Field kappa_;  ///< empty: rigid
  RingFactor& factor_;
  std::vector<Answer> response_;  ///< to the movement of one component, per unit
  bool good_ = false;
};

/// Answer of the film on a Winkler foundation to a right-hand side of (2), those of (1) and (3) as
/// they are, or none of them.
using FilmSolve = std::function<BorderedFilm::Answer(const Field& defect, bool homogeneous)>;

/// The answer for the whole compliance by (5).
struct CompliantAnswer {
  BorderedFilm::Answer x;
  double reduction = 0.0;  ///< of what the foundation leaves wrong [-]
};
[[nodiscard]] CompliantAnswer with_compliance(const BearingModel& model, const FilmEquilibrium& s,
                                              const Field& defect, const FilmSolve& solve,
                                              double tolerance, KrylovMemory* memory = nullptr);

/// How far a step may go.
struct StepLimits {
  double reach = 1.0;    ///< tightens the bounds on the journal's movement [-]
  double damping = 1.0;  ///< part of the wanted change of force that is asked for [-]
};

/// The step from an evaluated state with its residuals. `memory`: of elastic steps before, from
/// states near to this one.
[[nodiscard]] NewtonStep newton_step(const BearingModel& model, const fluid::FilmScene& scene,
                                     const LoadTarget& load, const FilmEquilibrium& state,
                                     const Residuals& residuals, StepLimits limits,
                                     EquilibriumCost& cost, KrylovMemory* memory = nullptr);

/// Wanted change of force for a force `now`: now ln(target/now) as complex numbers where the two
/// are of like direction, else target - now. Moments: plain difference.
[[nodiscard]] fluid::Wrench wanted_change(const fluid::Wrench& now, const fluid::Wrench& target);

/// Limits a position step: closing shrinks the gap `g` by a factor, never past zero; turning and
/// opening are bounded. `reach` in (0, 1] tightens all bounds.
[[nodiscard]] std::array<double, 4> limited(const fluid::JournalPosition& position,
                                            const std::array<double, 4>& dq, double g,
                                            double clearance, double half_width, double reach);

}  // namespace shellback::bearing
