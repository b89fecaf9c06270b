#pragma once
/// Values with units, as engineers write them: "23.9 um", "500 W/(m2 K)", "9.5e-9 1/Pa".
///
/// A unit is a product (blank, `*` or `·`) or quotient (`/`) of named units with integer powers
/// (m2, m^2, m², s-1). After a quotient a product needs brackets, as in "W/(m2 K)". Values come
/// out in SI, kelvin, radians. An angle counts as a dimension of its own, so that revolutions
/// and plain reciprocal seconds cannot be mistaken for one another. degC and degF name a
/// temperature only, never a difference.
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/reading/unit_table.hpp"

namespace shellback::app {

/// What a case-file value is, and how to write it.
struct Kind {
  const char* name;  ///< with article: "a length"
  Dimension dimension;
  const char* units;      ///< units that would do: "um, mm, m, in"
  const char* example;    ///< a complete value: "10 mm"
  bool absolute = false;  ///< a temperature (with a zero), not a difference
  /// The same kind with an example that suits one key: "0.3 um" of a roughness.
  [[nodiscard]] constexpr Kind such_as(const char* other) const {
    Kind kind = *this;
    kind.example = other;
    return kind;
  }
};

inline constexpr Kind kLength{"a length", {1, 0, 0, 0, 0}, "um, mm, cm, m, in", "10 mm"};
inline constexpr Kind kAngle{"an angle", {0, 0, 0, 0, 1}, "deg, rad, mrad", "90 deg"};
inline constexpr Kind kSpeed{"a rotational speed", {0, 0, -1, 0, 1}, "rpm, rad/s, Hz", "3000 rpm"};
inline constexpr Kind kForce{"a force", {1, 1, -2, 0, 0}, "N, kN, MN, lbf", "8 kN"};
inline constexpr Kind kMass{"a mass", {0, 1, 0, 0, 0}, "kg, g", "1.2 kg"};
inline constexpr Kind kMassMoment{
    "a mass times a distance", {1, 1, 0, 0, 0}, "kg m, kg mm, g m", "0.2 kg m"};
inline constexpr Kind kTorque{"a moment", {2, 1, -2, 0, 0}, "N m, N mm, kN m", "1.06 N m"};
inline constexpr Kind kPressure{
    "a pressure", {-1, 1, -2, 0, 0}, "Pa, kPa, MPa, GPa, bar, psi", "2 bar"};
inline constexpr Kind kTemperature{
    "a temperature", {0, 0, 0, 1, 0}, "degC, K, degF", "95 degC", true};
inline constexpr Kind kTemperatureDifference{
    "a temperature difference", {0, 0, 0, 1, 0}, "K", "896.4 K"};
inline constexpr Kind kPerKelvin{"a temperature coefficient", {0, 0, 0, -1, 0}, "1/K", "0.03 1/K"};
inline constexpr Kind kPerPressure{
    "a pressure coefficient", {1, -1, 2, 0, 0}, "1/Pa, 1/MPa, 1/GPa", "9.5e-9 1/Pa"};
inline constexpr Kind kViscosity{
    "a dynamic viscosity", {-1, 1, -1, 0, 0}, "mPa s, Pa s, cP", "8 mPa s"};
inline constexpr Kind kKinematicViscosity{
    "a kinematic viscosity", {2, 0, -1, 0, 0}, "cSt, mm2/s", "32 cSt"};
inline constexpr Kind kTime{"a time", {0, 0, 1, 0, 0}, "s, ms, us, min", "200 s"};
inline constexpr Kind kShearRate{"a shear rate", {0, 0, -1, 0, 0}, "1/s", "1e6 1/s"};
inline constexpr Kind kDensity{"a density", {-3, 1, 0, 0, 0}, "kg/m3, g/cm3, kg/l", "860 kg/m3"};
inline constexpr Kind kConductivity{
    "a thermal conductivity", {1, 1, -3, -1, 0}, "W/(m K)", "0.14 W/(m K)"};
inline constexpr Kind kHeatCapacity{
    "a specific heat capacity", {2, 0, -2, -1, 0}, "J/(kg K), kJ/(kg K)", "2000 J/(kg K)"};
inline constexpr Kind kHeatCapacitySlope{
    "a slope of specific heat capacity", {2, 0, -2, -2, 0}, "J/(kg K2)", "3.4 J/(kg K2)"};
inline constexpr Kind kHeatTransfer{
    "a heat transfer coefficient", {0, 1, -3, -1, 0}, "W/(m2 K)", "500 W/(m2 K)"};
inline constexpr Kind kVolume{"a volume", {3, 0, 0, 0, 0}, "cm3, l, m3", "20 cm3"};
inline constexpr Kind kFlow{"a volume flow", {3, 0, -1, 0, 0}, "l/min, m3/s, mm3/s", "0.5 l/min"};
inline constexpr Kind kPower{"a power", {2, 1, -3, 0, 0}, "W, kW", "300 W"};
inline constexpr Kind kNumber{"a plain number", {0, 0, 0, 0, 0}, "none, or %", "0.02"};

/// What is wrong with a value, and the cure; the reader adds the place.
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The SI value of `text`. A number of kind kNumber may stand without unit or with "%".
/// Throws UnitError: not a number, not finite, no unit, unknown unit, wrong dimension.
[[nodiscard]] double parse_quantity(std::string_view text, const Kind& kind);

/// A number and what stands behind it, without the blanks around: "2.5 um" -> 2.5, "um".
struct NumberAndUnit {
  double number = 0.0;
  std::string unit;  ///< may be empty
};

/// Without the blanks at its ends, those that pages and word processors write among them.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Nothing if no finite number stands in front; whatever follows is taken for its unit.
[[nodiscard]] std::optional<NumberAndUnit> number_in_front(std::string_view text);
/// The same, nothing if what follows is the unit of no quantity ("0W20", "1500rpm.csv").
[[nodiscard]] std::optional<NumberAndUnit> number_and_unit(std::string_view text);

/// The factor that turns a value in `unit` into SI ("um" -> 1e-6); "1" is the unit of plain
/// numbers. No offset: "degC" -> error. Throws UnitError if `unit` is unknown or not of the kind.
[[nodiscard]] double unit_factor(std::string_view unit, const Kind& kind);

/// `value` (SI) written in `unit` with about four digits: "23.9 um". For kTemperature the unit
/// may be degC.
[[nodiscard]] std::string show(double value, std::string_view unit, const Kind& kind);

}  // namespace shellback::app
