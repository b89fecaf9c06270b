#include "rheology/heat.hpp"

#include <catch2/catch.hpp>

#include "tests/rheology/oils.hpp"

using namespace shellback;
using namespace shellback::rheology;
using namespace shellback::rheology::test;

namespace {
const PressureConductivity kLarsson{0.137, 1.72, 0.54};              // seed 002 after Eq. 29
const TemperatureConductivity kByTemperature{0.12, 1.667e-4, 0.86};  // seed 002 after Eq. 30
const TemperatureHeatCapacity kByBlend{1630.0, 3.4, 0.86, 0.5};      // seed 002 after Eq. 31
}  // namespace

TEST_CASE("ConductivityDoublesWithinAGigapascal") {
  // Larsson's law doubles where b p = 1 + c p, at p = 1/(b - c) = 0.847 GPa.
  const double p = 1e9 / (1.72 - 0.54);
  CHECK(conductivity(kLarsson, 300.0, 0.0).k == 0.137);
  CHECK(conductivity(kLarsson, 300.0, p).k == Approx(2.0 * 0.137).epsilon(1e-14));
}

TEST_CASE("ThePrintedConstantsGiveAMineralOil") {
  // Textbook values of mineral oil at 40-100 degC: 0.12-0.15 W/(m K) and 1.8-2.3 kJ/(kg K). That
  // brackets the readings taken of Eq. 30 and 31 (units, degC, division by s).
  for (const double t : {40.0, 100.0}) {
    CHECK(conductivity(kByTemperature, celsius(t), 0.0).k > 0.12);
    CHECK(conductivity(kByTemperature, celsius(t), 0.0).k < 0.15);
    CHECK(heat_capacity(kByBlend, celsius(t)).cp > 1800.0);
    CHECK(heat_capacity(kByBlend, celsius(t)).cp < 2300.0);
  }
}

TEST_CASE("HeatLawSlopesAreTheDerivatives") {
  const double T = celsius(80.0);
  for (const ConductivityLaw& law : {ConductivityLaw{ConstantConductivity{0.14}},
                                     ConductivityLaw{kLarsson}, ConductivityLaw{kByTemperature}}) {
    Oil oil;
    oil.conductivity = law;
    for (const double p : {0.0, 2e8, 1e9}) {
      const auto by_T = [&](double t) { return conductivity(oil, t, p).k; };
      const auto by_p = [&](double q) { return conductivity(oil, T, q).k; };
      const Conductivity c = conductivity(oil, T, p);
      CHECK(c.dT == Approx(central_difference(by_T, T, 1e-1)).epsilon(kDerivativeTolerance));
      CHECK(c.dp == Approx(central_difference(by_p, p, 1e5)).epsilon(kDerivativeTolerance));
    }
  }
  for (const HeatCapacityLaw& law :
       {HeatCapacityLaw{ConstantHeatCapacity{2083.0}}, HeatCapacityLaw{kByBlend}}) {
    Oil oil;
    oil.heat_capacity = law;
    const auto by_T = [&](double t) { return heat_capacity(oil, t).cp; };
    CHECK(heat_capacity(oil, T).dT ==
          Approx(central_difference(by_T, T, 1e-1)).epsilon(kDerivativeTolerance));
  }
}
