#include "app/reading/unit_table.hpp"

#include <algorithm>
#include <array>

#include "core/constants.hpp"

namespace shellback::app {
namespace {

struct Prefix {
  std::string_view symbol;
  double factor;
};
constexpr std::array<Prefix, 9> kPrefixes{{{"n", 1e-9},
                                           {"u", 1e-6},
                                           {"µ", 1e-6},  // U+00B5 micro sign
                                           {"μ", 1e-6},  // U+03BC Greek letter
                                           {"m", 1e-3},
                                           {"c", 1e-2},
                                           {"k", 1e3},
                                           {"M", 1e6},
                                           {"G", 1e9}}};

constexpr double kInch = 0.0254;                        ///< [m], definition
constexpr double kPoundForce = 4.4482216152605;         ///< [N], 0.45359237 kg * 9.80665 m/s2
constexpr double kPsi = kPoundForce / (kInch * kInch);  ///< [Pa]
constexpr double kOneAtm = 101325.0;                    ///< [Pa], definition
constexpr double kFahrenheitZero = kZeroCelsius - 32.0 * 5.0 / 9.0;  ///< 0 degF [K]

constexpr Dimension kNone{};
constexpr Dimension kL{1, 0, 0, 0, 0};
constexpr Dimension kM{0, 1, 0, 0, 0};
constexpr Dimension kT{0, 0, 1, 0, 0};
constexpr Dimension kTheta{0, 0, 0, 1, 0};
constexpr Dimension kPhi{0, 0, 0, 0, 1};
constexpr Dimension kPhiPerTime{0, 0, -1, 0, 1};

struct Entry {
  std::string_view symbol;
  std::string_view prefixes;  ///< those in use, blank-separated
  Unit unit;
};

// One entry a unit, so a table (the prefixes are those that are in use, not all that exist).
const std::array kEntries{
    Entry{"m", "n u µ μ m c k", {1.0, kL}},
    Entry{"in", "", {kInch, kL}},
    Entry{"mil", "", {1e-3 * kInch, kL}},
    Entry{"l", "m", {1e-3, {3, 0, 0, 0, 0}}},
    Entry{"L", "m", {1e-3, {3, 0, 0, 0, 0}}},
    Entry{"deg", "", {kPi / 180.0, kPhi}},
    Entry{"°", "", {kPi / 180.0, kPhi}},
    Entry{"rad", "m u µ μ", {1.0, kPhi}},
    Entry{"rev", "", {2.0 * kPi, kPhi}},
    Entry{"rpm", "", {2.0 * kPi / 60.0, kPhiPerTime}},
    Entry{"Hz", "k", {2.0 * kPi, kPhiPerTime}},
    Entry{"s", "n u µ μ m", {1.0, kT}},
    Entry{"min", "", {60.0, kT}},
    Entry{"h", "", {3600.0, kT}},
    Entry{"g", "m k", {1e-3, kM}},
    Entry{"N", "m k M", {1.0, {1, 1, -2, 0, 0}}},
    Entry{"lbf", "", {kPoundForce, {1, 1, -2, 0, 0}}},
    Entry{"Nm", "m k", {1.0, {2, 1, -2, 0, 0}}},
    Entry{"Pa", "m k M G", {1.0, {-1, 1, -2, 0, 0}}},
    Entry{"Pas", "m", {1.0, {-1, 1, -1, 0, 0}}},
    Entry{"bar", "m", {1e5, {-1, 1, -2, 0, 0}}},
    Entry{"psi", "k", {kPsi, {-1, 1, -2, 0, 0}}},
    Entry{"ksi", "", {1e3 * kPsi, {-1, 1, -2, 0, 0}}},
    Entry{"atm", "", {kOneAtm, {-1, 1, -2, 0, 0}}},
    Entry{"P", "c", {0.1, {-1, 1, -1, 0, 0}}},
    Entry{"St", "c", {1e-4, {2, 0, -1, 0, 0}}},
    Entry{"J", "m k M", {1.0, {2, 1, -2, 0, 0}}},
    Entry{"W", "m k M", {1.0, {2, 1, -3, 0, 0}}},
    Entry{"K", "m", {1.0, kTheta}},
    Entry{"degC", "", {1.0, kTheta, kZeroCelsius, true}},
    Entry{"°C", "", {1.0, kTheta, kZeroCelsius, true}},
    Entry{"degF", "", {5.0 / 9.0, kTheta, kFahrenheitZero, true}},
    Entry{"°F", "", {5.0 / 9.0, kTheta, kFahrenheitZero, true}},
    Entry{"%", "", {0.01, kNone}},
};

/// Whether the list of the entry's prefixes holds this one as a whole word.
bool takes(const Entry& entry, std::string_view prefix) {
  std::string_view list = entry.prefixes;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    if (list.substr(0, end) == prefix) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

std::optional<Unit> prefixed(std::string_view symbol, const Prefix& prefix) {
  if (!symbol.starts_with(prefix.symbol)) return std::nullopt;
  const std::string_view rest = symbol.substr(prefix.symbol.size());
  for (const Entry& entry : kEntries) {
    if (entry.symbol == rest && takes(entry, prefix.symbol)) {
      return Unit{entry.unit.factor * prefix.factor, entry.unit.dimension};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Unit> find_unit(std::string_view symbol) {
  for (const Entry& entry : kEntries) {
    if (entry.symbol == symbol) return entry.unit;
  }
  for (const Prefix& prefix : kPrefixes) {
    if (const auto unit = prefixed(symbol, prefix)) return unit;
  }
  return std::nullopt;
}

std::vector<std::string> unit_symbols() {
  std::vector<std::string> symbols;
  for (const Entry& entry : kEntries) {
    symbols.emplace_back(entry.symbol);
    for (const Prefix& prefix : kPrefixes) {
      if (takes(entry, prefix.symbol)) {
        symbols.push_back(std::string(prefix.symbol) + std::string(entry.symbol));
      }
    }
  }
  return symbols;
}

}  // namespace shellback::app
