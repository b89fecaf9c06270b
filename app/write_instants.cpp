#include "app/write_instants.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/followed.hpp"
#include "app/words/ending_words.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::app {

using bearing::Instant;
using fidelity::MarchBars;
using json_parts::Json;

namespace {

std::string known(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

}  // namespace

std::string instant_heading(const std::string& first) {
  return fmt::format("{:>53} {:>9} {:>9} {:>9} {:>9}\n", "", "largest", "largest", "mean", "mean") +
         fmt::format("{:>14} {:>10} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9} {:>9} {:>7}\n", first,
                     "torque", "+-", "h_min", "+-", "film", "shell", "back", "shaft", "+-") +
         fmt::format("{:>14} {:>10} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9} {:>9} {:>7}\n", "", "[N m]",
                     "[N m]", "[um]", "[um]", "[degC]", "[degC]", "[degC]", "[degC]", "[K]");
}

std::string instant_line(const std::string& first, const Instant& i, const Instant& bar) {
  double bar_T = bar.T_film_max;
  for (double Instant::*T : {&Instant::T_shell_max, &Instant::T_shell_back, &Instant::T_shaft}) {
    bar_T = larger(bar_T, bar.*T);
  }
  std::string line = fmt::format("{:>14} {:>10} {:>8} {:>8} {:>8}", first,
                                 known(i.torque, "{:.4g}"), known(bar.torque, "{:.2g}"),
                                 known(1e6 * i.h_min, "{:.4g}"), known(1e6 * bar.h_min, "{:.2g}"));
  for (double Instant::*T :
       {&Instant::T_film_max, &Instant::T_shell_max, &Instant::T_shell_back, &Instant::T_shaft}) {
    line += fmt::format(" {:>9}", known(i.*T - kZeroCelsius, "{:.1f}"));
  }
  return line + fmt::format(" {:>7}\n", known(bar_T, "{:.1f}"));
}

Instant bar_at(const MarchBars& bars, std::size_t k) {
  Instant bar;
  for (const auto& q : bearing::kFollowedInstants) {
    bar.*q.value = bars.at(k, q.value);
  }
  return bar;
}

std::string end_words(const bearing::MarchEnd& end, const MarchBars& bars) {
  std::string when = fmt::format("{:.4g} s", end.t);
  if (std::isfinite(bars.end.grid)) when += fmt::format(" +- {:.2g} s (grid)", bars.end.grid);
  if (std::isfinite(bars.end.time)) when += fmt::format(" +- {:.2g} s (steps)", bars.end.time);
  return fmt::format("{} after {}: {}", end.left_bounds ? "no film is left" : "ended", when,
                     reason_of(end.verdict));
}

json_parts::Json end_json(const bearing::MarchEnd& end, const MarchBars& bars) {
  Json t = {{"value", end.t}, {"unit", "s"}};
  if (std::isfinite(bars.end.grid)) t["error_grid"] = bars.end.grid;
  if (std::isfinite(bars.end.time)) t["error_time"] = bars.end.time;
  return {{"t", t}, {"at_rest", end.at_rest}, {"no_film_left", end.left_bounds}};
}

json_parts::Json march_json(const bearing::Case& c, const Verdict& verdict, double T_start) {
  json_parts::Json json;
  json_parts::add_status(json, verdict);
  json["title"] = c.title;
  json["tier"] = to_string(c.model.tier);
  json["grid"] = c.model.grid;
  json["start"] = {{"value", T_start}, {"unit", "K"}};
  return json;
}

void add_instants(Json& json, const std::vector<Instant>& instants, const MarchBars& bars) {
  add_over_time(json, instants, bars, bearing::kFollowedInstants);
}

std::vector<std::string> heat_words(double imbalance) {
  constexpr double kTold = 0.01;
  if (!(imbalance > kTold)) return {};
  return {
      fmt::format("heat made, carried off and stored close to {:.2g} % only: film and bodies "
                  "change faster than steps over cycles follow (a smaller model.tolerance)",
                  100.0 * imbalance)};
}

KnownAtEnds known_of_march(const bearing::Case& c, const std::vector<Instant>& instants,
                           const MarchBars& bars, const std::vector<std::size_t>& ends) {
  return known_at_ends<Instant>(c, instants, bars, ends,
                                {{"friction_torque", "friction torque", &Instant::torque},
                                 {"h_min", "smallest film", &Instant::h_min}});
}

Series over_instants(const std::vector<double>& x, const std::vector<Instant>& instants,
                     const MarchBars& bars, double Instant::*value, double factor, double zero) {
  Series series{"", x, {}, "", ""};
  for (std::size_t k = 0; k < instants.size(); ++k) {
    series.y.push_back(factor * (instants[k].*value) - zero);
    series.bar.push_back(factor * bars.at(k, value));
  }
  return series;
}

}  // namespace shellback::app
