#pragma once
/// Numbers of nature and of unit definitions.
namespace shellback {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kRpm = kPi / 30.0;      ///< one revolution per minute [rad/s]
inline constexpr double kZeroCelsius = 273.15;  ///< 0 degC [K], definition of the Celsius scale

}  // namespace shellback
