#pragma once
/// Linear stiffness and damping of a solved bearing, and the threshold of oil whirl.
///
/// Force and moment of film and contact on a journal that moves a little about its place,
///   F_i = F_i0 - K_ij dx_j - C_ij dx_j/dt                                            (1)
/// are the first two terms of the film's answer to slow motion: with the linearised film
/// (bearing/film_response.hpp), x(t) = dx exp(s t) and s -> 0,
///   K: the answer (u0, d0) to the displaced gap B dx;                                (2)
///   C: the answer to the oil that (2) stores as it comes and goes,
///      rho { theta hT' (B dx + d0) + hT theta0 } per area.                           (3)
/// So the gap's rate acts in full film with that of the shell following it; in cavitated film the
/// whole oil content does, theta h and not h: docs/decisions/013. Contact is part of K.
/// Held at the solved state: temperatures and thermal deformation (they follow far more slowly than
/// any whirl), which cells are full, density, and the shear rate in the viscosity. Frame X right, Y
/// up, rotation as the sign of omega. Load axes: x along the load on the journal, y a quarter turn
/// on in the direction of rotation, as in Lund and Thomsen's tables. Sources: perturbation
/// [textbook, Lund]; (3) is ours.
#include <array>
#include <limits>
#include <string>

#include "core/outcome.hpp"

namespace shellback::bearing {

using Matrix4 = std::array<std::array<double, 4>, 4>;
using Matrix2 = std::array<std::array<double, 2>, 2>;

/// Share of the damping from the cavitated film from which on it is told: the critical mass is told
/// too small by five times it [-] (tests/bearing/whirl_onset_test.cpp).
inline constexpr double kTelling = 0.01;

enum class WhirlVerdict {
  threshold,      ///< stable up to a critical mass
  always_stable,  ///< whatever the mass
  never_stable,   ///< whatever the mass
  unknown,        ///< none from K and C of slow motions, oil of the cavitated film being in them
};

/// Threshold of a rigid rotor in bearings alike: the mass per bearing, at the present speed, at
/// which it begins to whirl by itself.
struct WhirlThreshold {
  WhirlVerdict verdict = WhirlVerdict::threshold;
  double critical_mass = std::numeric_limits<double>::quiet_NaN();    ///< [kg]; inf; 0
  double whirl_frequency = std::numeric_limits<double>::quiet_NaN();  ///< nu [rad/s]; NaN: none
};

/// m x'' + C x' + K x = 0 has a solution exp(i nu t) if (real and imaginary part of the
/// determinant), with kappa = m nu^2,
///   kappa = (Kxx Cyy + Kyy Cxx - Kxy Cyx - Kyx Cxy)/(Cxx + Cyy)                         (4)
///   nu^2 = [(Kxx - kappa)(Kyy - kappa) - Kxy Kyx]/(Cxx Cyy - Cxy Cyx).                  (5)
/// Below m = kappa/nu^2 it is stable (Hurwitz). Never stable: trace C, kappa, det C or det K not
/// positive. Always: nu^2 of (5) not positive. Source: textbook (Lund's formula).
[[nodiscard]] WhirlThreshold whirl_threshold(const Matrix2& K, const Matrix2& C);

struct Coefficients {
  Verdict verdict;   ///< not good: nothing below is meant
  int unknowns = 2;  ///< 2: e_x, e_y; 4: and psi_x, psi_y (only known if the whole width is solved)
  Matrix4 K{};       ///< [N/m], [N/rad]; [N m/m], [N m/rad]
  Matrix4 C{};       ///< the same per velocity
  double load = 0.0;       ///< W, of film and contact [N]
  double clearance = 0.0;  ///< c, cold [m]
  double omega = 0.0;      ///< [rad/s]
  Matrix2 K_load{};        ///< in load axes, times c/W [-]
  Matrix2 C_load{};        ///< in load axes, times c |omega|/W [-]
  WhirlThreshold whirl;
  double whirl_ratio = 0.0;  ///< nu/|omega| at the threshold [-]; NaN: none
  double speed_ratio = 0.0;  ///< |omega| sqrt(c m/W) at the critical mass m [-]; inf; 0
  /// Largest entry of the part of C that comes from the oil content of the cavitated film, over the
  /// largest of C [-] (forces). Where it is not small, C holds for motions much slower than the
  /// oil's way through the cavitated film, about one turn: above kTelling the critical mass is too
  /// small, and that no mass is stable is not known.
  double cavitated_share = 0.0;
  int krylov_iterations = 0;
  double wall_s = 0.0;
};

/// Forces only.
[[nodiscard]] Matrix2 forces_of(const Matrix4& m);
/// `m` in axes turned so that the first lies at `angle` [rad], the second a quarter turn on in the
/// direction `turn` (+1 counter-clockwise, -1).
[[nodiscard]] Matrix2 in_axes(const Matrix2& m, double angle, int turn);

}  // namespace shellback::bearing
