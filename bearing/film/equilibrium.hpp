#pragma once
/// State and residual of film, journal and elastic surfaces, at given oil temperatures and thermal
/// deformation.
///
/// Unknowns: p or theta of every cell (u), journal position q (0, 2 or 4 components), elastic
/// widening of the gap d (elastic bearings). At the end of a step dt in time:
///   R(u, q, d) = (M - M_before)/dt + outflow = 0     film, fluid/film_flux.hpp       (1)
///   F(p + p_a) + W - m (q - q_free)/dt^2 = 0         load, moment, journal's mass    (2)
///   d = C (p + p_a(h)) + r(p + p_a)                  elasticity, r: pressed_layer.hpp  (3)
/// q_free is where the journal would be without any force, q_before + dt v_before; q - q_free is
/// carried beside q (State::flight). A step without end is the steady bearing.
///
/// Asperity heat makes the shell bulge towards the journal where they rub, and rub more. Taken in
/// turns with the film this diverges in heavy contact; where `contact_widening` G is given, (3)
/// reads
///   d = C (p + p_a) + G (r p_a)                                                               (3a)
/// and the thermal deformation given from outside is without G (r p_a); r is the heat that enters
/// the shell per contact pressure, held while G is.
/// Source: seed 000 Eq. 1; backward Euler, textbook.
#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <optional>

#include "bearing/bearing.hpp"
#include "bearing/columns.hpp"
#include "bearing/operating_point.hpp"
#include "bearing/state.hpp"
#include "core/gmres.hpp"
#include "core/harmonics.hpp"
#include "fluid/resultants.hpp"
#include "fluid/reynolds.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {

/// All that follows from a state on a bearing.
struct Evaluation {
  fluid::Gap gap;
  Field shear_gap;  ///< [m]
  fluid::FilmCoefficients oil;
  fluid::FilmFlow flow;
  Field gradient_x, gradient_z;             ///< of p at cells [Pa/m]
  Field p_contact;                          ///< asperity pressure [Pa]
  Field dp_contact;                         ///< its derivative by h, not positive [Pa/m]
  std::vector<solid::PressedColumn> layer;  ///< r of (3); empty: no elasto-plastic layer
  fluid::Wrench force{};                    ///< of film and contact on the journal
  fluid::SmallestGap least;
};

/// Thermal deformation by asperity heat as (3a) has it.
struct ContactWidening {
  HarmonicOperator by_heat;  ///< G [m3/W]
  Field rate;                ///< r, heat into the shell per contact pressure [m/s]
};
/// G (r p_a) of a field of contact pressures, or of their changes [m].
[[nodiscard]] Field widening(const Solids& solids, const ContactWidening& by,
                             const Field& p_contact);

/// A state and what its last evaluation found.
struct FilmEquilibrium : State, Evaluation {
  OilColumns columns;  ///< temperatures as given by heat, viscosities as last found
  std::shared_ptr<const ContactWidening> contact_widening;  ///< of (3a); none: (3)
};

struct EquilibriumOptions {
  double film_tolerance = 1e-11;    ///< largest cell residual over flow_scale, the largest flow [-]
  double load_tolerance = 1e-9;     ///< |F + W| over |W| [-]
  double elastic_tolerance = 1e-8;  ///< largest |C p - d| over max(h, 0) + sigma, 2 nm more [-]
  double viscosity_tolerance = 1e-10;  ///< shear-thinning relation [-]
  int max_iterations = 80;
  int least_iterations = 0;  ///< also of a film that is within all of them
};

/// What a method of the equilibrium solves: film, journal and elastic surfaces of a bearing at an
/// operating point, between surfaces that heat has deformed [m]. Solves (1)-(3) of the step in time
/// that the point's scene holds.
struct FilmTask {
  const BearingModel& model;
  const OperatingPoint& point;
  const Field& thermal_deformation;
  EquilibriumOptions options{};
  const std::atomic<bool>* stop = nullptr;  ///< true: give up
  KrylovMemory* memory = nullptr;           ///< of elastic films near to this one
};

/// A film on the way to another one: its residuals in the units of EquilibriumOptions [-] (decision
/// 023), and the iterations after which a shorter way is taken.
inline constexpr double kWayPoint = 1e-3;
inline constexpr int kMostOfWayPoint = 25;

struct EquilibriumCost {
  int factorizations = 0;
  int newton_iterations = 0;
  int rejected_steps = 0;
  long sweeps = 0;         ///< of the p-theta relaxation
  int elastic_rounds = 0;  ///< of the fixed point between film and displacement
  double work = 0.0;       ///< iterations, each counted with its cells [cells]
  double most_work = std::numeric_limits<double>::infinity();  ///< from which a search is given up
  [[nodiscard]] bool spent() const { return work > most_work; }
};

/// Position given in the case, or a first guess for a load.
[[nodiscard]] fluid::JournalPosition first_position(const Case& c, double clearance);

/// A cold start: full film, one temperature, guessed position.
[[nodiscard]] FilmEquilibrium cold_start(const BearingModel& model, const OperatingPoint& point,
                                         double T);

/// Evaluates everything below the unknowns. False if the gap of a smooth bearing is closed.
[[nodiscard]] bool evaluate(const BearingModel& model, const OperatingPoint& point,
                            const Field& thermal_deformation, double tolerance,
                            FilmEquilibrium& state);

/// Residuals of an evaluated state, each in units of its tolerance's scale.
struct Residuals {
  Field film;          ///< R [kg/s]
  Field displacement;  ///< of (3), right side less left [m]; empty: rigid
  double film_norm = 0.0;
  double load_norm = 0.0;
  double elastic_norm = 0.0;
  [[nodiscard]] bool finite() const;
  [[nodiscard]] bool within(const EquilibriumOptions& o) const {
    return film_norm <= o.film_tolerance && load_norm <= o.load_tolerance &&
           elastic_norm <= o.elastic_tolerance;
  }
};
[[nodiscard]] Residuals residuals_of(const BearingModel& model, const OperatingPoint& point,
                                     const FilmEquilibrium& state);

/// (h + sqrt(h^2 + 4 sigma^2))/2 [m]: the gap of smooth surfaces; that of rough ones, which stay
/// apart by their asperities, is positive whatever the nominal h, sigma where h is none.
[[nodiscard]] double yielding_gap(double h, double sigma);

/// Distance by which the surfaces may still approach [m]: the smallest yielding gap; rough surfaces
/// stay apart by their asperities, so that the nominal gap may go through zero.
[[nodiscard]] double room(const BearingModel& model, const FilmEquilibrium& state);

/// The smallest gap from where summits begin to touch [m]: what surfaces that rub may give way by.
[[nodiscard]] double gap_with_summits(const BearingModel& model, const FilmEquilibrium& state);

/// True if the gap last evaluated is one of smooth surfaces and closed somewhere. A gap that is not
/// a number is not closed.
[[nodiscard]] inline bool is_closed(const BearingModel& model, const FilmEquilibrium& s) {
  return model.domain.rough.sigma <= 0.0 && s.least.h <= 0.0;
}

/// True if rough surfaces lie so deep in each other (some 21 roughnesses) that a double cannot hold
/// the square of the stress with which a moving wall shears their average gap. Where that stress
/// sets the viscosity there is no film. Iterates go there, bearings do not.
inline constexpr double kNoGap = 1e-100;  ///< [m]
[[nodiscard]] inline bool no_gap_shears(const BearingModel& model, double speed,
                                        const FilmEquilibrium& s) {
  return speed != 0.0 && rheology::thins(model.oil) &&
         std::any_of(s.shear_gap.begin(), s.shear_gap.end(), [](double h) { return h <= kNoGap; });
}

/// True if smooth surfaces are nearer than an oil molecule of 30 carbon atoms is long (2 to 4 nm,
/// textbook): no film is left that Reynolds' equation could describe. Surfaces that give way must
/// be so all along their width: a sharp edge is pressed harder the finer the cells are (decision
/// 040), and what they do there says nothing of the film beside it.
inline constexpr double kMolecule = 2e-9;  ///< [m]
[[nodiscard]] bool thinner_than_a_molecule(const BearingModel& model, const FilmEquilibrium& s);

/// True if the cells see how such a film closes. Surfaces that give way lie along each other. Of
/// rigid ones those of a tilted journal meet at a side edge, where oil leaves: along the edge's
/// wedge cells follow, if the gap opens by more along the bearing than to the next cell around, and
/// thinner films carry no more. Elsewhere between rigid surfaces 2 nm are closed over a hundredth
/// of any cell, thinner films carry ever more, and what the grid lets them carry is its own
/// (decision 078).
[[nodiscard]] bool closing_is_resolved(const BearingModel& model, const FilmEquilibrium& s);

/// A cell of a rigid film in which Barus oil has no pressure, -1: none. The values of cells are
/// means: inside, the reduced pressure q = (1 - exp(-alpha p))/alpha stands higher by a 24th of its
/// second differences (parabola), and nowhere can it exceed 1/alpha. Without this a single cell
/// would carry any load, its p = -ln(1 - alpha q)/alpha being unbounded.
[[nodiscard]] int beyond_reduced_pressure(const BearingModel& model, const OperatingPoint& point,
                                          const FilmEquilibrium& s);

/// Element by element; an empty field is zero.
[[nodiscard]] Field sum(const Field& a, const Field& b);

}  // namespace shellback::bearing
