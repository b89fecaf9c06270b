#pragma once
/// Parameters of one oil: the laws chosen for it and the range in which they were fitted.
///
/// A law is one alternative of a closed variant of parameter structs; the functions that
/// evaluate them are in temperature.hpp, pressure.hpp, shear.hpp, density.hpp, heat.hpp and,
/// over a whole column of film nodes, viscosity.hpp. SI units, kelvin, gauge pressure.
#include <string>
#include <variant>
#include <vector>

namespace shellback::rheology {

// Viscosity at ambient pressure and low shear, eta(T) -------------------------------------------

struct ConstantViscosity {
  double eta;  ///< viscosity [Pa s]
};
/// eta = A exp(B / (T_C + C)), T_C in degC; seed 000 Eq. 6.
struct Vogel {
  double A;  ///< [Pa s]
  double B;  ///< [K]
  double C;  ///< [K], added to the temperature in degC
};
/// eta = eta_at exp(-beta (T - at)); seed 002 Eq. 25.
struct ReynoldsSlope {
  double eta;   ///< viscosity at `at` [Pa s]
  double at;    ///< reference temperature [K]
  double beta;  ///< temperature coefficient [1/K]
};
/// eta = rho nu, ln(nu + 0.7) = exp(a - B ln T) with nu in mm2/s and T in K, which is ASTM D341,
/// log log(nu + 0.7) = A - B log T; rho = rho_at [1 - expansivity (T - at)].
struct Walther {
  double a;                  ///< A ln 10 + ln ln 10 [-]
  double B;                  ///< [-]
  double rho;                ///< density at `at` and ambient pressure [kg/m3]
  double at = 0.0;           ///< [K]
  double expansivity = 0.0;  ///< [1/K]
};
using TemperatureLaw = std::variant<ConstantViscosity, Vogel, ReynoldsSlope, Walther>;

// Pressure factor eta(T, p) / eta(T, 0) ---------------------------------------------------------

struct NoPressureEffect {};
/// exp(alpha p); seed 000 Eq. 7.
struct Barus {
  double alpha;  ///< [1/Pa]
};
/// exp{(ln eta0 + 9.67) [(1 + 5.1e-9 p)^Z - 1]}, eta0 = eta(T) in Pa s; seed 002 Eq. 21.
struct Roelands {
  double Z;  ///< pressure index [-]
};
/// eta0 exp{A [((T - 138 K)/(at - 138 K))^(-S0) (1 + 5.1e-9 p)^Z - 1]}, eta0 = eta(at),
/// A = ln eta0 + 9.67, S0 = beta (at - 138 K)/A; replaces the temperature law away from `at`;
/// seed 002 Eq. 23, 24.
struct Houpert {
  double Z;     ///< pressure index [-]
  double beta;  ///< temperature coefficient [1/K]
  double at;    ///< reference temperature [K]
};
using PressureLaw = std::variant<NoPressureEffect, Barus, Roelands, Houpert>;

// Shear factor eta(T, p, rate) / eta(T, p) ------------------------------------------------------

struct NoShearThinning {};
/// r + (1 - r) / (1 + (K rate)^m); seed 000 Eq. 8.
struct Cross {
  double r;  ///< ratio of second to first Newtonian viscosity [-]
  double K;  ///< time constant [s]
  double m;  ///< exponent [-]
};
using ShearLaw = std::variant<NoShearThinning, Cross>;

// Density, conductivity, heat capacity ----------------------------------------------------------

struct ConstantDensity {
  double rho;  ///< [kg/m3]
};
/// rho0 [1 + rise p/(1 + limit p) - expansivity (T - at)]; seed 002 Eq. 27, 28 (density.hpp says
/// how the printed fraction is read, and where the two constants come from).
struct DowsonHigginson {
  double rho0;            ///< density at `at` and ambient pressure [kg/m3]
  double at;              ///< reference temperature [K]
  double expansivity;     ///< [1/K]
  double rise = 0.6e-9;   ///< compressibility at p = 0 [1/Pa]
  double limit = 1.7e-9;  ///< rise/limit is the largest rise of the density [1/Pa]
};
using DensityLaw = std::variant<ConstantDensity, DowsonHigginson>;

struct ConstantConductivity {
  double k;  ///< [W/(m K)]
};
/// a (1 + b p / (1 + c p)), p in GPa; seed 002 Eq. 29 (see heat.hpp for the reading taken).
struct PressureConductivity {
  double a;  ///< [W/(m K)]
  double b;  ///< [1/GPa]
  double c;  ///< [1/GPa]
};
/// (a / s) (1 - b T_C), T_C in degC; seed 002 Eq. 30.
struct TemperatureConductivity {
  double a;  ///< [W/(m K)]
  double b;  ///< [1/K]
  double s;  ///< specific gravity at 15.6 degC [-]
};
using ConductivityLaw =
    std::variant<ConstantConductivity, PressureConductivity, TemperatureConductivity>;

struct ConstantHeatCapacity {
  double cp;  ///< [J/(kg K)]
};
/// (a + b T_C) / s^n, T_C in degC; seed 002 Eq. 31.
struct TemperatureHeatCapacity {
  double a;  ///< [J/(kg K)]
  double b;  ///< [J/(kg K2)]
  double s;  ///< specific gravity at 15.6 degC [-]
  double n;  ///< [-]
};
using HeatCapacityLaw = std::variant<ConstantHeatCapacity, TemperatureHeatCapacity>;

/// Where the numbers hold; outside, the result carries a warning.
struct ValidityRange {
  double T_min = 0.0;      ///< [K]
  double T_max = 1.0e4;    ///< [K]
  double p_max = 1.0e12;   ///< [Pa]
  double rate_max = 1e30;  ///< [1/s]
};

struct Oil {
  std::string name;
  TemperatureLaw temperature = ConstantViscosity{0.0};  ///< has to be given
  PressureLaw pressure = NoPressureEffect{};
  ShearLaw shear = NoShearThinning{};
  DensityLaw density = ConstantDensity{860.0};
  ConductivityLaw conductivity = ConstantConductivity{0.14};
  HeatCapacityLaw heat_capacity = ConstantHeatCapacity{2000.0};
  ValidityRange range;
  std::vector<std::string> assumed;  ///< statements on what is assumed, not known
};

}  // namespace shellback::rheology
