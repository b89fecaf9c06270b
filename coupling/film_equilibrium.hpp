#pragma once
/// Film, journal position and elastic displacement in one Newton iteration, at given oil
/// temperatures and thermal growth.
///
/// Unknowns: p or theta of every cell (u), journal position q (0, 2 or 4 components), elastic
/// widening of the gap d (elastic bearings). Equations:
///   R(u, q, d) = 0                                   film, fluid/reynolds.hpp        (1)
///   F(p + p_a) = -W                                  load and, if asked, moment      (2)
///   d = C (p + p_a(h))                               elasticity                      (3)
/// Rigid bearings: (1) and (2) are solved together by the factorised film matrix with the columns
/// dR/dq as further right-hand sides. The load is met in logarithms: the wanted change of the
/// force is F* ln(F_target/F*), forces as complex numbers, F* the force that the film step alone
/// leads to; and a closing step dq shrinks the smallest gap g to g exp(-dq/g), never to zero: the
/// log-polar Newton of methods 0. Elastic bearings: coupling/elastic_step.hpp.
///
/// Asperity heat makes the shell bulge towards the journal where they rub, and rub more. Taken in
/// turns with the film this diverges in heavy contact; where `contact_growth` G is given, (3) reads
///   d = C (p + p_a) + G p_a                                                                   (3a)
/// and the growth given from outside is without G p_a.
#include <atomic>
#include <limits>
#include <memory>

#include "core/harmonics.hpp"
#include "coupling/bearing.hpp"
#include "coupling/columns.hpp"
#include "fluid/resultants.hpp"
#include "fluid/reynolds.hpp"

namespace shellback::coupling {

struct FilmEquilibrium {
  fluid::FilmState film;
  fluid::JournalPosition position;
  Field elastic;  ///< widening (3), shell and shaft [m]; empty: rigid
  std::shared_ptr<const HarmonicOperator> contact_growth;  ///< G of (3a) [m/Pa]; none: (3)
  OilColumns columns;

  // What the last evaluation found.
  fluid::Gap gap;
  Field shear_gap;  ///< [m]
  fluid::FilmCoefficients oil;
  fluid::FilmFlow flow;
  Field gradient_x, gradient_z;  ///< of p at cells [Pa/m]
  Field p_contact;               ///< asperity pressure [Pa]
  Field dp_contact;              ///< its derivative by h, not positive [Pa/m]
  fluid::Wrench force{};         ///< of film and contact on the journal
  fluid::SmallestGap least;
};

struct EquilibriumOptions {
  double film_tolerance = 1e-11;       ///< largest cell residual over the largest Couette flow [-]
  double load_tolerance = 1e-9;        ///< |F + W| over |W| [-]
  double elastic_tolerance = 1e-8;     ///< largest |C p - d| over the smallest gap [-]
  double viscosity_tolerance = 1e-10;  ///< shear-thinning relation [-]
  int max_iterations = 80;
  bool follow_load = true;  ///< from lighter loads on, where Newton's method fails at once
};

struct EquilibriumCost {
  int factorizations = 0;
  int newton_iterations = 0;
  int krylov_iterations = 0;
  int fallback_steps = 0;
  int rejected_steps = 0;
  long sweeps = 0;         ///< of the p-theta relaxation
  int elastic_rounds = 0;  ///< of the fixed point between film and displacement
  double work = 0.0;       ///< iterations, each counted with its cells [cells]
  double most_work = std::numeric_limits<double>::infinity();  ///< from which a search is given up
  [[nodiscard]] bool spent() const { return work > most_work; }
};

/// What the journal must balance.
struct LoadTarget {
  int unknowns = 2;       ///< 0: position given; 2: e; 4: e and tilt
  fluid::Wrench force{};  ///< wanted film force and moment on the journal: minus the load
  [[nodiscard]] double scale() const;  ///< |force| [N]
};
[[nodiscard]] LoadTarget load_target(const Case& c);

/// Position given in the case, or a first guess for a load.
[[nodiscard]] fluid::JournalPosition first_position(const Case& c, double clearance);

/// A cold start: full film, one temperature, guessed position.
[[nodiscard]] FilmEquilibrium cold_start(const BearingModel& model, double T);

/// Evaluates everything below the unknowns. False if the gap of a smooth bearing is closed.
[[nodiscard]] bool evaluate(const BearingModel& model, const Field& growth, double tolerance,
                            FilmEquilibrium& state);

/// True if smooth surfaces are nearer than an oil molecule of 30 carbon atoms is long (2 to 4 nm,
/// textbook): no film is left that Reynolds' equation could describe.
[[nodiscard]] inline bool thinner_than_a_molecule(const BearingModel& model,
                                                  const FilmEquilibrium& s) {
  constexpr double kMolecule = 2e-9;  // [m]
  return model.scene.rough.sigma <= 0.0 && s.least.h < kMolecule;
}

/// Newton on (1)-(3) from `state`; the first way of solve_equilibrium.
[[nodiscard]] Verdict newton_equilibrium(const BearingModel& model, const LoadTarget& target,
                                         const Field& growth, const EquilibriumOptions& options,
                                         FilmEquilibrium& state, EquilibriumCost& cost,
                                         const std::atomic<bool>* stop = nullptr);

/// Solves (1)-(3) from `state`, which is left at the last iterate whatever the verdict.
[[nodiscard]] Verdict solve_equilibrium(const BearingModel& model, const LoadTarget& target,
                                        const Field& growth, const EquilibriumOptions& options,
                                        FilmEquilibrium& state, EquilibriumCost& cost,
                                        const std::atomic<bool>* stop = nullptr);

}  // namespace shellback::coupling
