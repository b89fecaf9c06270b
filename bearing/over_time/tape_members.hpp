#pragma once
/// What states and results over a load cycle are made of, for a tape (core/tape.hpp, which counts
/// up to five members for itself). A member that is added to one of these types and not here does
/// not compile.
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/film_step.hpp"
#include "core/extrapolation.hpp"
#include "core/tape.hpp"

namespace shellback {

inline void members(Tape& tape, FilmGrid& x) {
  auto& [nt, nz, half, radius, width, phi_face, phi, dphi, z_face, z, dz] = x;
  tape(nt, nz, half, radius, width, phi_face, phi, dphi, z_face, z, dz);
}

// The film.

inline void members(Tape& tape, fluid::FaceFlow& x) {
  auto& [m, couette, carried, d_left, d_right, d_theta, d_h, rise] = x;
  tape(m, couette, carried, d_left, d_right, d_theta, d_h, rise);
}

inline void members(Tape& tape, fluid::FilmFlow& x) {
  auto& [phi, z, lines, fed, stored, by_theta, by_p, by_gap, edge] = x;
  tape(phi, z, lines, fed, stored, by_theta, by_p, by_gap, edge);
}

inline void members(Tape& tape, fluid::OilFlows& x) {
  auto& [supply, side, side_inflow, stored, patch, pocket] = x;
  tape(supply, side, side_inflow, stored, patch, pocket);
}

inline void members(Tape& tape, bearing::OilColumns& x) {
  auto& [T, eta, g0, centre, T_mean, mismatch] = x;
  tape(T, eta, g0, centre, T_mean, mismatch);
}

inline void members(Tape& tape, bearing::Evaluation& x) {
  auto& [gap, shear_gap, oil, flow, gradient_x, gradient_z, p_contact, dp_contact, layer, force,
         least] = x;
  tape(gap, shear_gap, oil, flow, gradient_x, gradient_z, p_contact, dp_contact, layer, force,
       least);
}

/// Over a cycle contact widens nothing by itself (`contact_widening` is none).
inline void members(Tape& tape, bearing::FilmEquilibrium& x) {
  tape(static_cast<bearing::State&>(x), static_cast<bearing::Evaluation&>(x), x.columns);
}

// Heat.

inline void members(Tape& tape, thermal::EnergyBalance& x) {
  auto& [heat, to_shell, to_shaft, carried_out, carried_in, stored] = x;
  tape(heat, to_shell, to_shaft, carried_out, carried_in, stored);
}

inline void members(Tape& tape, thermal::WallResponse& x) {
  auto& [shell, shaft, across, back, shell_local, shell_ring, shaft_ring] = x;
  tape(shell, shaft, across, back, shell_local, shell_ring, shaft_ring);
}

inline void members(Tape& tape, bearing::HeatInTime& x) {
  auto& [T, held, skin, held_slope, skin_slope, T_slope, flows] = x;
  tape(T, held, skin, held_slope, skin_slope, T_slope, flows);
}

// The bearing in time.

inline void members(Tape& tape, bearing::FilmTrend& x) {
  auto& [p, theta, elastic, q] = x;
  tape(p, theta, elastic, q);
}

inline void members(Tape& tape, bearing::FilmInTime& x) {
  auto& [t, film, oil, velocity, acceleration, oil_slope, flows, full_before, heat, trend,
         thermal_deformation, vessels, layer] = x;
  tape(t, film, oil, velocity, acceleration, oil_slope, flows, full_before, heat, trend,
       thermal_deformation, vessels, layer);
}

inline void members(Tape& tape, bearing::EquilibriumCost& x) {
  auto& [factorizations, newton, rejected, sweeps, rounds, work, most_work] = x;
  tape(factorizations, newton, rejected, sweeps, rounds, work, most_work);
}

// Results.

inline void members(Tape& tape, bearing::Quantity& x) {
  auto& [name, value, unit, error_grid, error_model, order, error_nodes, error_time, magnitude,
         limit] = x;
  tape(name, value, unit, error_grid, error_model, order, error_nodes, error_time, magnitude,
       limit);
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

inline void members(Tape& tape, bearing::CycleAudit& x) {
  auto& [mass, impulse, load, energy, work, walls, walls_mean, to_shell, to_shaft] = x;
  tape(mass, impulse, load, energy, work, walls, walls_mean, to_shell, to_shaft);
}

inline void members(Tape& tape, bearing::CycleFields& x) {
  auto& [grid, p_max, p_asperity_max, h_min, friction_power, layer_depth, T_shell, T_shell_max,
         heat_to_shell, thermal_deformation] = x;
  tape(grid, p_max, p_asperity_max, h_min, friction_power, layer_depth, T_shell, T_shell_max,
       heat_to_shell, thermal_deformation);
}

inline void members(Tape& tape, bearing::note::TierTaken& x) {
  auto& [tier, grid, friction, h_min, unjudged, solved] = x;
  tape(tier, grid, friction, h_min, unjudged, solved);
}

inline void members(Tape& tape, bearing::Cost& x) {
  auto& [wall_s, setup_s, factorizations, newton_iterations, outer_iterations, bars_s] = x;
  tape(wall_s, setup_s, factorizations, newton_iterations, outer_iterations, bars_s);
}

inline void members(Tape& tape, bearing::CycleResult& x) {
  auto& [verdict, tier, title, period, crank_speed, cycles, closure, growth, instants, quantities,
         audit, fields, frames, limiters, warnings, assumptions, grid, cost, walls, steps,
         rejected_steps, choice] = x;
  tape(verdict, tier, title, period, crank_speed, cycles, closure, growth, instants, quantities,
       audit, fields, frames, limiters, warnings, assumptions, grid, cost, walls, steps,
       rejected_steps, choice);
}

}  // namespace shellback
