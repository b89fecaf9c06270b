#pragma once
/// Load of a big end: what the crank pin carries in a connecting rod; and of a main bearing beside
/// the throw.
///
///   s = r cos theta + l cos beta,   l sin beta = r sin theta                          (1)
///   m_p s'' = S cos beta - p A,     S: thrust along the rod                           (2)
///   W_x = m_r r omega^2 sin(theta + beta),  W_y = S - m_r r omega^2 cos(theta + beta) (3)
///   omega_rel = omega + beta'       speed of the pin against the rod                  (4)
///
/// theta is the crank angle from the top dead centre of combustion, in the direction of rotation,
/// beta the rod's angle against the cylinder's axis. (3) is the load on the journal (the pin) in
/// the frame of the rod, in which the shell stands still: Y along the rod from big end to small
/// end, X to the right of it, angles counter-clockwise. Gas pushes the rod onto the pin, so that
/// the pin presses upon the rod's half of the shell, at phi = 90 deg; the inertia of the rotating
/// part of the rod pulls the cap onto it, at 270 deg. (3) and (4) stand for a crank that turns
/// counter-clockwise; clockwise, W_x and omega_rel change their sign.
///
/// A main bearing stands still in the block: X to the right, Y along the cylinder from the crank to
/// the piston. Its journal carries a share b of what acts on the crank's throw, the film's force at
/// the pin, -W turned into the block, and the pull of the counterweight U (mass times distance from
/// the axis, opposite the pin):
///   L = b (-S a + (m_r r - U) omega^2 P/r),   a = (sin beta, cos beta),
///   P/r = (-sin theta, cos theta)                                                     (5)
/// Gas presses it upon the cap of the main bearing, at phi = 270 deg. Its speed is omega.
///
/// Valid for a rigid rod of two lumped masses, a pin without offset, a crank at constant speed, no
/// friction at piston and piston pin, no weight; (5) for a crank that is as if cut between its
/// throws: what neighbouring throws and a bent block do is not in it. Source: textbook mechanics,
/// derived in docs/theory.md; SI units throughout.
#include <vector>

#include "bearing/load_cycle.hpp"

namespace shellback::bearing {

/// Where the bearing is, and with that the frame in which its shell stands still.
enum class CrankFrame { rod, block };

/// A slider-crank and the gas above its piston.
struct Crank {
  double stroke = 0.0;             ///< 2 r [m]
  double rod_length = 0.0;         ///< l, from centre to centre [m]
  double bore = 0.0;               ///< diameter of A [m]; without pressure of no effect
  double piston_mass = 0.0;        ///< m_p: piston, its pin, reciprocating part of the rod [kg]
  double rod_mass = 0.0;           ///< m_r: rotating part of the rod [kg]
  double counterweight = 0.0;      ///< U: of one throw, less pin and webs [kg m]; main bearings
  double share = 0.5;              ///< b: of the throw's load on one main bearing [-]
  double period = 0.0;             ///< 4 pi (four strokes) or 2 pi [rad]
  std::vector<double> angle{};     ///< theta, rising within [0, period) [rad]; empty: no gas
  std::vector<double> pressure{};  ///< there, above that in the crankcase [Pa]
};

/// Where piston and rod are.
struct CrankMotion {
  double piston = 0.0;               ///< s, small end above the crank's axis [m]
  double piston_velocity = 0.0;      ///< s' [m/s]
  double piston_acceleration = 0.0;  ///< s'' [m/s2]
  double rod_angle = 0.0;            ///< beta [rad]
  double rod_rate = 0.0;             ///< beta' [rad/s]
};

/// (1) and its derivatives at crank angle theta [rad] and speed omega >= 0 [rad/s]; needs
/// 2 rod_length > stroke.
[[nodiscard]] CrankMotion crank_motion(const Crank& crank, double theta, double omega);

/// Pressure above that in the crankcase [Pa] at crank angle theta [rad]: straight lines between the
/// points, repeated with the period; 0 without points.
[[nodiscard]] double cylinder_pressure(const Crank& crank, double theta);

/// (2)-(4) at crank angle theta [rad] and speed omega [rad/s], negative: clockwise.
[[nodiscard]] LoadNow crank_load_at(const Crank& crank, double theta, double omega);

/// (5) and omega, likewise.
[[nodiscard]] LoadNow main_bearing_load_at(const Crank& crank, double theta, double omega);

/// Load cycle of the big end (rod) or of the main bearing (block) over one period: rows at n equal
/// steps and at the points of the pressure, straight lines between them; t = theta/|omega|. omega
/// as above. Throws InputError, by key, for what is no crank: lengths and masses that are not
/// positive or no numbers, a rod no longer than the crank's radius, angles that do not rise within
/// the period or are not as many as pressures, omega = 0, n < 1.
[[nodiscard]] LoadCycle crank_load(const Crank& crank, double omega,
                                   CrankFrame frame = CrankFrame::rod, int n = 720);

}  // namespace shellback::bearing
