#include "app/write_running_in.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/followed.hpp"
#include "app/json_parts.hpp"
#include "app/pictures/svg_contour.hpp"
#include "app/pictures/svg_heading.hpp"
#include "app/pictures/svg_lines.hpp"
#include "app/pictures/svg_map.hpp"
#include "app/words/effect_words.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"
#include "bearing/bore_shape.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"
#include "fidelity/tolerance.hpp"

namespace shellback::app {
namespace {

using bearing::RunningInRun;
using bearing::RunningInState;
using fidelity::RunningInBars;
using Json = nlohmann::ordered_json;

constexpr double kMicro = 1e6;
constexpr double kDegrees = 180.0 / kPi;

/// The axis of states that have no time of their own: the new bearing and the last one.
Axis two_states(const RunningInRun& run) {
  const char* last = std::isfinite(run.states.back().t) ? "at the end"
                     : run.verdict.good()               ? "worn in"
                                                        : "last tried";
  return tight_axis(0.0, 1.0, 1, fmt::format("0: new, 1: {}", last));
}

/// One curve over time, shown in its unit; the state before anything wore stands at the left end.
/// States of no time of their own (new, worn in) are joined by a straight line.
void draw_curve(Svg& svg, const Box& box, const RunningInRun& run, const RunningInBars& bars,
                double RunningInState::*value, double factor, const std::string& title,
                const Theme& theme) {
  std::vector<double> t = over_time(run.states, &RunningInState::t);
  const bool in_time = t.size() > 2 && std::isfinite(t.back());
  if (in_time) {
    t.front() = 0.5 * t[1];
  } else {
    for (std::size_t k = 0; k < t.size(); ++k) t[k] = static_cast<double>(k);
  }
  LinePlot plot;
  plot.title = title;
  plot.x = in_time ? log_axis(t.front(), t.back(), "time [s]") : two_states(run);
  Series series{"", t, {}, theme.series[0], ""};
  for (std::size_t k = 0; k < run.states.size(); ++k) {
    series.y.push_back(factor * (run.states[k].*value));
    series.bar.push_back(factor * bars.at(k, value));
  }
  // Torque against a clockwise turn is negative: drawn downwards from zero.
  const double way = series.y.front() < 0.0 ? -1.0 : 1.0;
  double far = 0.0, widest = 0.0;
  for (std::size_t k = 0; k < series.y.size(); ++k) {
    far = std::max(far, way * series.y[k]);
    if (std::isfinite(series.bar[k])) widest = std::max(widest, way * series.y[k] + series.bar[k]);
  }
  const double end = way * std::clamp(widest, far, 2.0 * far);  // longer bars are cut off
  plot.y = round_axis(std::min(end, 0.0), std::max(end, 0.0), 5, "");
  plot.series.push_back(std::move(series));
  draw_lines(svg, box, plot, theme);
}

/// Depth along the bearing where it is deepest.
void draw_section(Svg& svg, const Box& box, const RunningInRun& run, const Theme& theme) {
  const auto deepest = std::max_element(run.wear.begin(), run.wear.end());
  const int i = static_cast<int>(std::distance(run.wear.begin(), deepest)) / run.grid.nz;
  Series series{"", {}, {}, theme.series[0], ""};
  for (int j = 0; j < run.grid.nz; ++j) {
    series.x.push_back(1e3 * run.grid.z[j]);
    series.y.push_back(kMicro * run.wear[run.grid.index(i, j)]);
  }
  LinePlot plot;
  plot.title = fmt::format("Wear along the bearing at {:.0f}° [µm]",
                           std::fmod(kDegrees * run.grid.phi[i] + 720.0, 360.0));
  plot.x = round_axis(-500.0 * run.grid.width, 500.0 * run.grid.width, 6, "z [mm]");
  plot.y = round_axis(0.0, largest(series.y), 5, "");
  plot.series.push_back(std::move(series));
  draw_lines(svg, box, plot, theme);
}

void draw_shape(Svg& svg, const Box& box, const RunningInRun& run, const Theme& theme) {
  FieldMap map;
  map.title = "Wear of the shell";
  map.unit = "µm";
  Field shown = run.wear;
  for (double& x : shown) x *= kMicro;
  map.surface = unrolled(run.grid, shown);
  map.scale = {kCool, 0.0, std::max(largest(shown), 1e-3)};
  map.x = degree_axis();
  map.y = tight_axis(-500.0 * run.grid.width, 500.0 * run.grid.width, 6, "z [mm]");
  draw_map(svg, box, map, theme);
}

/// Means and extremes of the last cycle, in the units of the quantities.
Json cycle_quantities(const bearing::CycleResult& cycle) {
  Json all = Json::object();
  for (const auto& q : cycle.quantities) {
    Json& entry = all[q.quantity.name] = json_parts::with_unit(q.quantity.value, q.quantity.unit);
    if (std::isfinite(q.at)) entry["at"] = json_parts::with_unit(q.at, "s");
  }
  return all;
}

struct LastState {
  std::vector<bearing::Note> warnings;  ///< without those of the input
  std::vector<bearing::LimiterCount> limiters;
  std::vector<bearing::Note> assumptions;
};

LastState last_state(const RunningInRun& run) {
  if (run.states.empty()) return {};
  LastState last{run.warnings, {}, {}};
  const auto add = [&](const std::vector<bearing::Note>& notes, std::size_t from) {
    last.warnings.insert(last.warnings.end(), notes.begin() + static_cast<std::ptrdiff_t>(from),
                         notes.end());
  };
  if (run.cycle) {
    add(run.cycle->warnings, 0);
    last.limiters = run.cycle->limiters;
    last.assumptions = run.cycle->assumptions;
    return last;
  }
  const bearing::Result r = bearing::summarize(run.solution, run.solution.model.input.model.tier);
  add(r.warnings, run.solution.model.input.warnings.size());
  last.limiters = r.limiters;
  last.assumptions = r.assumptions;
  return last;
}

void add_cycle(Json& json, const RunningInRun& run) {
  Json passed = Json::array();
  for (const RunningInState& s : run.states) passed.push_back(s.cycles);
  json["cycles"] = passed;
  const bearing::CycleAudit& a = run.cycle->audit;
  json["cycle"] = {{"closure", json_parts::number(run.cycle->closure)},
                   {"audit",
                    {{"mass", json_parts::number(a.mass)},
                     {"energy", json_parts::number(a.energy)},
                     {"walls", json_parts::number(a.walls)}}},
                   {"quantities", cycle_quantities(*run.cycle)},
                   {"limiters", json_parts::limiters_json(run.cycle->limiters)},
                   {"warnings", words_of(last_state(run).warnings)}};
}

std::string told(const RunningInRun& run) {
  if (!run.verdict.good()) return reason_of(run.verdict);
  const RunningInState& last = run.states.back();
  const std::string when =
      std::isfinite(last.t) ? fmt::format("after {:.4g} s", last.t) : std::string("worn in");
  return fmt::format("{}: wear up to {:.3g} µm, {:.3g} mm³; bands: bars of grid and steps", when,
                     kMicro * last.depth, 1e9 * last.volume);
}

/// Of the last state: greatest wear, torque and smallest film.
KnownAtEnds known(const bearing::Case& c, const RunningInRun& run, const RunningInBars& bars) {
  if (!run.verdict.good()) return {c.model.tolerance, {}, false};
  KnownAtEnds of = known_at_ends<RunningInState>(
      c, run.states, bars, {run.states.size() - 1},
      {{"wear_depth", "greatest wear", &RunningInState::depth},
       {"friction_torque", "friction torque", &RunningInState::torque},
       {"h_min", "smallest film", &RunningInState::h_min}});
  of.laminar = fidelity::is_laminar(last_state(run).warnings);
  return of;
}

/// The keys of a surface, its members and their units.
struct SurfaceKey {
  const char* name;
  double solid::RoughSurface::*value;
  const char* unit;
};
constexpr SurfaceKey kSurfaceKeys[] = {
    {"roughness", &solid::RoughSurface::roughness, "m"},
    {"orientation", &solid::RoughSurface::orientation, "1"},
    {"summit_roughness", &solid::RoughSurface::summit_roughness, "m"},
    {"summit_height", &solid::RoughSurface::summit_height, "m"}};

/// That of the last state; none where the surface does not change.
void add_surface(Json& json, const bearing::Case& c, const RunningInRun& run) {
  if (!c.running_in->worn) return;
  const solid::RoughSurface shell = bearing::worn_surface(c, largest(run.wear));
  for (const SurfaceKey& key : kSurfaceKeys) {
    json["surface"][key.name] = json_parts::with_unit(shell.*key.value, key.unit);
  }
}

}  // namespace

std::string worn_surface_keys(const bearing::Case& c, const RunningInRun& run) {
  if (!c.running_in->worn) return "";
  const solid::RoughSurface shell = bearing::worn_surface(c, largest(run.wear));
  std::string keys;
  for (const SurfaceKey& key : kSurfaceKeys) {
    const bool length = key.unit == std::string("m");
    const std::string value = length ? fmt::format("\"{:.6g} um\"", kMicro * (shell.*key.value))
                                     : fmt::format("{:.6g}", shell.*key.value);
    keys += fmt::format("{}--set 'surfaces.shell.{}={}'", keys.empty() ? "" : " ", key.name, value);
  }
  return keys;
}

std::vector<std::string> words_of_bars(const bearing::Case& c, const RunningInRun& run,
                                       const RunningInBars& bars) {
  std::vector<std::string> all = bar_warnings(bars);
  for (std::string& words : known(c, run, bars).words()) all.push_back(std::move(words));
  return all;
}

std::vector<std::string> words_of_last_state(const RunningInRun& run) {
  const LastState last = last_state(run);
  std::vector<std::string> told = words_of(last.warnings);
  for (const bearing::LimiterCount& l : last.limiters) {
    told.push_back(fmt::format("{}, {} times", words_of(l.what), l.count));
  }
  return told;
}

std::string running_in_json(const bearing::Case& c, const RunningInRun& run,
                            const RunningInBars& bars) {
  Json json;
  json_parts::add_status(json, run.verdict);
  json["title"] = c.title;
  json["tier"] = to_string(c.model.tier);
  json["grid"] = c.model.grid;
  add_over_time(json, run.states, bars, bearing::kFollowedStates);
  json["quantities"]["step"] = {{"unit", "s"},
                                {"values", over_time(run.states, &RunningInState::step)}};
  json["rejected_steps"] = run.rejected_steps;
  const bool sought = std::isfinite(run.complementarity);
  json["complementarity"] = sought ? Json(run.complementarity) : Json(nullptr);
  json["tolerance"] = known(c, run, bars).json();
  const std::vector<std::string> of_bars = words_of_bars(c, run, bars);
  if (!of_bars.empty()) json["bars"] = of_bars;
  if (run.cycle) {
    add_cycle(json, run);
  } else {
    const LastState last = last_state(run);
    json["limiters"] = json_parts::limiters_json(last.limiters);
    json["warnings"] = words_of(last.warnings);
  }
  if (!run.states.empty()) add_surface(json, c, run);
  json["assumptions"] = words_of(last_state(run).assumptions);
  json["provenance"] = json_parts::provenance_json(c);
  json_parts::add_case(json, c);
  return json_parts::dump(json);
}

std::string running_in_svg(const bearing::Case& c, const RunningInRun& run,
                           const RunningInBars& bars) {
  const Theme theme = print_theme();
  Svg svg(kOverTimeWidth, kOverTimeHeight);
  svg.rect({0.0, 0.0, kOverTimeWidth, kOverTimeHeight}, theme.paper);
  draw_scene(svg, c, "Running-in, tier " + std::string(to_string(c.model.tier)) + ", " + told(run),
             run.verdict.good(), theme);
  draw_curve(svg, {70.0, 110.0, 300.0, 270.0}, run, bars, &RunningInState::depth, kMicro,
             "Greatest wear [µm]", theme);
  draw_curve(
      svg, {460.0, 110.0, 300.0, 270.0}, run, bars, &RunningInState::p_asperity_max, 1e-6,
      run.cycle ? "Largest contact pressure of the cycle [MPa]" : "Largest contact pressure [MPa]",
      theme);
  draw_curve(svg, {850.0, 110.0, 300.0, 270.0}, run, bars, &RunningInState::torque, 1.0,
             run.cycle ? "Friction torque, mean of the cycle [N m]" : "Friction torque [N m]",
             theme);
  draw_shape(svg, {8.0, 430.0, 604.0, 330.0}, run, theme);
  draw_section(svg, {690.0, 470.0, 460.0, 240.0}, run, theme);
  return svg.document(c.title);
}

std::string worn_shape_csv(const bearing::Case& c, const RunningInRun& run) {
  std::string csv;
  if (!run.verdict.good()) {                                          // app/reading/csv_table.hpp
    const double t = run.states.empty() ? 0.0 : run.states.back().t;  // none: a search at rest
    const std::string when = std::isfinite(t) ? fmt::format("after {:.4g} s", t) : "last looked at";
    csv = fmt::format("# not finished: {}; this is the shape {}\n", reason_of(run.verdict), when);
  }
  csv += "phi [deg], z [mm], height [um]\n";
  const bearing::Profile table = bearing::wear_table(run.grid, run.wear);
  bearing::Bearing before;
  before.shape = c.bearing.shape;
  std::size_t at = 0;
  for (const double phi : table.phi) {
    const double degrees = kDegrees * phi - 360.0 * std::floor(kDegrees * phi / 360.0);
    for (const double z : table.z) {
      const double height = table.height[at++] + bearing::shape_at(before, phi, z);
      csv += fmt::format("{:.10g}, {:.10g}, {:.10g}\n", degrees, 1e3 * z, kMicro * height);
    }
  }
  const std::string keys = worn_surface_keys(c, run);
  if (!keys.empty()) csv += "# the surface that belongs to it: " + keys + "\n";
  return csv;
}

}  // namespace shellback::app
