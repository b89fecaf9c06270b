#include "app/write_course.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/followed.hpp"
#include "app/json_parts.hpp"
#include "app/labels/command_words.hpp"
#include "app/labels/table_parts.hpp"
#include "app/pictures/svg_heading.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"
#include "app/write_curves.hpp"
#include "app/write_instants.hpp"
#include "app/write_json.hpp"
#include "core/constants.hpp"
#include "core/round_off.hpp"
#include "fidelity/tolerance.hpp"

namespace shellback::app {
namespace {

using bearing::CourseRun;
using bearing::Instant;
using bearing::Stretch;
using fidelity::MarchBars;
using Json = nlohmann::ordered_json;

KnownAtEnds known(const bearing::Case& c, const CourseRun& run, const MarchBars& bars) {
  KnownAtEnds of = known_of_march(c, run.instants, bars, run.ends);
  of.laminar = std::all_of(run.warnings.begin(), run.warnings.end(), fidelity::is_laminar);
  return of;
}

constexpr double kMinute = 60.0;  ///< [s]

double rpm(const Stretch& s) { return s.subject.operation.omega * 30.0 / kPi; }

Json stretch_json(const Stretch& s, const CourseRun& run, const MarchBars& bars, std::size_t k) {
  Json json;
  json["speed"] = {{"value", s.subject.operation.omega}, {"unit", "rad/s"}};
  json["duration"] = {{"value", s.duration}, {"unit", "s"}};
  json["passed"] = k < run.ends.size();
  if (k >= run.ends.size()) return json;
  const Instant& end = run.instants[run.ends[k]];
  for (const auto& q : bearing::kFollowedInstants) {
    Json& one = json["end"][q.name];
    one = {{"value", end.*q.value}, {"unit", q.unit}};
    if (bars.grid.empty()) continue;
    one["error_grid"] = json_parts::number(bars.grid[run.ends[k]].*q.value);
    one["error_time"] = json_parts::number(bars.time[run.ends[k]].*q.value);
  }
  return json;
}

/// What is followed over time.
struct Course {
  std::vector<Instant> instants;
  MarchBars bars;
};

/// All instants, and where a bearing came to rest before its stretch was over the last one once
/// more, at the end.
Course to_the_ends(const std::vector<Stretch>& stretches, const CourseRun& run,
                   const MarchBars& bars) {
  Course all;
  const auto take = [&](std::size_t k) {
    all.instants.push_back(run.instants[k]);
    if (bars.grid.empty()) return;
    all.bars.grid.push_back(bars.grid[k]);
    all.bars.time.push_back(bars.time[k]);
  };
  std::size_t k = 0;
  double end = 0.0;
  for (std::size_t n = 0; n < run.ends.size(); ++n) {
    end += stretches[n].duration;
    for (; k <= run.ends[n]; ++k) take(k);
    if (all.instants.back().t >= end * (1.0 - kRoundOff)) continue;
    take(run.ends[n]);
    all.instants.back().t = end;
  }
  for (; k < run.instants.size(); ++k) take(k);
  return all;
}

/// A line of a panel, in the unit shown.
struct Line {
  const char* label;
  double Instant::*value;
  double factor;
  double zero;
};

void draw_over_time(Svg& svg, const Box& box, const Course& course, const std::string& title,
                    const std::string& unit, const std::vector<Line>& lines, const Theme& theme) {
  LinePlot plot;
  plot.title = title;
  plot.x = round_axis(0.0, course.instants.back().t / kMinute, 8, "time [min]");
  plot.y_title = "[" + unit + "]";
  plot.from_zero = false;
  std::vector<double> minutes = over_time(course.instants, &Instant::t);
  for (double& t : minutes) t /= kMinute;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    Series series = over_instants(minutes, course.instants, course.bars, lines[k].value,
                                  lines[k].factor, lines[k].zero);
    series.name = lines[k].label;
    series.colour = theme.series[k % theme.series.size()];
    plot.series.push_back(std::move(series));
  }
  draw_lines(svg, box, plot, theme);
}

void draw_over_speed(Svg& svg, const Box& box, const std::vector<Stretch>& stretches,
                     const CourseRun& run, const MarchBars& bars, const Theme& theme) {
  LinePlot plot;
  plot.title = "Friction torque at the end of each stretch";
  plot.y_title = "[N m]";
  Series series{"", {}, {}, theme.series[0], ""};
  double low = 0.0;
  double high = 0.0;
  for (std::size_t k = 0; k < run.ends.size(); ++k) {
    series.x.push_back(rpm(stretches[k]));
    series.y.push_back(run.instants[run.ends[k]].torque);
    series.bar.push_back(bar_at(bars, run.ends[k]).torque);
    low = std::min(low, series.x.back());
    high = std::max(high, series.x.back());
  }
  series.dots = true;
  plot.x = round_axis(low, high, 8, "speed [rpm]");
  plot.series = {series};
  draw_lines(svg, box, plot, theme);
}

/// The supply that a note is of, -1: none.
int supply_of(const bearing::Note& note) {
  return std::visit(
      [](const auto& n) {
        if constexpr (requires { n.supply; }) {
          return static_cast<int>(n.supply);
        } else {
          return -1;
        }
      },
      note);
}

/// What the films at the ends say, each kind once (of each supply), with the first speed at which
/// it does. Where they leave the oil's range is told of the whole course.
std::vector<std::string> words_at_ends(const std::vector<Stretch>& stretches,
                                       const CourseRun& run) {
  struct Told {
    std::pair<std::size_t, int> kind;  ///< alternative of Note, supply
    std::string words;
    std::vector<double> speeds;  ///< [rpm]
  };
  std::vector<Told> all;
  for (std::size_t k = 0; k < run.warnings.size(); ++k) {
    for (const bearing::Note& note : run.warnings[k]) {
      if (std::holds_alternative<bearing::note::BeyondOilRange>(note)) continue;
      const std::pair kind{note.index(), supply_of(note)};
      auto told = std::find_if(all.begin(), all.end(),
                               [&](const Told& other) { return other.kind == kind; });
      if (told == all.end()) told = all.insert(told, {kind, words_of(note), {}});
      std::vector<double>& at = told->speeds;
      const double speed = rpm(stretches[k]);
      if (std::find(at.begin(), at.end(), speed) == at.end()) at.push_back(speed);
    }
  }
  std::vector<std::string> words;
  for (const Told& told : all) {
    const std::size_t more = told.speeds.size() - 1;
    words.push_back(fmt::format("at {:.6g} rpm{}: {}", told.speeds.front(),
                                more == 0 ? "" : fmt::format(" and {} more", more), told.words));
  }
  return words;
}

std::vector<std::string> course_warnings(const std::vector<Stretch>& stretches,
                                         const CourseRun& run, const MarchBars& bars) {
  std::vector<std::string> all;
  for (const Stretch& s : stretches) {
    for (const std::string& words : s.subject.warnings) {
      if (std::find(all.begin(), all.end(), words) == all.end()) all.push_back(words);
    }
  }
  const bearing::Case& c = stretches.front().subject;
  for (std::string& words : words_of(bearing::march_warnings(c.oil, run.instants))) {
    all.push_back(std::move(words));
  }
  for (std::string& words : words_at_ends(stretches, run)) all.push_back(std::move(words));
  for (std::string& words : bar_warnings(bars)) all.push_back(std::move(words));
  if (run.over_cycles) {
    for (std::string& words : heat_words(run.imbalance_at_ends())) all.push_back(std::move(words));
  }
  if (!run.end.verdict.good()) return all;
  for (std::string& words : known(c, run, bars).words()) {
    all.push_back(std::move(words));
  }
  return all;
}

std::string how_it_ended(const std::vector<Stretch>& stretches, const CourseRun& run,
                         const MarchBars& bars) {
  if (run.end.verdict.good())
    return fmt::format("{} stretch{}; bands: bars of grid and steps", stretches.size(),
                       stretches.size() == 1 ? "" : "es");
  return end_words(run.end, bars);
}

}  // namespace

void write_course_table(std::ostream& out, const std::vector<Stretch>& stretches,
                        const CourseRun& run, const MarchBars& bars) {
  const bearing::Case& c = stretches.front().subject;
  out << c.title << '\n';
  if (const std::string changes = describe_changes(c); !changes.empty()) out << changes << '\n';
  out << fmt::format("course, tier {}, grid {} x {}\n\n", to_string(c.model.tier), c.model.grid[0],
                     c.model.grid[1]);
  out << instant_heading("[rpm], end [s]");
  double end = 0.0;  // of the stretch: the last instant may be before, where all has come to rest
  for (std::size_t k = 0; k < run.ends.size(); ++k) {
    end += stretches[k].duration;
    out << instant_line(fmt::format("{:.6g}, {:>6.6g}", rpm(stretches[k]), end),
                        run.instants[run.ends[k]], bar_at(bars, run.ends[k]));
  }
  out << fmt::format("\naudit (relative)  heat in - out - stored {}: {:.1e}\n",
                     run.over_cycles ? "over a stretch, at most" : "at the ends",
                     run.imbalance_at_ends());
  print_list(out, "warnings", course_warnings(stretches, run, bars));
  print_list(out, "assumptions", c.assumptions);
}

std::string course_json(const std::vector<Stretch>& stretches,
                        const bearing::WarmUpOptions& options, const CourseRun& run,
                        const MarchBars& bars) {
  const bearing::Case& c = stretches.front().subject;
  Json json = march_json(c, run.end.verdict, options.T_start);
  json["stretches"] = Json::array();
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    json["stretches"].push_back(stretch_json(stretches[k], run, bars, k));
  }
  const Course course = to_the_ends(stretches, run, bars);
  add_instants(json, course.instants, course.bars);
  if (!run.end.verdict.good()) json["end"] = end_json(run.end, bars);
  json["audit"] = {{"energy", run.imbalance_at_ends()}};
  if (run.end.verdict.good()) {
    json["tolerance"] = known(c, run, bars).json();
  }
  json["warnings"] = course_warnings(stretches, run, bars);
  json["assumptions"] = c.assumptions;
  json["provenance"] = Json::parse(result_json(c, {}))["provenance"];
  json_parts::add_case(json, c);  // of the first stretch
  return json_parts::dump(json);
}

std::string course_svg(const std::vector<Stretch>& stretches, const CourseRun& run,
                       const MarchBars& bars) {
  const bearing::Case& c = stretches.front().subject;
  const Theme theme = print_theme();
  Svg svg(kOverTimeWidth, kOverTimeHeight);
  svg.rect({0.0, 0.0, kOverTimeWidth, kOverTimeHeight}, theme.paper);
  draw_scene(svg, c,
             fmt::format("Course of speeds, tier {}: {}", to_string(c.model.tier),
                         how_it_ended(stretches, run, bars)),
             run.end.verdict.good(), theme);
  if (!run.instants.empty()) {
    const Course course = to_the_ends(stretches, run, bars);
    draw_over_time(svg, {70.0, 100.0, 500.0, 300.0}, course, "Temperature", "°C",
                   {{"film, largest", &Instant::T_film_max, 1.0, kZeroCelsius},
                    {"shell, largest", &Instant::T_shell_max, 1.0, kZeroCelsius},
                    {"shell back, mean", &Instant::T_shell_back, 1.0, kZeroCelsius},
                    {"shaft", &Instant::T_shaft, 1.0, kZeroCelsius}},
                   theme);
    draw_over_time(svg, {660.0, 100.0, 500.0, 300.0}, course, "Friction torque", "N m",
                   {{"", &Instant::torque, 1.0, 0.0}}, theme);
    draw_over_time(svg, {70.0, 440.0, 500.0, 300.0}, course, "Smallest film", "µm",
                   {{"", &Instant::h_min, 1e6, 0.0}}, theme);
    draw_over_speed(svg, {660.0, 440.0, 500.0, 300.0}, stretches, run, bars, theme);
  }
  return svg.document(c.title);
}

std::string course_csv(const std::vector<Stretch>& stretches, const CourseRun& run,
                       const MarchBars& bars) {
  std::vector<Curve> curves = curves_of(run.instants, bars, bearing::kFollowedInstants);
  Curve speed{"speed", "rad/s", {}, {}}, stretch{"stretch", "1", {}, {}};
  std::size_t k = 0;
  for (std::size_t i = 0; i < run.instants.size(); ++i) {
    while (k < run.ends.size() && run.ends[k] < i && k + 1 < stretches.size()) ++k;
    speed.values.push_back(stretches[k].subject.operation.omega);
    stretch.values.push_back(static_cast<double>(k + 1));
  }
  curves.insert(curves.begin() + 1, {speed, stretch});
  return curves_csv(curves, run.end.verdict);
}

}  // namespace shellback::app
