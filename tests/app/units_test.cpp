/// Units: definitions of the SI brochure and of the inch, pound-force and Fahrenheit scale.
#include "app/reading/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "app/reading/unit_table.hpp"
#include "core/constants.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

// Products of a few decimal factors: each rounds to half a unit in the last place.
constexpr double kOfConversion = 1e-14;

void check(const char* text, const Kind& kind, double expected) {
  INFO(text);
  CHECK(parse_quantity(text, kind) == Approx(expected).epsilon(kOfConversion).margin(1e-300));
}

std::string message(const char* text, const Kind& kind) {
  try {
    static_cast<void>(parse_quantity(text, kind));
  } catch (const UnitError& error) {
    return error.what();
  }
  return "";
}

void check_error(const char* text, const Kind& kind, const std::vector<std::string>& parts) {
  const std::string what = message(text, kind);
  INFO(text << " -> " << what);
  CHECK(!what.empty());
  for (const std::string& part : parts) CHECK(what.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("PrefixesScaleTheirUnits") {
  check("23.9 um", kLength, 23.9e-6);
  check("23.9 µm", kLength, 23.9e-6);
  check("23.9 μm", kLength, 23.9e-6);
  check("5 nm", kLength, 5e-9);
  check("47.8 mm", kLength, 0.0478);
  check("4.78 cm", kLength, 0.0478);
  check("1 km", kLength, 1000.0);
  check("8 kN", kForce, 8000.0);
  check("0.2 MN", kForce, 2e5);
  check("53.3 GPa", kPressure, 53.3e9);
  check("10 MPa", kPressure, 10e6);
  check("70 kPa", kPressure, 70e3);
  check("8 mPa s", kViscosity, 8e-3);
  check("45 ns", kTime, 45e-9);
  check("2 ms", kTime, 2e-3);
  check("3 us", kTime, 3e-6);
  check("0.1 mrad", kAngle, 1e-4);
  check("0.3 kW", kPower, 300.0);
  check("2 kJ/(kg K)", kHeatCapacity, 2000.0);
  check("1 kHz", kSpeed, 2.0 * kPi * 1000.0);
  check("500 mbar", kPressure, 5e4);
}

TEST_CASE("NamedUnitsHaveTheirDefinedValue") {
  check("1 in", kLength, 0.0254);
  check("1 lbf", kForce, 0.45359237 * 9.80665);
  // 1 psi = 1 lbf/in2; 6894.757293 Pa as printed in conversion tables (10 figures).
  CHECK(parse_quantity("1 psi", kPressure) == Approx(6894.757293).epsilon(1e-10));
  check("1 bar", kPressure, 1e5);
  check("1 cP", kViscosity, 1e-3);
  check("1 P", kViscosity, 0.1);
  check("1 l/min", kFlow, 1e-3 / 60.0);
  check("60 ml/min", kFlow, 1e-6);
  check("3.6 m3/h", kFlow, 1e-3);
  check("1 kg/l", kDensity, 1000.0);
  check("0.86 g/cm3", kDensity, 860.0);
  check("1 %", kNumber, 0.01);
  check("0.02", kNumber, 0.02);
}

TEST_CASE("ARevolutionIsTwoPi") {
  check("60 rpm", kSpeed, 2.0 * kPi);
  check("1 Hz", kSpeed, 2.0 * kPi);
  check("1 rev/s", kSpeed, 2.0 * kPi);
  check("60 rev/min", kSpeed, 2.0 * kPi);
  check("2 rad/s", kSpeed, 2.0);
  check("180 deg", kAngle, kPi);
  check("180 °", kAngle, kPi);
  check("-3000 rpm", kSpeed, -100.0 * kPi);
}

TEST_CASE("TemperaturesHaveAZeroAndDifferencesHaveNone") {
  check("95 degC", kTemperature, 368.15);
  check("95 °C", kTemperature, 368.15);
  check("368.15 K", kTemperature, 368.15);
  check("32 degF", kTemperature, 273.15);
  check("212 degF", kTemperature, 373.15);
  check("110 K", kTemperatureDifference, 110.0);
  check_error("110 degC", kTemperatureDifference, {"difference", "write K"});
  check_error("46 W/(m degC)", kConductivity, {"degC", "write K"});
}

TEST_CASE("CompoundUnitsMultiply") {
  check("500 W/(m2 K)", kHeatTransfer, 500.0);
  check("500 W/(m^2 K)", kHeatTransfer, 500.0);
  check("500 W/(m² K)", kHeatTransfer, 500.0);
  check("500 W/(m2*K)", kHeatTransfer, 500.0);
  check("500 W/m2/K", kHeatTransfer, 500.0);
  check("0.05 W/(cm2 K)", kHeatTransfer, 500.0);
  check("9.5e-9 1/Pa", kPerPressure, 9.5e-9);
  check("9.5e-9 Pa-1", kPerPressure, 9.5e-9);
  check("9.5 1/GPa", kPerPressure, 9.5e-9);
  check("1.06 N m", kTorque, 1.06);
  check("1.06 Nm", kTorque, 1.06);
  check("1.06 N·m", kTorque, 1.06);
  check("8 mPas", kViscosity, 8e-3);
  check("8e-3 N s/m2", kViscosity, 8e-3);
  check("8e-3 kg/(m s)", kViscosity, 8e-3);
  check("1e6 s⁻¹", kShearRate, 1e6);
  check("  1.5e3   mm  ", kLength, 1.5);
  check("+3 mm", kLength, 3e-3);
}

TEST_CASE("WhatIsShownReadsBackTheSame") {
  const std::vector<std::pair<Kind, const char*>> list{
      {kLength, "um"},       {kPressure, "bar"}, {kTemperature, "degC"}, {kSpeed, "rpm"},
      {kViscosity, "mPa s"}, {kTorque, "N m"},   {kFlow, "l/min"},       {kAngle, "deg"}};
  for (const auto& [kind, unit] : list) {
    const double value = 0.4321;  // four digits: `show` prints no more
    const double si = parse_quantity(fmt::format("{} {}", value, unit), kind);
    CHECK(show(si, unit, kind) == fmt::format("{} {}", value, unit));
  }
}

TEST_CASE("EveryUnitNamedAsACureIsKnown") {
  const std::vector<Kind> kinds{kLength,
                                kAngle,
                                kSpeed,
                                kForce,
                                kTorque,
                                kPressure,
                                kTemperature,
                                kTemperatureDifference,
                                kPerKelvin,
                                kPerPressure,
                                kViscosity,
                                kTime,
                                kShearRate,
                                kDensity,
                                kConductivity,
                                kHeatCapacity,
                                kHeatCapacitySlope,
                                kHeatTransfer,
                                kFlow,
                                kPower};
  for (const Kind& kind : kinds) {
    const std::string units = kind.units;
    std::size_t begin = 0;
    while (begin < units.size()) {
      const std::size_t end = std::min(units.find(", ", begin), units.size());
      const std::string value = "300 " + units.substr(begin, end - begin);
      INFO(kind.name << ": " << value);
      CHECK_NOTHROW(static_cast<void>(parse_quantity(value, kind)));
      begin = end + 2;
    }
    CHECK_NOTHROW(static_cast<void>(parse_quantity(kind.example, kind)));
  }
}

TEST_CASE("EverySymbolOfTheTableIsFound") {
  for (const std::string& symbol : unit_symbols()) {
    INFO(symbol);
    const auto unit = find_unit(symbol);
    REQUIRE(unit.has_value());
    CHECK(unit->factor > 0.0);
  }
}

TEST_CASE("AWrongDimensionIsRefusedByName") {
  check_error("3000 mm", kSpeed, {"\"mm\" is the unit of a length", "a rotational speed", "rpm"});
  check_error("8 kN", kTorque, {"a force", "a moment", "N m"});
  check_error("2 bar", kLength, {"a pressure", "a length"});
  check_error("5 mm", kNumber, {"a length", "a plain number"});
  check_error("50 1/s", kSpeed, {"revolutions or radians", "rpm"});
  check_error("1e6 Hz", kShearRate, {"a rotational speed", "1/s"});
}

TEST_CASE("AMissingOrMisspeltUnitIsRefusedWithACure") {
  check_error("23.9", kLength, {"no unit", "um, mm"});
  check_error("23.9 umm", kLength, {"unknown unit \"umm\"", "did you mean \"um\""});
  check_error("23.9 MM", kLength, {"unknown unit", "did you mean \"mm\""});
  check_error("2 Bar", kPressure, {"unknown unit", "did you mean \"bar\""});
  check_error("2 furlong", kLength, {"unknown unit \"furlong\"", "um, mm"});
}

TEST_CASE("AWrongNumberIsRefused") {
  check_error("", kLength, {"does not begin with a number"});
  check_error("mm", kLength, {"does not begin with a number"});
  check_error("23,9 um", kLength, {"comma", "point"});
  check_error("nan mm", kLength, {"not a finite number"});
  check_error("inf mm", kLength, {"not a finite number"});
  check_error("-inf mm", kLength, {"not a finite number"});
  check_error("1e999 mm", kLength, {"out of range"});
  check_error("1e308 km", kLength, {"not a finite number"});
  check_error("--3 mm", kLength, {"does not begin with a number"});
  check_error("0x10 mm", kLength, {"unit"});
}

TEST_CASE("AnUnreadableUnitIsRefused") {
  check_error("1 W/m2 K", kHeatTransfer, {"ambiguous", "W/(m2 K)"});
  check_error("1 W/(m2 K", kHeatTransfer, {"bracket"});
  check_error("1 W/m2 K)", kHeatTransfer, {"cannot read"});
  check_error("1 W/", kHeatTransfer, {"too early"});
  check_error("1 m^", kLength, {"power"});
  check_error("1 m99", kLength, {"power"});
  check_error("1 m0", kLength, {"power"});
  check_error("1 ((((((m))))))", kLength, {"brackets"});
  check_error("1 m;", kLength, {"cannot read"});
  check_error("1 \x01", kLength, {"cannot read"});
}

TEST_CASE("ALetterForAScaleOfTemperatureSuggestsKelvinAndDegrees") {
  check_error("180 F", kTemperature, {"unknown unit \"F\"", "\"K\"", "\"degC\""});
  check_error("5 bara", kPressure, {"unknown unit", "subtract 1.01325"});  // not "did you mean bar"
  check_error("5 psig", kPressure, {"unknown unit", "from ambient: write psi"});
  check_error("5 kgf", kForce, {"unknown unit \"kgf\"", "9.80665 N"});
  check_error("80 C", kTemperature, {"unknown unit \"C\"", "\"degC\"", "\"K\""});
  check_error("500 W/(m2 F)", kHeatTransfer, {"unknown unit \"F\"", "\"K\""});
}

TEST_CASE("ASecondNumberIsNoPartOfAUnit") {
  // "8 15 kN" for 8.15 kN was read as 8 times 1^5 kN.
  for (const char* slip : {"8 15 kN", "8 1 kN", "8 12 kN", "8 kN 1", "8 1"}) {
    CHECK_FALSE(message(slip, kForce).empty());
  }
  check_error("0.5 1 bar", kPressure, {"unexpected", "1 bar"});
  check_error("0.02 1", kNumber, {"unexpected"});
  check("9.5e-9 1/Pa", kPerPressure, 9.5e-9);
  check("9.5e-9 1 / Pa", kPerPressure, 9.5e-9);
  CHECK(unit_factor("1", kNumber) == 1.0);  // of a column of plain numbers
}

TEST_CASE("ANumberIsTakenApartFromItsUnitAlone") {
  const auto apart = [](const char* text) { return number_and_unit(text); };
  REQUIRE(apart(" 2.5 um "));
  CHECK(apart(" 2.5 um ")->number == 2.5);
  CHECK(apart(" 2.5 um ")->unit == "um");
  CHECK(apart("300deg")->unit == "deg");
  CHECK(apart("+4e3")->number == 4e3);
  CHECK(apart("500 W/(m2 K)")->unit == "W/(m2 K)");
  CHECK(apart("40 degC")->unit == "degC");
  for (const char* word : {"0W20", "0W-8", "1500rpm.csv", "0x10", "inf", "nan", "tehd", "", "8 15"})
    CHECK_FALSE(apart(word));
}

TEST_CASE("BlanksAndMinusOfPagesAreRead") {
  check("12\u00a0mm", kLength, 0.012);
  check("12\u202fmm", kLength, 0.012);
  check("\u221212 mm", kLength, -0.012);
  CHECK_FALSE(message("1\u00a0000 mm", kLength).empty());  // one thousand, or one and none?
  for (const char* slip : {"\u2212\u221212 mm", "\u2212-12 mm", "\u2212+12 mm", "-\u221212 mm"}) {
    CHECK_FALSE(message(slip, kLength).empty());
  }
}
