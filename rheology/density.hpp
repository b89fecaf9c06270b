#pragma once
/// Density of the oil as a function of temperature and pressure.
///
///   constant          rho
///   Dowson-Higginson  rho = rho0 [1 + a p/(1 + b p) - c (T - at)]          seed 002 Eq. 27, 28
///                     a = 0.6e-9 1/Pa, b = 1.7e-9 1/Pa unless an oil has its own
///
/// Reading. The seed's text runs the fraction together as "1 + 0.6e-9 p 1 + 1.7e-9 p". Taken as
/// (1 + 0.6e-9 p)/(1 + 1.7e-9 p) the density would FALL under pressure, to 0.35 rho0; with the
/// fraction after the first 1 it rises, by at most 0.6/1.7 = 35 %: that is Dowson and
/// Higginson's law (textbook). The thermal term stands inside the bracket, added.
///
/// The same law is often written rho0 (C1 + C2 p)/(C1 + p): then a = (C2 - 1)/C1, b = 1/C1. The
/// constants differ between oils: the seed's are C1 = 588 MPa, C2 = 1.353; others take C1 = 2.22
/// GPa, C2 = 1.66, half that compressibility. A film that reforms in a shallow pocket tells them
/// apart: the peak behind it is 41.9 MPa instead of 36.8
/// (tests/validation/compressible_pocket_test.cpp).
///
/// p gauge [Pa], above -1/b (-588 MPa); T [K]. Slope at p = 0: a, a bulk modulus of 1/a (1.67 GPa).
/// The density is positive while c (T - at) stays below 1.
#include <variant>

#include "rheology/oil.hpp"

namespace shellback::rheology {

struct Density {
  double rho;  ///< [kg/m3]
  double dT;   ///< [kg/(m3 K)]
  double dp;   ///< [kg/(m3 Pa)]
};

[[nodiscard]] inline Density density(const ConstantDensity& law, double /*T*/, double /*p*/) {
  return {law.rho, 0.0, 0.0};
}

[[nodiscard]] inline Density density(const DowsonHigginson& law, double T, double p) {
  const double q = 1.0 / (1.0 + law.limit * p);
  return {law.rho0 * (1.0 + law.rise * p * q - law.expansivity * (T - law.at)),
          -law.rho0 * law.expansivity, law.rho0 * law.rise * q * q};
}

[[nodiscard]] inline Density density(const Oil& oil, double T, double p) {
  return std::visit([T, p](const auto& law) { return density(law, T, p); }, oil.density);
}

}  // namespace shellback::rheology
