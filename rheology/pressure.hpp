#pragma once
/// Viscosity under pressure: ln eta(T, p) from the ambient-pressure law, with both slopes.
///
///   none      ln eta = ln eta0(T)
///   Barus     ln eta = ln eta0(T) + alpha p                                    seed 000 Eq. 7
///   Roelands  ln eta = ln eta0(T) + (ln eta0(T) + 9.67) [(1 + B p)^Z - 1]      seed 002 Eq. 21
///   Houpert   ln eta = ln eta_r + A [((T - 138 K)/(at - 138 K))^(-S0) (1 + B p)^Z - 1]
///             eta_r = eta0(at), A = ln eta_r + 9.67, S0 = beta (at - 138 K)/A  seed 002 Eq. 23, 24
///
/// B = 5.1e-9 1/Pa, p gauge [Pa], eta in Pa s. The oil's temperature law enters Houpert only
/// through eta0(at): away from `at` Houpert's own slope beta REPLACES it, also at p = 0. At
/// T = at it is Roelands.
///
/// Validity: Barus up to about 200 MPa (seed 002, text after Eq. 20), Roelands and Houpert beyond.
/// p > -1/B = -196 MPa, eta0 > 6.3e-5 Pa s (ln eta0 > -9.67), T > 138 K.
#include <cmath>
#include <variant>

#include "rheology/oil.hpp"
#include "rheology/temperature.hpp"

namespace shellback::rheology {

inline constexpr double kRoelandsSlope = 5.1e-9;  ///< B of seed 002 Eq. 21 [1/Pa]
inline constexpr double kRoelandsLog = 9.67;      ///< -ln of Roelands' pole viscosity in Pa s [-]
inline constexpr double kHoupertZero = 138.0;     ///< C of seed 002 Eq. 23 [K]

/// ln eta(T, p) and its derivatives.
struct LogAndSlopes {
  double value;  ///< ln(eta / 1 Pa s) [-]
  double dT;     ///< d ln eta / d T at constant p [1/K]
  double dp;     ///< d ln eta / d p at constant T [1/Pa]
};

template <class Temperature>
[[nodiscard]] LogAndSlopes log_viscosity(const NoPressureEffect&, const Temperature& law, double T,
                                         double /*p*/) {
  const LogAndSlope ambient = log_viscosity(law, T);
  return {ambient.value, ambient.dT, 0.0};
}

template <class Temperature>
[[nodiscard]] LogAndSlopes log_viscosity(const Barus& pressure, const Temperature& law, double T,
                                         double p) {
  const LogAndSlope ambient = log_viscosity(law, T);
  return {ambient.value + pressure.alpha * p, ambient.dT, pressure.alpha};
}

template <class Temperature>
[[nodiscard]] LogAndSlopes log_viscosity(const Roelands& pressure, const Temperature& law, double T,
                                         double p) {
  const LogAndSlope ambient = log_viscosity(law, T);
  const double A = ambient.value + kRoelandsLog;
  const double base = 1.0 + kRoelandsSlope * p;
  const double g = std::exp(pressure.Z * std::log(base));
  return {ambient.value + A * (g - 1.0), ambient.dT * g,
          A * g * pressure.Z * kRoelandsSlope / base};
}

template <class Temperature>
[[nodiscard]] LogAndSlopes log_viscosity(const Houpert& pressure, const Temperature& law, double T,
                                         double p) {
  const double reference = log_viscosity(law, pressure.at).value;
  const double A = reference + kRoelandsLog;
  const double S0 = pressure.beta * (pressure.at - kHoupertZero) / A;
  const double base = 1.0 + kRoelandsSlope * p;
  const double above = T - kHoupertZero;
  const double g =
      std::exp(pressure.Z * std::log(base) - S0 * std::log(above / (pressure.at - kHoupertZero)));
  return {reference + A * (g - 1.0), -A * g * S0 / above,
          A * g * pressure.Z * kRoelandsSlope / base};
}

}  // namespace shellback::rheology
