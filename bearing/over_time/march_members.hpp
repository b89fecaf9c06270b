#pragma once
/// What marches of the bodies in time are made of, for a tape (core/tape.hpp, which counts up to
/// five members for itself). A member that is added to one of these types and not here does not
/// compile.
#include "bearing/over_time/march_over_cycles.hpp"
#include "bearing/over_time/solution_members.hpp"

namespace shellback {

inline void members(Tape& tape, bearing::Instant& x) {
  auto& [t, dt, torque, h_min, T_film_max, T_shell_max, T_shell_back, T_shaft, heat_in, heat_out,
         stored, deformation, T_film_min] = x;
  tape(t, dt, torque, h_min, T_film_max, T_shell_max, T_shell_back, T_shaft, heat_in, heat_out,
       stored, deformation, T_film_min);
}

inline void members(Tape& tape, bearing::MarchEnd& x) {
  auto& [verdict, t, at_rest, left_bounds, jumps, unfollowed, warnings] = x;
  tape(verdict, t, at_rest, left_bounds, jumps, unfollowed, warnings);
}

inline void members(Tape& tape, bearing::SolidState& x) {
  auto& [shell, shaft] = x;
  tape(shell, shaft);
}

}  // namespace shellback
