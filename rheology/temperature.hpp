#pragma once
/// Viscosity at ambient pressure and low shear as a function of temperature.
///
///   constant   eta(T) = eta
///   Vogel      eta(T) = A exp(B / (T_C + C)),           T_C = T - 273.15 K   seed 000 Eq. 6
///   Reynolds   eta(T) = eta_at exp(-beta (T - at))                           seed 002 Eq. 25
///   Walther    eta(T) = rho(T) nu(T),  log log(nu + 0.7) = A - B log T       ASTM D341 (textbook)
///
/// All work with ln eta [ln Pa s] and its slope by T [1/K]: the pressure laws need the logarithm,
/// and a field of nodes then takes one exponential. Vogel holds for T_C > -C only (its pole);
/// seed 002 Eq. 26 prints the same law with the opposite sign of C. Walther holds for mineral oils
/// above 2 mm2/s; its nu, in mm2/s, is above 0.3 at every temperature.
#include <cmath>
#include <variant>

#include "core/constants.hpp"
#include "rheology/oil.hpp"

namespace shellback::rheology {

/// A logarithm and its derivative by temperature.
struct LogAndSlope {
  double value;  ///< ln(eta / 1 Pa s) [-]
  double dT;     ///< d ln eta / d T [1/K]
};

[[nodiscard]] inline LogAndSlope log_viscosity(const ConstantViscosity& law, double /*T*/) {
  return {std::log(law.eta), 0.0};
}

[[nodiscard]] inline LogAndSlope log_viscosity(const Vogel& law, double T) {
  const double q = 1.0 / (T - kZeroCelsius + law.C);
  return {std::log(law.A) + law.B * q, -law.B * q * q};
}

[[nodiscard]] inline LogAndSlope log_viscosity(const ReynoldsSlope& law, double T) {
  return {std::log(law.eta) - law.beta * (T - law.at), -law.beta};
}

[[nodiscard]] inline LogAndSlope log_viscosity(const Walther& law, double T) {
  constexpr double kShift = 0.7, kSquareMillimetre = 1e-6;
  const double w = std::exp(law.a - law.B * std::log(T));
  const double shifted = std::exp(w), nu = shifted - kShift;
  const double thinner = 1.0 - law.expansivity * (T - law.at);
  return {std::log(nu * kSquareMillimetre * law.rho * thinner),
          -shifted / nu * law.B * w / T - law.expansivity / thinner};
}

/// The law of nu through two points, nu [mm2/s] above 0.3 and T [K]; the density is still to be
/// set.
[[nodiscard]] inline Walther walther_through(double nu1, double T1, double nu2, double T2) {
  const double w1 = std::log(nu1 + 0.7), w2 = std::log(nu2 + 0.7);
  const double B = std::log(w1 / w2) / std::log(T2 / T1);
  return {std::log(w1) + B * std::log(T1), B, 0.0};
}

/// ln eta and its slope at temperature T [K] for whichever law the oil has.
[[nodiscard]] inline LogAndSlope log_viscosity(const TemperatureLaw& law, double T) {
  return std::visit([T](const auto& l) { return log_viscosity(l, T); }, law);
}

}  // namespace shellback::rheology
