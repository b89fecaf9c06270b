#pragma once
/// Why a solve ended without a solution: one of these, its numbers in SI units. Their words, with
/// place and cure, are made in app/words.
#include <array>
#include <variant>
#include <vector>

#include "core/not_a_number.hpp"

namespace shellback::ending {

/// Endings of which there is no more to know.
enum class Plain {
  none,               ///< the status says all
  not_run,            ///< a part of a study that was stopped
  not_reached,        ///< a point of a sweep that was stopped
  given_up,           ///< the search has cost as much as it may
  no_oil_leaves,      ///< nothing carries the heat away
  no_oil_over_event,  ///< of a load cycle, which walls might take up
  // Film.
  no_pressure,         ///< at this gap the reduced pressure would exceed its bound 1/alpha
  no_position,         ///< each step towards the load closes the gap, which proves nothing
  ran_off,             ///< a residual left the range of numbers where all fields are finite
  empty_ring,          ///< cavitated all round and fed by nothing
  singular_film,       ///< the film matrix could not be factorised
  out_of_the_law,      ///< in a step in time no pressure that the pressure-viscosity law knows
  overdrawn,           ///< a step in time takes more oil out of a cell than it holds
  singular_response,   ///< the matrix of the linearised film (stiffness and damping)
  unsettled_response,  ///< GMRES on the linearised elastic film
  no_vessel_pressure,  ///< of a supply with a vessel
  layer_may_flow,      ///< an elasto-plastic layer, by which steady states are often not found
  // Heat.
  no_light_state,       ///< no light load and no low speed has a common state of film and heat
  no_slow_state,        ///< no low speed has one, at a given place of the journal
  endless_branch,       ///< states without end, that bring the load no nearer
  strayed,              ///< the states next to the last one do not continue it
  estimate_unbalanced,  ///< no temperature at which the estimate's friction heat is carried away
  film_unsettled,       ///< temperatures of the film in a stage of a step
  film_impossible,      ///< one of them leaves what an oil can be
  // Time.
  steps_too_short,
};

/// Iterations, and what is left of each.
enum class Iteration {
  cavitation,          ///< active sets at given gap: cell residual over largest Couette flow [-]
  swift_stieber,       ///< the same
  fischer_burmeister,  ///< the same
  p_theta,             ///< the same; steps are sweeps
  heat,                ///< film and heat: change in units of 10 K [-]
  walls,               ///< of film and walls: change of the walls [K]
  cycles,              ///< difference of two cycles in smallest film and torque [-]
  layer_of_cycles,     ///< growth of the depth to which a layer flows, of the last cycle [m]
  walls_of_cycles,     ///< change of the walls from cycle to cycle [K]
  wear,                ///< the worn-in shape: change of its depth [m]; cause: it has no film
};

struct Unsettled {
  Iteration of = Iteration::cavitation;
  long steps = 0;
  double left = 0.0;      ///< in the unit of the iteration
  bool hopeless = false;  ///< swift_stieber: pressures left the range of the pressure law on the
                          ///< way; fischer_burmeister: no step length lessens the residual
  double gathered = 0.0;  ///< cycles: oil that the film gained in the last, over what it holds [-]
};

// Film, journal position and elastic surfaces.

struct NotANumber {
  FieldName field = FieldName::film_pressure;
  bool other_method = false;  ///< met by a method that is shown as it is known elsewhere
};

/// Rigid surfaces and the pressure law carry no more.
struct BeyondPressureBound {
  double wanted = 0.0;   ///< [N]
  double carried = 0.0;  ///< about all [N]
};

/// Smooth surfaces touch before a film is sought; `h` is what position and profile, heat and
/// elasticity leave together. Not-a-number: does not act.
struct GapClosed {
  double h = 0.0;              ///< smallest gap [m]
  double by_position = 0.0;    ///< by position and profile there [m]
  double by_heat = 0.0;        ///< thermal deformation there, negative: closes [m]
  double by_elasticity = 0.0;  ///< elastic widening there [m]
  double across = 0.0;         ///< least sum of the gaps at the two ends of a diameter [m]
  [[nodiscard]] bool by_growth() const { return by_position > 0.0 && by_heat < 0.0; }
};

/// Rough surfaces lie so deep in each other that no oil passes.
struct SurfacesInterlocked {
  double h = 0.0;      ///< nominal gap, negative [m]
  double sigma = 0.0;  ///< roughness of both [m]
};

/// Newton's method for film, position and elastic surfaces.
struct FilmUnsettled {
  int iterations = 0;
  double film = 0.0, load = 0.0, elastic = 0.0;  ///< residuals, bearing/film/equilibrium.hpp [-]
  double h_min = 0.0;                            ///< [m]
  bool no_film = false;  ///< smooth surfaces with less than a molecule of oil between
};

/// The journal still moves after so many steps in time; 0: it is pressed nearer and nearer to the
/// shell, by now than a molecule of oil is long.
struct NotAtRest {
  int steps = 0;
  double h_min = 0.0;     ///< [m]
  bool by_cells = false;  ///< pressed nearer than the cells can tell
};

// Branches of steady states over load, speed or supply pressures.

/// What is raised along a branch: load, speed or gauge pressures of the supplies of the operating
/// point, or a journal's given place.
enum class Raised { load, speed, supply, place };

/// How a branch ended; the highest value that was reached is what it carries.
enum class BranchEnd {
  reached,    ///< the whole load or speed: the state is the solution
  turned,     ///< beyond the end there are only states of less load: a turning point
  unbounded,  ///< rigid surfaces and Barus oil: closer the reduced pressure exceeds its bound
  molecule,   ///< smooth surfaces nearer than a molecule of oil
  lost,       ///< the corrector fails, and nothing shows why
  interrupted,
};

/// A part of what is raised.
struct Carried {
  Raised raised = Raised::load;
  double part = 0.0;   ///< [-]
  double whole = 0.0;  ///< load [N], speed [rad/s] or largest gauge pressure of a supply [Pa]
};

/// `end` is none of reached and interrupted; the cause, if any, is the last corrector's.
struct BranchEnded {
  BranchEnd end = BranchEnd::lost;
  Carried carried;
  double h_min = 0.0;      ///< there [m]
  bool with_heat = false;  ///< film and heat, not the film alone
  double T_high = NAN;     ///< with heat: hottest oil there [K]
  bool by_cells = false;   ///< no cells resolve what ends it
};

/// With a tenth more than the branch carries film and walls run away in time; cause: how.
struct RanAway {
  Carried carried;
  double h_min = 0.0;  ///< there [m]
  double t = 0.0;      ///< within which [s]
  bool thins = true;   ///< the oil's viscosity falls as it warms: without that nothing runs away
};

struct LimitOnGrid {
  std::array<int, 2> grid{0, 0};  ///< cells around and along
  Carried carried;
};

/// Where the branch ends on several grids does not agree; cause: how it ended on the last.
struct LimitMoves {
  std::vector<LimitOnGrid> limits;
};

// Film and heat.

/// What ends at one temperature.
enum class Thermal {
  oil_laws,          ///< it came up on the way, and the laws of the oil do not hold there
  too_cold,          ///< of a film colder than everything around it: the second law forbids it
  unstable_root,     ///< the heat balance is met there alone, unstable
  unsettled_root,    ///< the heat balance did not settle there
  unbalanced_cycle,  ///< up to it the oil of a mean cycle does not carry off its heat
};
struct AtTemperature {
  Thermal what = Thermal::oil_laws;
  double T = 0.0;  ///< [K]
};

/// The film is hotter than any survives, and its temperature rises.
struct FilmTooHot {
  double T = 0.0;         ///< [K]
  double T_supply = 0.0;  ///< [K]
};

/// Between two temperatures the heat made never equals the heat carried off; cause: why there is no
/// film at `T_none`.
struct NoHeatBalance {
  double T_low = 0.0, T_high = 0.0;              ///< coldest and hottest film [K]
  double surplus_low = 0.0, surplus_high = 0.0;  ///< there, heat made over heat carried off [W]
  double T_none = 0.0;                           ///< coldest without a film [K]; infinite: none
};

// Time.

/// The walls that were tried leave the film no room, or the bearing does before it makes any heat:
/// everything at `T`, one of the temperatures given, or that from which walls start.
struct NoClearance {
  enum class At { tried, coldest, warmest, start };
  double deformation = 0.0;  ///< mean thermal widening of the gap, negative [m]
  double clearance = 0.0;    ///< cold [m]
  At at = At::tried;
  double T = 0.0;  ///< [K]
};

/// An orbit that repeats itself, and from which a displaced journal departs.
struct UnstableOrbit {
  /// Of a journal heavier by a tenth on another grid.
  enum class Elsewhere { not_looked, no_orbit, not_judged, keeps_to_it, departs };
  double growth = 1.0;            ///< of the displacement in a cycle [-]
  std::array<int, 2> grid{0, 0};  ///< cells around and along
  Elsewhere elsewhere = Elsewhere::not_looked;
  std::array<int, 2> other{0, 0};  ///< the other grid; zero: not looked
};

/// A step of a cycle that was not found; cause: why.
struct NoStep {
  double t = 0.0;            ///< of the cycle [s]
  double crank_speed = 0.0;  ///< [rad/s]; 0: of no crank
  bool estimated = false;    ///< of the journal's path by its mobility
  bool massless = false;     ///< the journal, which may have to leap
  bool rigid = false;        ///< the surfaces
};

/// Stopped by the user, as the status says; or the worn bearing has no film; cause: why; or steps
/// err by `over` times what is allowed, however short they are.
struct RunningInEnded {
  double t = 0.0;     ///< of running-in [s]
  double over = 0.0;  ///< [-]; 0: it is not that
};

// Methods of others (model.methods; validation/rivals/).

/// The journal's position in turns with the film.
struct PositionUnsettled {
  double load = 0.0;   ///< residual [-]
  double h_min = 0.0;  ///< [m]
};

/// The fixed point between film and displacement; cause: why a round has no film.
struct FixedPointDiverged {
  int round = 0;
  double mismatch = 0.0;  ///< of the displacement in smallest gaps, if the round has a film [-]
  double opening = 0.0;   ///< largest elastic [m]
  double h_min = 0.0;     ///< [m]
};

struct FixedPointUnsettled {
  int rounds = 0;
  double mismatch = 0.0;    ///< of the displacement in smallest gaps [-]
  double relaxation = 0.0;  ///< [-]
};

}  // namespace shellback::ending

namespace shellback {

using Ending =
    std::variant<ending::Plain, ending::Unsettled, ending::NotANumber, ending::BeyondPressureBound,
                 ending::GapClosed, ending::SurfacesInterlocked, ending::FilmUnsettled,
                 ending::NotAtRest, ending::BranchEnded, ending::RanAway, ending::LimitMoves,
                 ending::AtTemperature, ending::FilmTooHot, ending::NoHeatBalance,
                 ending::NoClearance, ending::UnstableOrbit, ending::NoStep, ending::RunningInEnded,
                 ending::PositionUnsettled, ending::FixedPointDiverged,
                 ending::FixedPointUnsettled>;

}  // namespace shellback
