#pragma once
/// Thermal conductivity and heat capacity of the oil.
///
///   conductivity   k = constant
///                  k = a [1 + b p / (1 + c p)],  p in GPa             seed 002 Eq. 29 (Larsson)
///                  k = (a / s) (1 - b T_C),      T_C in degC          seed 002 Eq. 30
///   heat capacity  cp = constant
///                  cp = (a + b T_C) / s^n,       T_C in degC          seed 002 Eq. 31
///
/// Reading. Eq. 29 prints its fraction as "1 + bp 1 + cp", with a = 0.137 W/(m K), b = 1.72,
/// c = 0.54 and no unit for p. As a (1 + b p/(1 + c p)) with p in GPa the conductivity doubles
/// at 0.85 GPa and tends to 4.2 a, which is what Larsson and Andersson measured on oils
/// (textbook); in Pa the law would be constant from 10 Pa upwards, in MPa from 10 MPa. The other
/// reading of the fraction, (1 + b p)/(1 + c p), gives 1.77 a instead of 2.12 a
/// at 1 GPa and 1.11 a instead of 1.16 a at 0.1 GPa, and is not taken: it is not Larsson's law.
/// Seed 002 gives a = 0.12, b = 1.667e-4 for Eq. 30 and a = 1630, b = 3.4, n = 0.5 for Eq. 31.
///
/// p gauge [Pa], T [K].
#include <cmath>
#include <variant>

#include "core/constants.hpp"
#include "rheology/oil.hpp"

namespace shellback::rheology {

struct Conductivity {
  double k;   ///< [W/(m K)]
  double dT;  ///< [W/(m K2)]
  double dp;  ///< [W/(m K Pa)]
};

struct HeatCapacity {
  double cp;  ///< [J/(kg K)]
  double dT;  ///< [J/(kg K2)]
};

inline constexpr double kPascalPerGiga = 1e9;  ///< [Pa/GPa], definition

[[nodiscard]] inline Conductivity conductivity(const ConstantConductivity& law, double /*T*/,
                                               double /*p*/) {
  return {law.k, 0.0, 0.0};
}

[[nodiscard]] inline Conductivity conductivity(const PressureConductivity& law, double /*T*/,
                                               double p) {
  const double giga = p / kPascalPerGiga;
  const double q = 1.0 / (1.0 + law.c * giga);
  return {law.a * (1.0 + law.b * giga * q), 0.0, law.a * law.b * q * q / kPascalPerGiga};
}

[[nodiscard]] inline Conductivity conductivity(const TemperatureConductivity& law, double T,
                                               double /*p*/) {
  const double scale = law.a / law.s;
  return {scale * (1.0 - law.b * (T - kZeroCelsius)), -scale * law.b, 0.0};
}

[[nodiscard]] inline Conductivity conductivity(const Oil& oil, double T, double p) {
  return std::visit([T, p](const auto& law) { return conductivity(law, T, p); }, oil.conductivity);
}

[[nodiscard]] inline HeatCapacity heat_capacity(const ConstantHeatCapacity& law, double /*T*/) {
  return {law.cp, 0.0};
}

[[nodiscard]] inline HeatCapacity heat_capacity(const TemperatureHeatCapacity& law, double T) {
  const double scale = std::pow(law.s, -law.n);
  return {scale * (law.a + law.b * (T - kZeroCelsius)), scale * law.b};
}

[[nodiscard]] inline HeatCapacity heat_capacity(const Oil& oil, double T) {
  return std::visit([T](const auto& law) { return heat_capacity(law, T); }, oil.heat_capacity);
}

}  // namespace shellback::rheology
