#pragma once
/// What is told of a bearing whose bodies warm up or cool down, at one instant.
#include <array>
#include <limits>
#include <vector>

namespace shellback::bearing {

/// The bearing at one instant.
struct Instant {
  double t = 0.0;       ///< [s]
  double dt = 0.0;      ///< step that led there [s]
  double torque = 0.0;  ///< of friction [N m]
  double h_min = 0.0;   ///< [m]
  double T_film_max = 0.0, T_shell_max = 0.0, T_shell_back = 0.0, T_shaft = 0.0;  ///< [K]
  // Means over the step; over cycles those of the cycle at its end.
  double heat_in = 0.0;      ///< friction and pump power [W]
  double heat_out = 0.0;     ///< with the oil and from shell and shaft to the surroundings [W]
  double stored = 0.0;       ///< in oil, shell, housing and shaft [W]
  double deformation = 0.0;  ///< mean thermal widening of the gap [m]
  double T_film_min = std::numeric_limits<double>::quiet_NaN();  ///< over a cycle not known [K]
};

/// A value that is followed over time: its name among the quantities of a result, and its unit.
template <class State>
struct Followed {
  const char* name;
  const char* unit;
  double State::*value;
};

inline constexpr std::array kFollowedInstants{
    Followed<Instant>{"friction_torque", "N m", &Instant::torque},
    Followed<Instant>{"h_min", "m", &Instant::h_min},
    Followed<Instant>{"T_film_max", "K", &Instant::T_film_max},
    Followed<Instant>{"T_shell_max", "K", &Instant::T_shell_max},
    Followed<Instant>{"T_shell_back", "K", &Instant::T_shell_back},
    Followed<Instant>{"T_shaft", "K", &Instant::T_shaft},
    Followed<Instant>{"thermal_opening_mean", "m", &Instant::deformation},
    Followed<Instant>{"heat_in", "W", &Instant::heat_in},
    Followed<Instant>{"heat_out", "W", &Instant::heat_out},
    Followed<Instant>{"heat_stored", "W", &Instant::stored}};

}  // namespace shellback::bearing
