/// Temperatures at which the laws of an oil mean anything.
#include "rheology/laws_hold.hpp"

#include <catch2/catch.hpp>

using namespace shellback::rheology;

TEST_CASE("LawsHoldAboveThePoleAndAsLongAsThereIsMassAndHeat") {
  Oil vogel;
  vogel.temperature = Vogel{0.09521e-3, 896.4, 110.0};  // pole at -110 degC, 163.15 K
  CHECK(laws_hold(vogel, 313.15));
  CHECK(laws_hold(vogel, 713.15));
  CHECK_FALSE(laws_hold(vogel, 163.15));
  CHECK_FALSE(laws_hold(vogel, 163.0));
  CHECK_FALSE(laws_hold(vogel, 150.0));  // the formula gives a number there, of no meaning
  Oil swelling;
  swelling.temperature = ConstantViscosity{0.01};
  swelling.density = DowsonHigginson{860.0, 313.15, 4e-3};  // no mass from 250 K above on
  CHECK(laws_hold(swelling, 500.0));
  CHECK_FALSE(laws_hold(swelling, 564.0));
  Oil cold;
  cold.temperature = ConstantViscosity{0.01};
  cold.heat_capacity = TemperatureHeatCapacity{1630.0, 3.4, 0.88, 0.5};  // none below -479 degC
  CHECK(laws_hold(cold, 253.15));
  cold.heat_capacity = TemperatureHeatCapacity{1630.0, -3.4, 0.88, 0.5};
  CHECK_FALSE(laws_hold(cold, 273.15 + 480.0));
}
