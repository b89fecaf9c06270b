#include <cmath>

#include "app/reading/sections.hpp"
#include "core/constants.hpp"
#include "rheology/temperature.hpp"

namespace shellback::app {
namespace {

using namespace rheology;

/// Cameron's usual constant of the Vogel law [K] (textbook): two points then fix A and B.
constexpr double kCameron = 95.0;

/// The Vogel law through (T1, eta1) and (T2, eta2) for a given C.
Vogel through_two_points(const Section& law) {
  law.only({"law", "eta1", "T1", "eta2", "T2", "C"}, "a viscosity law \"two-point\"");
  const double eta1 = law.quantity("eta1", kViscosity, kPositive);
  const double eta2 = law.quantity("eta2", kViscosity, kPositive);
  const double T1 = law.quantity("T1", kTemperature) - kZeroCelsius;
  const double T2 = law.quantity("T2", kTemperature) - kZeroCelsius;
  const double C = law.quantity_or("C", kTemperatureDifference.such_as("95 K"), kCameron,
                                   "oil: the two viscosities are joined by a Vogel law with "
                                   "C = 95 K");
  if (T1 == T2) law.fail("T2", "the two temperatures are the same");
  if ((eta1 - eta2) * (T1 - T2) >= 0.0) {
    law.fail("eta2", "the viscosity does not fall from the colder to the warmer point");
  }
  if (T1 + C <= 0.0 || T2 + C <= 0.0) law.fail("C", "the law is not defined below -C degC");
  const double B = std::log(eta1 / eta2) / (1.0 / (T1 + C) - 1.0 / (T2 + C));
  return {eta1 * std::exp(-B / (T1 + C)), B, C};
}

/// ASTM D341 through (T1, nu1) and (T2, nu2), times the density.
Walther of_kinematic_viscosities(const Section& law, const DensityLaw& density) {
  constexpr double kPerSquareMillimetre = 1e6, kLeast = 2.0;  // [mm2/s], where D341 begins
  law.only({"law", "nu1", "T1", "nu2", "T2"}, "a viscosity law \"walther\"");
  const auto kinematic = [&](const char* key) {
    const double nu = kPerSquareMillimetre * law.quantity(key, kKinematicViscosity, kPositive);
    if (nu < kLeast) law.fail(key, "the law (ASTM D341) holds from 2 mm2/s on");
    return nu;
  };
  const double nu1 = kinematic("nu1"), nu2 = kinematic("nu2");
  const double T1 = law.quantity("T1", kTemperature), T2 = law.quantity("T2", kTemperature);
  if (T1 == T2) law.fail("T2", "the two temperatures are the same");
  if ((nu1 - nu2) * (T1 - T2) >= 0.0) {
    law.fail("nu2", "the viscosity does not fall from the colder to the warmer point");
  }
  Walther walther = walther_through(nu1, T1, nu2, T2);
  if (const auto* changing = std::get_if<DowsonHigginson>(&density)) {
    walther.rho = changing->rho0;
    walther.at = changing->at;
    walther.expansivity = changing->expansivity;
  } else {
    walther.rho = std::get<ConstantDensity>(density).rho;
  }
  return walther;
}

}  // namespace

TemperatureLaw read_temperature_law(const Section& law, const DensityLaw& density) {
  enum class Law { constant, vogel, reynolds, two_point, walther };
  const Law which = law.choice<Law>("law", {{"constant", Law::constant},
                                            {"vogel", Law::vogel},
                                            {"reynolds", Law::reynolds},
                                            {"two-point", Law::two_point},
                                            {"walther", Law::walther}});
  switch (which) {
    case Law::constant:
      law.only({"law", "eta"}, "a constant viscosity");
      return ConstantViscosity{law.quantity("eta", kViscosity, kPositive)};
    case Law::vogel:
      law.only({"law", "A", "B", "C"}, "a viscosity law \"vogel\"");
      return Vogel{law.quantity("A", kViscosity.such_as("0.1 mPa s"), kPositive),
                   law.quantity("B", kTemperatureDifference, kPositive),
                   law.quantity("C", kTemperatureDifference.such_as("95 K"), kPositive)};
    case Law::reynolds:
      law.only({"law", "eta", "at", "beta"}, "a viscosity law \"reynolds\"");
      return ReynoldsSlope{law.quantity("eta", kViscosity, kPositive),
                           law.quantity("at", kTemperature),
                           law.quantity("beta", kPerKelvin, kNotNegative)};
    case Law::two_point:
      return through_two_points(law);
    case Law::walther:
      break;
  }
  return of_kinematic_viscosities(law, density);
}

PressureLaw read_pressure_law(const Section& law) {
  enum class Law { none, barus, roelands, houpert };
  const Law which = law.choice<Law>("law", {{"none", Law::none},
                                            {"barus", Law::barus},
                                            {"roelands", Law::roelands},
                                            {"houpert", Law::houpert}});
  switch (which) {
    case Law::none:
      law.only({"law"}, "a pressure law \"none\"");
      return NoPressureEffect{};
    case Law::barus:
      law.only({"law", "alpha"}, "a pressure law \"barus\"");
      return Barus{law.quantity("alpha", kPerPressure, kPositive)};
    case Law::roelands:
      law.only({"law", "Z"}, "a pressure law \"roelands\"");
      return Roelands{law.quantity("Z", kNumber.such_as("0.6"), kPositive)};
    case Law::houpert:
      break;
  }
  law.only({"law", "Z", "beta", "at"}, "a pressure law \"houpert\"");
  return Houpert{law.quantity("Z", kNumber.such_as("0.6"), kPositive),
                 law.quantity("beta", kPerKelvin, kPositive), law.quantity("at", kTemperature)};
}

ShearLaw read_shear_law(const Section& law) {
  enum class Law { none, cross };
  const Law which = law.choice<Law>("law", {{"none", Law::none}, {"cross", Law::cross}});
  if (which == Law::none) {
    law.only({"law"}, "a shear law \"none\"");
    return NoShearThinning{};
  }
  law.only({"law", "r", "K", "m"}, "a shear law \"cross\"");
  return Cross{law.quantity("r", kNumber.such_as("0.5"), kUpToOne),
               law.quantity("K", kTime.such_as("4.5e-8 s"), kPositive),
               law.quantity("m", kNumber.such_as("0.5"), kPositive)};
}

}  // namespace shellback::app
