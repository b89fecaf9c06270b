#pragma once
/// What states and results over a load cycle are made of, for a tape, where core/tape.hpp does not
/// count their members for itself. One that is added to these types and not here does not compile.
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/film_step.hpp"
#include "core/extrapolation.hpp"
#include "core/tape.hpp"

namespace shellback {

/// Over a cycle contact widens nothing by itself (`contact_widening` is none).
inline void members(Tape& tape, bearing::FilmEquilibrium& x) {
  tape(static_cast<bearing::State&>(x), static_cast<bearing::Evaluation&>(x), x.columns);
}

inline void members(Tape& tape, bearing::FilmTrend& x) {
  auto& [p, theta, elastic, q] = x;
  tape(p, theta, elastic, q);
}

/// Of a film whose flow is held: its shell does not yield, and it has no heat but what thinning
/// takes from it.
inline void members(Tape& tape, thermal::FilmEnergyProblem& x) {
  auto& [grid, gl, phi_flow, z_flow, lines, patch, line, conductance, heat, thinning, cp, vessels,
         fed, T_reference, T_edge, cp_edge, forward, throttled, storage, shell] = x;
  if (!storage) storage.emplace();
  tape(phi_flow, z_flow, lines, patch, line, conductance, thinning, cp, vessels, fed, T_reference,
       T_edge, cp_edge, forward, storage->dt, storage->mass, storage->mass_before);
  heat.assign(cp.size(), 0.0);
  storage->heat_before.assign(cp.size(), 0.0);
}

inline void members(Tape& tape, bearing::CycleInstant& x) {
  auto& [t, dt, load_x, load_y, omega, ex, ey, vx, vy, tilt_x, tilt_y, h_min, h_min_angle, p_max,
         p_asperity_max, torque, torque_asperity, torque_abrasive, torque_adhesive,
         torque_micro_hydrodynamic, breakaway, power, supply_flow, side_flow, oil, p_vessel,
         T_film_max, T_shell_max, heat_to_shell, heat_to_shaft] = x;
  tape(t, dt, load_x, load_y, omega, ex, ey, vx, vy, tilt_x, tilt_y, h_min, h_min_angle, p_max,
       p_asperity_max, torque, torque_asperity, torque_abrasive, torque_adhesive,
       torque_micro_hydrodynamic, breakaway, power, supply_flow, side_flow, oil, p_vessel,
       T_film_max, T_shell_max, heat_to_shell, heat_to_shaft);
}

inline void members(Tape& tape, bearing::CycleResult& x) {
  auto& [verdict, tier, title, period, crank_speed, cycles, closure, growth, instants, quantities,
         audit, fields, frames, effects, limiters, warnings, assumptions, grid, cost, walls, steps,
         rejected_steps, choice] = x;
  tape(verdict, tier, title, period, crank_speed, cycles, closure, growth, instants, quantities,
       audit, fields, frames, effects, limiters, warnings, assumptions, grid, cost, walls, steps,
       rejected_steps, choice);
}

}  // namespace shellback
