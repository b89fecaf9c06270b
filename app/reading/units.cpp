#include "app/reading/units.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/reading/did_you_mean.hpp"

namespace shellback::app {
namespace {

constexpr int kLargestPower = 9;  ///< no physical unit needs more

constexpr std::array kKinds{kLength,
                            kAngle,
                            kSpeed,
                            kForce,
                            kTorque,
                            kPressure,
                            kTemperature,
                            kPerKelvin,
                            kPerPressure,
                            kViscosity,
                            kKinematicViscosity,
                            kTime,
                            kShearRate,
                            kDensity,
                            kConductivity,
                            kHeatCapacity,
                            kHeatTransfer,
                            kFlow,
                            kPower,
                            kHeatCapacitySlope,
                            kMass,
                            kMassMoment,
                            kVolume,
                            kNumber};

/// What a dimension is called; null: nothing that a case or a table names.
const char* quantity_of(const Dimension& dimension) {
  for (const Kind& kind : kKinds) {
    if (kind.dimension == dimension) return kind.name;
  }
  return nullptr;
}

std::string dimension_name(const Dimension& dimension) {
  const char* name = quantity_of(dimension);
  return name != nullptr ? name : "another quantity";
}

std::string cure(const Kind& kind) {
  return fmt::format("units that would do: {}; for example \"{}\"", kind.units, kind.example);
}

/// For symbols that many write for another unit; nothing for others.
std::string usual_hint(std::string_view symbol) {
  if (symbol == "kgf" || symbol == "kp") return "; one kilogram-force is 9.80665 N";
  if (symbol == "gf" || symbol == "tf") return "; forces are in N, kN, MN or lbf";
  if (symbol == "bara" || symbol == "barA" || symbol == "psia") {
    return fmt::format("; pressures are counted from ambient: subtract {}",
                       symbol == "psia" ? "14.696 and write psi" : "1.01325 and write bar");
  }
  if (symbol == "barg" || symbol == "barG")
    return "; pressures are counted from ambient: write bar";
  if (symbol == "psig") return "; pressures are counted from ambient: write psi";
  if (symbol == "F") return "; did you mean \"K\" or \"degC\" (Fahrenheit is \"degF\")?";
  if (symbol == "ppm") return "; one ppm is 1e-6";
  if (symbol == "C") return "; did you mean \"degC\" or \"K\"?";
  return "";
}

void raise(Dimension& d, int power) {
  d.length *= power;
  d.mass *= power;
  d.time *= power;
  d.temperature *= power;
  d.angle *= power;
}

void multiply(Unit& product, const Unit& by, int sign) {
  product.factor *= sign > 0 ? by.factor : 1.0 / by.factor;
  product.dimension.length += sign * by.dimension.length;
  product.dimension.mass += sign * by.dimension.mass;
  product.dimension.time += sign * by.dimension.time;
  product.dimension.temperature += sign * by.dimension.temperature;
  product.dimension.angle += sign * by.dimension.angle;
}

/// Recursive descent over: product := power { [*|·| ] power | / power }, power := factor [n],
/// factor := symbol | 1 before a / | ( product ).
class UnitParser {
 public:
  UnitParser(std::string_view text, const Kind& kind) : text_(text), kind_(kind) {}

  Unit parse() {
    const Unit unit = product(0);
    if (at_ < text_.size()) fail(fmt::format("unexpected {}", in_quotes(text_.substr(at_))));
    return unit;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw UnitError(
        fmt::format("cannot read the unit {} ({}); {}", in_quotes(text_), why, cure(kind_)));
  }

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  bool take(std::string_view token) {
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }

  Unit product(int depth) {
    constexpr int kDeepest = 4;  // brackets within brackets; more is no unit
    if (depth > kDeepest) fail("too many brackets");
    Unit result = power(depth);
    bool divided = false;
    for (;;) {
      skip_blanks();
      if (at_ >= text_.size() || text_[at_] == ')') return result;
      if (take("/")) {
        skip_blanks();
        multiply(result, power(depth), -1);
        divided = true;
        continue;
      }
      if (!take("*")) take("·");
      if (divided) fail("a product after \"/\" is ambiguous; use brackets, as in W/(m2 K)");
      skip_blanks();
      multiply(result, power(depth), +1);
    }
  }

  Unit power(int depth) {
    Unit unit = factor(depth);
    const int n = exponent();
    if (n != 1 && unit.scale) fail("a temperature scale has no powers; write K");
    raise(unit.dimension, n);
    unit.factor = std::pow(unit.factor, n);
    return unit;
  }

  Unit factor(int depth) {
    if (take("(")) {
      skip_blanks();
      const Unit inner = product(depth + 1);
      if (!take(")")) fail("a bracket is not closed");
      return inner;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_symbol(text_[at_])) ++at_;
    const std::string_view symbol = text_.substr(begin, at_ - begin);
    if (symbol.empty()) {
      if (one_before_slash()) return {};
      fail(at_ < text_.size() ? fmt::format("unexpected {}", in_quotes(text_.substr(at_)))
                              : "it ends too early");
    }
    return known(symbol, begin);
  }

  /// Any other number is a second one behind that of the value.
  bool one_before_slash() {
    const std::size_t begin = at_;
    if (take("1")) {
      skip_blanks();
      if (text_.substr(at_).starts_with("/")) return true;
    }
    at_ = begin;
    return false;
  }

  Unit known(std::string_view symbol, std::size_t begin) {
    const bool alone = begin == 0 && at_ == text_.size();
    const auto unit = find_unit(symbol);
    if (!unit) {
      const std::string hint = usual_hint(symbol);
      throw UnitError(fmt::format("unknown unit {}{}; {}", in_quotes(symbol),
                                  hint.empty() ? did_you_mean(symbol, meant(alone)) : hint,
                                  cure(kind_)));
    }
    if (unit->scale && !alone) {
      throw UnitError(
          fmt::format("{} is a temperature with its own zero and cannot be part of "
                      "a unit; write K in its place",
                      symbol));
    }
    return *unit;
  }

  /// Symbols that may stand here: of the quantity that is wanted, or any as a part of a product.
  [[nodiscard]] std::vector<std::string> meant(bool alone) const {
    std::vector<std::string> symbols = unit_symbols();
    std::erase_if(symbols, [&](const std::string& symbol) {
      return alone && find_unit(symbol)->dimension != kind_.dimension;
    });
    return symbols;
  }

  /// Letters, % and every byte of a non-ASCII character, except the dot and the superscripts.
  [[nodiscard]] bool is_symbol(char c) const {
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with("·") || rest.starts_with("²") || rest.starts_with("³") ||
        rest.starts_with("⁻")) {
      return false;
    }
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '%' ||
           static_cast<unsigned char>(c) >= 0x80U;
  }

  int exponent() {
    if (take("²")) return 2;
    if (take("³")) return 3;
    if (take("⁻¹")) return -1;
    const bool marked = take("^");
    const bool minus = take("-");
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    if (begin == at_) {
      if (marked || minus) fail("a power is missing");
      return 1;
    }
    int n = 0;
    std::from_chars(text_.data() + begin, text_.data() + at_, n);
    if (at_ - begin > 1 || n > kLargestPower || n == 0) fail("such a power makes no unit");
    return minus ? -n : n;
  }

  std::string_view text_;
  const Kind& kind_;
  std::size_t at_ = 0;
};

/// The number at the front of `text` and the rest behind it.
std::pair<double, std::string_view> split_number(std::string_view text, const Kind& kind) {
  std::string_view body = text;
  constexpr std::string_view kMinus = "\u2212";  // as pages print it
  const bool minus = body.starts_with(kMinus);
  if (minus) body.remove_prefix(kMinus.size());
  if (minus && (body.starts_with("-") || body.starts_with("+"))) {
    throw UnitError(fmt::format("{} has two signs", in_quotes(text)));
  }
  if (body.starts_with("+")) body.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), number);
  if (error == std::errc::result_out_of_range) {
    throw UnitError(fmt::format("{} is not a number that can be computed with (out of range)",
                                in_quotes(text)));
  }
  if (error != std::errc{}) {
    throw UnitError(
        fmt::format("{} does not begin with a number; {}", in_quotes(text), cure(kind)));
  }
  if (!std::isfinite(number)) {
    throw UnitError(fmt::format("{} is not a finite number; give {}", in_quotes(text), kind.name));
  }
  std::string_view rest = body.substr(static_cast<std::size_t>(end - body.data()));
  if (rest.starts_with(",")) {
    throw UnitError(
        fmt::format("{} has a comma; write the decimals after a point", in_quotes(text)));
  }
  return {minus ? -number : number, trimmed(rest)};
}

void check_dimension(std::string_view unit_text, const Unit& unit, const Kind& kind) {
  if (unit.dimension == kind.dimension) return;
  const bool reciprocal_time = unit.dimension == kShearRate.dimension;
  if (kind.dimension == kSpeed.dimension && reciprocal_time) {
    throw UnitError(
        fmt::format("\"{}\" leaves open whether revolutions or radians are meant; "
                    "write rpm, Hz (revolutions per second) or rad/s",
                    unit_text));
  }
  throw UnitError(fmt::format("\"{}\" is the unit of {}, but {} is wanted; {}", unit_text,
                              dimension_name(unit.dimension), kind.name, cure(kind)));
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  // Pages and word processors write blanks that no line breaks at (U+00A0, U+202F) and thin ones.
  constexpr std::string_view kBlanks[]{" ", "\t", "\u00a0", "\u202f", "\u2009"};
  for (bool more = true; more;) {
    more = false;
    for (const std::string_view blank : kBlanks) {
      if (text.starts_with(blank)) text.remove_prefix(blank.size()), more = true;
      if (text.ends_with(blank)) text.remove_suffix(blank.size()), more = true;
    }
  }
  return text;
}

double parse_quantity(std::string_view text, const Kind& kind) {
  const auto [number, unit_text] = split_number(trimmed(text), kind);
  const bool plain = kind.dimension == Dimension{};
  if (unit_text.empty()) {
    if (plain) return number;
    throw UnitError(
        fmt::format("{} has no unit ({} is wanted); {}", in_quotes(text), kind.name, cure(kind)));
  }
  const Unit unit = UnitParser(unit_text, kind).parse();
  check_dimension(unit_text, unit, kind);
  if (unit.scale && !kind.absolute) {
    throw UnitError(fmt::format("{} names a temperature, but a difference is wanted; write K",
                                in_quotes(text)));
  }
  const double value = number * unit.factor + (kind.absolute ? unit.offset : 0.0);
  if (!std::isfinite(value)) {
    throw UnitError(fmt::format("{} is not a finite number; give {}", in_quotes(text), kind.name));
  }
  return value;
}

std::optional<NumberAndUnit> number_in_front(std::string_view text) {
  try {
    const auto [number, unit] = split_number(trimmed(text), kNumber);
    return NumberAndUnit{number, std::string(unit)};
  } catch (const UnitError&) {
    return std::nullopt;
  }
}

std::optional<NumberAndUnit> number_and_unit(std::string_view text) {
  const auto apart = number_in_front(text);
  if (!apart || apart->unit.empty()) return apart;
  try {
    if (quantity_of(UnitParser(apart->unit, kNumber).parse().dimension)) return apart;
  } catch (const UnitError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

double unit_factor(std::string_view unit_text, const Kind& kind) {
  if (trimmed(unit_text) == "1" && kind.dimension == Dimension{}) return 1.0;
  const Unit unit = UnitParser(trimmed(unit_text), kind).parse();
  check_dimension(unit_text, unit, kind);
  if (unit.scale) {
    throw UnitError(fmt::format("{} is a temperature with its own zero; write K", unit_text));
  }
  return unit.factor;
}

std::string show(double value, std::string_view unit_text, const Kind& kind) {
  const Unit unit = UnitParser(unit_text, kind).parse();
  return fmt::format("{:.4g} {}", (value - unit.offset) / unit.factor, unit_text);
}

}  // namespace shellback::app
