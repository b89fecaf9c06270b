#pragma once
/// Numbers that follow from a case by closed formulas, before any film is solved.
///
///   specific load    p = F / (B D)                                   [Pa]            (1)
///   Sommerfeld       So = p psi^2 / (eta omega),  psi = c/R          [-]             (2)
///                    S = 1 / (2 pi So)                               [-]             (3)
///   Reynolds         Re = rho U c / eta, against 41.2 sqrt(R/c)      [-]             (4)
///   Petroff          M = 2 pi eta omega R^3 B / c                    [N m]           (5)
///   heat per pass    dT = 4 pi eta omega (R/c)^2 / (rho cp)          [K]             (6)
///
/// (1)-(3), (5) textbook; (4) Taylor's limit for c << R, textbook; (6) Petroff's power over the
/// heat that the Couette flow U c B/2 takes up per kelvin. The eccentricity under a load is the
/// estimate of `estimated_sommerfeld`. All hold for a full, concentric or nearly rigid film: they
/// tell magnitudes, not results.
#include <optional>
#include <string>

#include "bearing/case.hpp"

namespace shellback::app {

/// Sommerfeld number So of a full bearing at eccentricity ratio eps and width over diameter b:
///   1/So = 1/So_short + 1/So_long,
///   So_short = b^2 eps sqrt(16 eps^2 + pi^2 (1-eps^2)) / (2 (1-eps^2)^2)    Ocvirk half film
///   So_long  = 3 eps sqrt(pi^2 (1-eps^2) + 4 eps^2) / ((2+eps^2)(1-eps^2))  half Sommerfeld
/// The sum is an interpolation of ours between the two textbook limits; against Butenschoen's
/// tables it stays within 16 % for b = 1/4..1, eps = 0.1..0.99 (tested). 0 <= eps < 1.
[[nodiscard]] double estimated_sommerfeld(double eps, double b);

/// The eps of `estimated_sommerfeld`, by bisection; So >= 0.
[[nodiscard]] double estimated_eccentricity(double so, double b);

/// P/p_max of a full bearing, the ratio of specific load to peak pressure: Raimondi and Boyd
/// 1958, L/D = 1/2, interpolated linearly in eps, constant beyond 0.1 and 0.97.
[[nodiscard]] double estimated_pressure_ratio(double eps);

struct Derived {
  double T = 0.0;                   ///< temperature of the estimates [K]
  std::string T_source;             ///< where it comes from
  double eta = 0.0;                 ///< low-shear viscosity there [Pa s]
  double rho = 0.0;                 ///< [kg/m3]
  double cp = 0.0;                  ///< [J/(kg K)]
  double k = 0.0;                   ///< [W/(m K)]
  double beta = 0.0;                ///< -d ln eta / dT [1/K]
  double speed = 0.0;               ///< surface speed [m/s]
  double clearance_ratio = 0.0;     ///< c / R [-]
  double specific_load = 0.0;       ///< (1), also of a prescribed eccentricity [Pa]
  bool load_given = false;          ///< otherwise the load is the estimate
  double so = 0.0;                  ///< (2) [-]
  double eccentricity_ratio = 0.0;  ///< [-]
  double h_min = 0.0;               ///< c (1 - eps) [m]
  double p_max = 0.0;               ///< [Pa]
  bool rigid_film = true;           ///< false: eps >= 1 is given, and (1), (2), p_max unknown
  double reynolds = 0.0;            ///< (4) [-]
  double reynolds_limit = 0.0;      ///< [-]
  double petroff_torque = 0.0;      ///< (5) [N m]
  double petroff_power = 0.0;       ///< [W]
  double heat_per_pass = 0.0;       ///< (6) [K]
  std::optional<double> lambda;     ///< h_min over combined roughness [-]; nothing: smooth
};

[[nodiscard]] Derived derive(const bearing::Case& subject);

}  // namespace shellback::app
