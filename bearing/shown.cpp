#include "bearing/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

/// SI value = factor * number + offset.
struct Unit {
  std::string_view name;
  double factor;
  double offset = 0.0;
};

constexpr Unit kUnits[] = {{"um", 1e-6},
                           {"mm", 1e-3},
                           {"mPa s", 1e-3},
                           {"Pa s", 1.0},
                           {"Pa", 1.0},
                           {"bar", 1e5},
                           {"MPa", 1e6},
                           {"GPa", 1e9},
                           {"degC", 1.0, kZeroCelsius},
                           {"deg", kPi / 180.0},
                           {"N", 1.0},
                           {"N m", 1.0},
                           {"rad/s", 1.0},
                           {"K", 1.0},
                           {"s", 1.0},
                           {"1/s", 1.0},
                           {"1/K", 1.0},
                           {"1/Pa", 1.0},
                           {"1/GPa", 1.0},
                           {"kg/m3", 1.0},
                           {"W/(m K)", 1.0},
                           {"W/(m2 K)", 1.0},
                           {"J/(kg K)", 1.0},
                           {"J/(kg K2)", 1.0},
                           {"m3", 1.0},
                           {"l", 1e-3},
                           {"m3/s", 1.0},
                           {"", 1.0}};

}  // namespace

std::string shown(double value, std::string_view unit) {
  const Unit* known = std::find_if(std::begin(kUnits), std::end(kUnits),
                                   [&](const Unit& u) { return u.name == unit; });
  EXPECTS(known != std::end(kUnits));
  const double number = (value - known->offset) / known->factor;
  return unit.empty() ? fmt::format("{:.4g}", number) : fmt::format("{:.4g} {}", number, unit);
}

}  // namespace shellback::bearing
