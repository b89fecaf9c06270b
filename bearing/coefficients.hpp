#pragma once
/// Linear stiffness and damping of a solved bearing, and the threshold of oil whirl, which is that
/// of the film at the frequency of the whirl (bearing/film/film_impedance.hpp).
///
/// Force and moment of film and contact on a journal that moves a little about its place,
///   F_i = F_i0 - K_ij dx_j - C_ij dx_j/dt                                            (1)
/// are the first two terms of the film's answer to slow motion: with the linearised film
/// (bearing/film/film_response.hpp), x(t) = dx exp(s t) and s -> 0,
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
#include <complex>
#include <functional>
#include <limits>
#include <string>

#include "core/outcome.hpp"

namespace shellback::bearing {

using Matrix4 = std::array<std::array<double, 4>, 4>;
using Matrix2 = std::array<std::array<double, 2>, 2>;
using ComplexMatrix2 = std::array<std::array<std::complex<double>, 2>, 2>;

enum class WhirlVerdict {
  threshold,      ///< stable up to a critical mass
  always_stable,  ///< whatever the mass
  never_stable,   ///< whatever the mass
};

/// Threshold of a rigid rotor in bearings alike: the mass per bearing, at the present speed, at
/// which it begins to whirl by itself. Its tilt stays as it is, or, where a moment is given, is the
/// one that balances it at every instant.
struct WhirlThreshold {
  WhirlVerdict verdict = WhirlVerdict::threshold;
  double critical_mass = std::numeric_limits<double>::quiet_NaN();    ///< [kg]; inf; 0
  double whirl_frequency = std::numeric_limits<double>::quiet_NaN();  ///< nu [rad/s]; NaN: none
};

/// Z(nu): force of the film on a journal that swings, F = -Z(nu) dx exp(i nu t) [N/m].
using Impedance = std::function<ComplexMatrix2(double nu)>;

/// (-m nu^2 + Z(nu)) dx = 0 has a solution with real nu if, with kappa = m nu^2, imaginary and real
/// part of the determinant vanish,
///   kappa = Im det Z / Im tr Z,   g = kappa^2 - kappa Re tr Z + Re det Z = 0.             (4)
/// The rotor is stable up to the smallest such m, if it is without mass: if det Z(nu) turns once
/// counter-clockwise by pi as nu goes from zero to infinity and Z(0) has a positive determinant
/// (argument principle; the film with its journal held is stable). With Z = K + i nu C this is
/// Hurwitz' condition and Lund's formula. Roots are sought up to `highest` [rad/s], beyond which
/// det Z is taken to turn no more than half a turn. Source: textbook.
[[nodiscard]] WhirlThreshold whirl_threshold(const Impedance& Z, double highest);

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
  /// Of the part of C that comes from the oil content of the cavitated film over all of C, as roots
  /// of sums of squares, which no choice of axes changes [-] (forces). Where it is not small, C
  /// holds for motions much slower than the oil's way through the cavitated film, about one turn;
  /// the threshold of whirl holds in any case.
  double cavitated_share = 0.0;
  double wall_s = 0.0;
};

/// Forces only.
[[nodiscard]] Matrix2 forces_of(const Matrix4& m);
/// `m` in axes turned so that the first lies at `angle` [rad], the second a quarter turn on in the
/// direction `turn` (+1 counter-clockwise, -1).
[[nodiscard]] Matrix2 in_axes(const Matrix2& m, double angle, int turn);

}  // namespace shellback::bearing
