#include "app/labels/quantity_label.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bearing/friction_split.hpp"
#include "bearing/temperature_limits.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

constexpr double kPerMicro = 1e6;         ///< um per m
constexpr double kLitreMinutes = 6e4;     ///< l/min per m3/s
constexpr double kDegrees = 180.0 / kPi;  ///< deg per rad
constexpr double kThousandfold = 1000.0;  ///< from here on kW and kN are used
constexpr double kMega = 1e-6;            ///< MPa per Pa, MN per N

/// Part of the largest magnitude in its row (for a force: of both components) below which a value
/// is round-off and shown as 0 [-].
constexpr double kRoundOff = 1e-9;

std::optional<double> measured_si(const bearing::Measured& m, const std::string& name) {
  if (name == "friction_torque") return m.friction_torque;
  if (name == "h_min") return m.h_min;
  if (name == "p_max") return m.p_max;
  if (name == "side_flow") return m.side_flow;
  if (name == "eccentricity_ratio") return m.eccentricity_ratio;
  if (name == "T_shell_max") return m.T_shell_max;
  if (name == "T_shell_back") return m.shell_back_temperature;
  return std::nullopt;
}

/// True for a temperature that no oil has: the last iterate of a solve that failed tells nothing by
/// it.
bool beyond_oil(const bearing::Quantity& q) {
  return q.unit == "K" && q.name.starts_with("T_") &&
         !(q.value >= bearing::kColdestOil && q.value <= bearing::kHottestOil);
}

/// Largest magnitude of a quantity over the results; the components of a force count together, heat
/// with the power that it comes from.
double largest_magnitude(const std::vector<bearing::Result>& results, const std::string& name) {
  const bool force = name == "load_x" || name == "load_y";
  const bool heat = name.starts_with("heat_");
  double largest = 0.0;
  for (const auto& result : results) {
    for (const auto& q : result.quantities) {
      const bool counts = q.name == name || (force && (q.name == "load_x" || q.name == "load_y")) ||
                          (heat && q.name == "power_loss");
      if (counts && std::isfinite(q.value)) largest = std::max(largest, std::abs(q.value));
    }
  }
  return largest;
}

}  // namespace

std::string grid_words(const std::array<int, 2>& grid) {
  return grid[0] > 0 ? fmt::format("{} × {}", grid[0], grid[1]) : "none";
}

std::string duration_words(double t) {
  return t < 1.0 ? fmt::format("{:.4g} ms", 1e3 * t) : fmt::format("{:.4g} s", t);
}

namespace {

/// What a load cycle is: how long, and its largest load.
std::string cycle_words(const bearing::LoadCycle& cycle, const char* degree) {
  double largest = 0.0;
  for (std::size_t k = 0; k < cycle.t.size(); ++k) {
    largest = std::max(largest, std::hypot(cycle.x[k], cycle.y[k]));
  }
  const double length = cycle.repeats() ? cycle.period : cycle.t.empty() ? 0.0 : cycle.t.back();
  const std::string over =
      cycle.crank_speed > 0.0
          ? fmt::format("{:.4g}{}", length * cycle.crank_speed * kDegrees, degree)
          : duration_words(length);
  return fmt::format(", load {} over {}, largest load {:.4g} kN",
                     cycle.repeats() ? "cycle" : "event", over, largest / kThousandfold);
}

}  // namespace

std::optional<double> measured_value(const bearing::Measured& m, const bearing::Quantity& q) {
  const std::optional<double> si = measured_si(m, q.name);
  return si && q.name == "friction_torque" ? std::copysign(*si, q.value) : si;
}

std::optional<double> measured_torque(const bearing::Case& c) {
  if (!c.measured.friction_torque) return std::nullopt;
  return std::copysign(*c.measured.friction_torque, c.operation.omega);
}

std::string quantity_label(const std::string& name) {
  if (const auto* known = bearing::find_quantity(name)) return std::string(known->label);
  std::string words = name;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

DisplayUnit display_unit(const std::string& name, const std::string& si_unit, double largest) {
  if (si_unit == "m") return {"um", kPerMicro, 0.0};
  if (si_unit == "Pa") return {"MPa", kMega, 0.0};
  if (si_unit == "K" && name.starts_with("T_")) return {"degC", 1.0, kZeroCelsius};
  if (si_unit == "W" && largest >= kThousandfold) return {"kW", 1.0 / kThousandfold, 0.0};
  if (si_unit == "N" && largest >= kThousandfold) return {"kN", 1.0 / kThousandfold, 0.0};
  if (si_unit == "N/m") return {"MN/m", kMega, 0.0};
  if (si_unit == "N s/m") return {"kN s/m", 1.0 / kThousandfold, 0.0};
  if (si_unit == "m3/s") return {"l/min", kLitreMinutes, 0.0};
  if (si_unit == "rad" && name.starts_with("tilt")) return {"mrad", kThousandfold, 0.0};
  if (si_unit == "rad") return {"deg", kDegrees, 0.0};
  if (si_unit == "rad/s") return {"rpm", 1.0 / kRpm, 0.0};
  if (name == "asperity_load_share") return {"%", 100.0, 0.0};
  return {si_unit == "1" ? "-" : si_unit, 1.0, 0.0};
}

std::string typeset_unit(const std::string& unit) {
  using Pair = std::pair<const char*, const char*>;
  constexpr std::array pairs{Pair{"um", "µm"},   Pair{"degC", "°C"},   Pair{"deg", "°"},
                             Pair{"N m", "N·m"}, Pair{"m3/s", "m³/s"}, Pair{"-", "–"}};
  for (const auto& [plain, set] : pairs) {
    if (unit == plain) return set;
  }
  return unit;
}

std::string figures(double value, int digits) {
  if (!std::isfinite(value)) return "n/a";
  if (value == 0.0) return "0";
  const std::string rounded = fmt::format("{:.{}e}", value, digits - 1);
  const int exponent = std::stoi(rounded.substr(rounded.find('e') + 1));
  if (exponent < -4 || exponent >= 6) return rounded;
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent));
}

std::vector<QuantityRow> quantity_rows(const bearing::Measured& measured,
                                       const std::vector<bearing::Result>& results) {
  std::vector<QuantityRow> rows;
  for (const auto& result : results) {
    for (const auto& quantity : result.quantities) {
      const auto same = [&](const auto& row) { return row.name == quantity.name; };
      if (std::any_of(rows.begin(), rows.end(), same)) continue;
      const double largest = largest_magnitude(results, quantity.name);
      QuantityRow row{quantity.name,
                      quantity_label(quantity.name),
                      display_unit(quantity.name, quantity.unit, largest),
                      {},
                      {}};
      for (const auto& other : results) {
        const auto* q = quantity_in(other.quantities, quantity.name);
        const bool lost = q && !other.verdict.good() && beyond_oil(*q);
        const bool round_off = q && std::abs(q->value) < kRoundOff * largest;
        row.values.push_back(q && !lost ? std::optional(round_off ? 0.0 : row.unit(q->value))
                                        : std::nullopt);
        const auto bar = [&](double x) {
          return std::abs(x) < kRoundOff * largest ? 0.0 : row.unit.scale * x;
        };
        row.bars.push_back(q ? ShownBars{bar(q->error_grid), bar(q->error_model), bar(q->error()),
                                         row.unit(round_off ? NAN : q->limit), bar(q->error_time)}
                             : ShownBars{NAN, NAN, NAN, NAN, 0.0});
      }
      if (const auto si = measured_value(measured, quantity)) row.measured = row.unit(*si);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

bool has_bars(const QuantityRow& row) {
  return std::any_of(row.bars.begin(), row.bars.end(),
                     [](const ShownBars& b) { return std::isfinite(b.total); });
}

std::string bar_figures(double bar) {
  return std::isfinite(bar) ? "+-" + figures(std::abs(bar), 2) : "";
}

std::vector<std::string> column_names(const std::vector<bearing::Result>& results) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto same = [&](const auto& r) { return r.tier == results[i].tier; };
    const auto before = std::count_if(results.begin(), results.begin() + i, same);
    const auto all = std::count_if(results.begin(), results.end(), same);
    const std::string tier = to_string(results[i].tier);
    names.push_back(all > 1 ? fmt::format("{} {}", tier, before + 1) : tier);
  }
  return names;
}

std::vector<std::string> lines_of_columns(
    const std::vector<bearing::Result>& results,
    const std::function<std::vector<std::string>(const bearing::Result&)>& lines_of) {
  const std::vector<std::string> names = column_names(results);
  std::vector<std::string> lines;
  std::vector<std::vector<std::string>> of;  // columns that have the line
  for (std::size_t k = 0; k < results.size(); ++k) {
    for (const std::string& line : lines_of(results[k])) {
      const auto at = std::find(lines.begin(), lines.end(), line) - lines.begin();
      if (at == static_cast<std::ptrdiff_t>(lines.size())) {
        lines.push_back(line);
        of.emplace_back();
      }
      auto& columns = of[static_cast<std::size_t>(at)];
      if (columns.empty() || columns.back() != names[k]) columns.push_back(names[k]);
    }
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (of[k].size() == names.size()) continue;
    lines[k] = fmt::format("{}: {}", fmt::join(of[k], ", "), lines[k]);
  }
  return lines;
}

std::string difference(const DisplayUnit& unit, double value, double reference) {
  if (!std::isfinite(value) || !std::isfinite(reference)) return "n/a";
  if (unit.unit == "degC") return fmt::format("{:+.1f} K", value - reference);
  if (reference == 0.0) return "n/a";
  return fmt::format("{:+.1f} %", 100.0 * (value / reference - 1.0));
}

std::string status_line(const bearing::Result& result) {
  if (result.verdict.good()) {
    const auto* T = quantity_in(result.quantities, "T_film_max");
    const bool burnt = T != nullptr && T->value > bearing::kHottestOil;
    return burnt ? "converged, with a film hotter than any oil survives" : "converged";
  }
  return fmt::format("NOT CONVERGED: {}", to_string(result.verdict.status));
}

std::string speed_words(const bearing::Case& c) {
  if (!c.cycle || c.cycle->omega.empty()) {
    return fmt::format("{:.4g} rpm", c.operation.omega / kRpm);
  }
  const auto [low, high] = std::minmax_element(c.cycle->omega.begin(), c.cycle->omega.end());
  if (*low == *high) return fmt::format("{:.4g} rpm", *low / kRpm);
  return fmt::format("{:.4g} to {:.4g} rpm", *low / kRpm, *high / kRpm);
}

std::string describe_case(const bearing::Case& c, Writing writing) {
  const bool set = writing == Writing::typeset;
  const char* times = set ? "×" : "x";
  const char* degree = set ? "°" : " deg";
  const auto& b = c.bearing;
  std::string line = fmt::format("bearing {:.4g} {} {:.4g} mm, radial clearance {:.4g} {}, {}",
                                 2e3 * b.radius, times, 1e3 * b.width,
                                 kPerMicro * b.radial_clearance, set ? "µm" : "um", speed_words(c));
  if (c.cycle) {
    line += cycle_words(*c.cycle, degree);
  } else if (const auto* load = std::get_if<bearing::LoadGiven>(&c.operation.position)) {
    line += fmt::format(", load {:.4g} kN at {:.4g}{}", load->force / kThousandfold,
                        load->angle * kDegrees, degree);
  } else {
    const auto& e = std::get<bearing::EccentricityGiven>(c.operation.position);
    line += fmt::format(", eccentricity ratio {:.4g}, attitude {:.4g}{}", e.ratio,
                        e.attitude * kDegrees, degree);
  }
  return c.oil.name.empty() ? line : line + ", oil " + c.oil.name;
}

std::string typeset_number(std::string number) {
  for (auto at = number.find('-'); at != std::string::npos; at = number.find('-')) {
    number.replace(at, 1, "−");
  }
  return number;
}

std::string signed_change(const bearing::FrictionSplit& split, double change) {
  const double largest = std::max(std::abs(split.from), std::abs(split.to));
  if (!(largest > 0.0) || !std::isfinite(change)) return figures(change);
  const int decimals = std::max(0, 3 - static_cast<int>(std::floor(std::log10(largest))));
  return fmt::format("{:+.{}f}", change, decimals);
}

bearing::FrictionSplit against_the_motion(bearing::FrictionSplit split) {
  if (!(split.from < 0.0)) return split;
  split.from = -split.from;
  split.to = -split.to;
  for (auto& step : split.steps) step.change = -step.change;
  return split;
}

std::string calibration_words(const bearing::Comparison& comparison, Writing writing) {
  const bearing::Calibration& at = comparison.calibration;
  const bool plain = writing == Writing::plain;
  const std::string degrees = plain ? "degC" : "°C", torque = plain ? "N m" : "N·m";
  const auto temperature = [](double T) { return figures(display_unit("T_equivalent", "K")(T)); };
  if (at.found()) {
    return fmt::format(
        "calibrated equivalent temperature {} {}: there the isothermal torque is the full one",
        temperature(at.T), degrees);
  }
  const std::string none = "no equivalent temperature with the full torque was found: ";
  if (!at.looked()) return none + "isothermal, the film's mean temperature has no solution";
  const double full = std::abs(comparison.split.to);  // however it turns
  const auto [least, most] = std::minmax({std::abs(at.least_torque), std::abs(at.most_torque)});
  const bool passes = least <= full && full <= most;
  const bool all = at.warmest - at.coldest > 1.999 * bearing::kCalibrationReach;
  return fmt::format("{}from {} to {} {} the isothermal torque is {} to {} {}{}{}", none,
                     temperature(at.coldest), temperature(at.warmest), degrees, figures(least),
                     figures(most), torque, passes ? " and jumps past it" : "",
                     passes || all ? "" : "; beyond, no film was found");
}

double unexplained(const bearing::FrictionSplit& split) {
  double rest = split.to - split.from;
  for (const auto& step : split.steps) rest -= step.change;
  return rest;
}

}  // namespace shellback::app
