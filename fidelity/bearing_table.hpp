#pragma once
/// The plain bearing of finite width, from a table that this program's own solver has computed.
///
/// Full cylindrical bearing, rigid, smooth, isoviscous, mass-conserving cavitation, flooded edges
/// at ambient pressure, fed at ambient pressure along an axial line at the widest gap: the bearing
/// of Raimondi and Boyd. data/tables/plain_bearing.csv, made by validation/tables.
///
/// The table holds eps = 0.01 ... 0.999 and b = B/D = 0.05 ... 8. What is interpolated (monotone
/// cubics in ln b, then in -ln(1 - eps)) are ratios to the closed forms that the bearing tends to
/// (closed_forms.hpp), so that beyond the table's ends the closed forms rule: eps -> 0 and b -> 0
/// Ocvirk's narrow bearing, eps -> 1 the wide bearing's local film (So ~ 1/(1 - eps), p_max/p ~
/// (1 - eps)^(-1/2)), and b above 8 is taken as 8.
#include <array>
#include <cmath>

#include "core/bracketed_root.hpp"
#include "core/monotone_cubic.hpp"

namespace shellback::fidelity {

/// Relative error of interpolated numbers, table and interpolation together: more than 99 of 100
/// points at the middle of the table's fields lie within it (tests/fidelity, docs/auto-tier.md).
inline constexpr double kTableError = 0.005;

/// Text of the table, built into the program.
[[nodiscard]] const char* plain_bearing_table();

/// Numbers of one bearing at one eccentricity.
struct BearingNumbers {
  double so = 0.0;        ///< F psi^2/(B D eta omega) [-]
  double attitude = 0.0;  ///< from the load line to the line of centres [rad]
  /// Couette torque of the film over that of the full film, shear weighted by the fill [-]. The
  /// torque on the journal is couette * couette_torque(eps) + eps So sin(attitude), both over
  /// eta omega R^3 B/c (moment balance; the full rule has couette = 1).
  double couette = 0.0;
  double side = 0.0;      ///< side flow over omega R c B [-]
  double pressure = 0.0;  ///< p_max over F/(B D) [-]
};

/// The table at one width over diameter, ready to be asked at many eccentricities.
class BearingCurve {
 public:
  explicit BearingCurve(double b);

  /// 0 < eps < 1.
  [[nodiscard]] BearingNumbers at(double eps) const;

 private:
  double b_;
  std::array<MonotoneCubic, 5> ratios_;  ///< of each number, over -ln(1 - eps)
};

/// The eccentricity ratio at which f, rising with it, vanishes: sought in ln(eps/(1 - eps)), in
/// which ln So is nearly straight. Nothing is told apart within 1e-9 of 0 and 1.
template <class F>
[[nodiscard]] double eccentricity_where(F f) {
  const auto eps = [](double x) { return 1.0 / (1.0 + std::exp(-x)); };
  const double end = std::log(1e9);
  return eps(root_between([&](double x) { return f(eps(x)); }, -end, end, 1e-10));
}

}  // namespace shellback::fidelity
