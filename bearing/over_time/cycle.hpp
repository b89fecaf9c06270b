#pragma once
/// One bearing over a load cycle: what comes out.
///
/// Times count from the beginning of the cycle that is told, the last one. Signs and units as in
/// bearing/quantities.hpp.
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "bearing/control.hpp"
#include "bearing/over_time/heat_in_time.hpp"
#include "bearing/result.hpp"

namespace shellback::bearing {

/// The bearing at one instant of the cycle, at the end of a step.
struct CycleInstant {
  double t = 0.0;                     ///< [s]
  double dt = 0.0;                    ///< the step that led there [s]
  double load_x = 0.0;                ///< on the journal [N]
  double load_y = 0.0;                ///< [N]
  double omega = 0.0;                 ///< journal against shell [rad/s]
  double ex = 0.0, ey = 0.0;          ///< position of the journal [m]
  double vx = 0.0, vy = 0.0;          ///< its velocity [m/s]
  double tilt_x = 0.0, tilt_y = 0.0;  ///< [rad]
  double h_min = 0.0;                 ///< smallest film [m]
  double h_min_angle = 0.0;           ///< where [rad]
  double p_max = 0.0;                 ///< [Pa]
  double p_asperity_max = 0.0;        ///< [Pa]
  double torque = 0.0;                ///< of friction on the journal [N m]
  double torque_asperity = 0.0;       ///< part of it from asperities [N m]
  // Parts of that; not a number without a friction law [N m].
  double torque_abrasive = std::numeric_limits<double>::quiet_NaN();
  double torque_adhesive = std::numeric_limits<double>::quiet_NaN();
  double torque_micro_hydrodynamic = std::numeric_limits<double>::quiet_NaN();
  /// Torque at which the journal would begin to turn: the boundary coefficient times the contact's
  /// sum, of a journal at rest; 0 while it turns [N m].
  double breakaway = 0.0;
  /// Torque times speed, and the work of load and moment on the moving journal; a moment's is the
  /// mean over the step [W]
  double power = 0.0;
  double supply_flow = 0.0;                                       ///< mean over the step [m3/s]
  double side_flow = 0.0;                                         ///< mean over the step [m3/s]
  double oil = 0.0;                                               ///< in the gap [kg]
  double p_vessel = std::numeric_limits<double>::quiet_NaN();     ///< smallest of all vessels [Pa]
  double T_film_max = std::numeric_limits<double>::quiet_NaN();   ///< tiers thd, tehd [K]
  double T_shell_max = std::numeric_limits<double>::quiet_NaN();  ///< at the surface [K]
  double heat_to_shell = std::numeric_limits<double>::quiet_NaN();  ///< mean over the step [W]
  double heat_to_shaft = std::numeric_limits<double>::quiet_NaN();  ///< the same [W]
};

/// A scalar of the whole cycle: a mean, or an extreme with its instant.
struct CycleQuantity {
  Quantity quantity;
  double at = std::numeric_limits<double>::quiet_NaN();  ///< of an extreme [s]; NaN: a mean
};

/// Relative defects over the cycle that is told.
struct CycleAudit {
  double mass = 0.0;  ///< oil in - out - gathered, over the oil in the gap [-]
  /// Largest difference, at the end of a step, between the oil that the film holds by its gap, fill
  /// and density and the oil that flows have carried into its cells, summed over these as
  /// magnitudes, over the oil in the gap [-]. What is left open in the film's equation lies in it;
  /// unlike `mass` it does not follow from how the oil is carried.
  double content = 0.0;
  /// Impulse of the film plus that of the course of load less the change of the journal's momentum,
  /// over the largest load times the period; NaN: the cycle was not ended [-]
  double impulse = 0.0;
  double load = 0.0;  ///< largest residual of the force balance over the largest load [-]
  /// Largest imbalance of the film's moments at an instant (steady/audit.hpp) over the largest
  /// torque; not exact on a grid [-]
  double moment = 0.0;
  /// Film heat made - into the walls - carried off - stored, over the heat made [-]; NaN: no film
  /// temperatures.
  double energy = std::numeric_limits<double>::quiet_NaN();
  /// Work of shaft, load, moment and supply less the heat that film and asperities make and less
  /// what elastic surfaces hold more at the end, over that work: what the steps in time lose of the
  /// elastic work, of second order in them; of an event, too, what asperities and an elasto-plastic
  /// layer hold more [-]. NaN as before.
  double work = std::numeric_limits<double>::quiet_NaN();
  /// Largest change of a wall's mean temperature, or of its thermal deformation (10 K a clearance),
  /// in the last turn of the search for the walls [K]. NaN as before.
  double walls = std::numeric_limits<double>::quiet_NaN();
  /// The same on the mean over shell or shaft, whichever is more, of its magnitude [K].
  double walls_mean = std::numeric_limits<double>::quiet_NaN();
  /// Heat that shell and shaft would take between the walls to which that turn leads, less what
  /// they took [W]. NaN as before.
  double to_shell = std::numeric_limits<double>::quiet_NaN();
  double to_shaft = std::numeric_limits<double>::quiet_NaN();
};

/// Full-width fields over the cycle.
struct CycleFields {
  FilmGrid grid;
  Field p_max;           ///< largest film pressure of each place [Pa]
  Field p_asperity_max;  ///< largest contact pressure; empty: no contact [Pa]
  Field h_min;           ///< smallest gap, of supplies with their depth [m]
  Field in_supply;       ///< 1 in the supplies that the case gives, elsewhere 0 [-]
  Field friction_power;  ///< mean over the cycle, per area [W/m2]
  Field layer_depth;     ///< lasting, of an elasto-plastic layer at the end; empty: none [m]
  // Tiers with film temperatures; otherwise empty.
  Field T_shell;              ///< surface, mean over the cycle [K]
  Field T_shell_max;          ///< surface, largest [K]
  Field heat_to_shell;        ///< mean over the cycle, per area [W/m2]
  Field thermal_deformation;  ///< thermal widening of the gap [m]
};

/// Film at a chosen instant.
struct CycleFrame {
  double t = 0.0;  ///< [s]
  Field p, theta, h;
};

struct CycleResult {
  Verdict verdict;
  Tier tier = Tier::isothermal;
  std::string title;
  double period = 0.0;       ///< told; of a single event its length [s]
  double crank_speed = 0.0;  ///< crank angle per time [rad/s]; 0: told in time
  int cycles = 0;            ///< that were run
  /// What separates the last one from the periodic state, as differences between cycles tell [-].
  double closure = std::numeric_limits<double>::quiet_NaN();
  /// Of a small displacement of the journal, and of the oil that it moves, in a cycle
  /// (orbit_growth.hpp); looked at where what goes slowly was led on, else not known [-].
  double growth = std::numeric_limits<double>::quiet_NaN();
  std::vector<CycleInstant> instants;     ///< of the last cycle; the first stands at t = 0
  std::vector<CycleQuantity> quantities;  ///< means, smallest and largest
  CycleAudit audit;
  CycleFields fields;
  std::vector<CycleFrame> frames;
  std::vector<Effect> effects;  ///< of tiers with a film; else empty
  std::vector<LimiterCount> limiters;
  std::vector<Note> warnings;
  std::vector<Note> assumptions;
  std::array<int, 2> grid{0, 0};
  Cost cost;
  std::optional<WallMeans> walls;    ///< of the last cycle, on the solved grid; resolved tiers
  int steps = 0;                     ///< accepted, of the last cycle
  int rejected_steps = 0;            ///< of the last cycle
  std::optional<AutoChoice> choice;  ///< set if tier `auto` chose
};

/// The quantity `name`; null if the cycle's tier does not know it.
[[nodiscard]] const CycleQuantity* quantity_named(const CycleResult& r, const std::string& name);

/// Value of the quantity `name`, or not-a-number if the cycle's tier does not know it.
[[nodiscard]] double value_of(const CycleResult& r, const std::string& name);

/// What the cycle tells, without the instants.
[[nodiscard]] std::vector<Quantity> quantities_of(const CycleResult& r);

/// What a cycle has in common with the result of a steady state: verdict, notes, grid and cost.
[[nodiscard]] Result head_of(const CycleResult& r);

/// The same with the cycle's quantities; the bar of time counts with that of the grid.
[[nodiscard]] Result as_result(const CycleResult& r);

/// Solves the load cycle of the case (`Case::cycle`) on the case's grid, in tier isothermal (at the
/// equivalent temperature), lumped (at the temperature at which the oil of a mean cycle carries off
/// its heat), thd or tehd: cycles from rest in the middle of the clearance until two agree within
/// 1e-4 in smallest film and torque, and until the walls' mean temperatures agree with the heat
/// that enters them within 0.1 K. A single event is run once, from the steady state of
/// its first row and with the walls of that. What has been found is kept where a step is not found
/// or `control` says stop. Throws InputError for the
/// tiers estimate and auto, which fidelity/auto_cycle.hpp serves, and for a case without a cycle.
[[nodiscard]] CycleResult solve_cycle(const Case& c, Tier tier, const SolveControl& control = {});

}  // namespace shellback::bearing
