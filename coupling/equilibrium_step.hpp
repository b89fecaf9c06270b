#pragma once
/// One Newton step of film and journal; what the rigid and the elastic step have in common.
#include "coupling/film_equilibrium.hpp"

namespace shellback::coupling {

/// Storage of the film's linear system, one per thread and used again by every step: fresh pages
/// would cost a good part of a factorisation. Holds the system of the last step.
struct FilmSystem {
  RingMatrix matrix;
  RingFactor factor;
};
[[nodiscard]] FilmSystem& film_system();

/// Change of the unknowns. Elastic displacement only for elastic bearings.
struct NewtonStep {
  bool good = false;          ///< false: singular matrix
  Field film;                 ///< t of fluid/reynolds.hpp, per cell
  std::array<double, 4> q{};  ///< of the journal position [m], [rad]
  Field elastic;              ///< [m]
};

/// Wanted change of force for a force `now`: now ln(target/now) as complex numbers where the two
/// are of like direction, else target - now. Moments: plain difference.
[[nodiscard]] fluid::Wrench wanted_change(const fluid::Wrench& now, const LoadTarget& target);

/// Limits a position step: closing shrinks the gap `g` by a factor, never past zero; turning and
/// opening are bounded. `reach` in (0, 1] tightens all bounds.
[[nodiscard]] std::array<double, 4> limited(const fluid::JournalPosition& position,
                                            const std::array<double, 4>& dq, double g,
                                            double clearance, double half_width, double reach);

/// Solves a small dense system in place, n <= 4; false if singular.
[[nodiscard]] bool solve_small(int n, std::array<std::array<double, 4>, 4> a,
                               std::array<double, 4>& b);

/// How far a step may go.
struct StepLimits {
  double reach = 1.0;    ///< tightens the bounds of `limited` [-]
  double damping = 1.0;  ///< part of the wanted change of force that is asked for [-]
};

/// The rigid step: film matrix, one factorisation, 1 + unknowns right-hand sides.
[[nodiscard]] NewtonStep rigid_step(const BearingModel& model, const LoadTarget& target,
                                    const FilmEquilibrium& state, const Field& residual,
                                    StepLimits limits, EquilibriumCost& cost);

}  // namespace shellback::coupling
