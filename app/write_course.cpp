#include "app/write_course.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/command_words.hpp"
#include "app/followed.hpp"
#include "app/json_parts.hpp"
#include "app/provenance.hpp"
#include "app/svg_lines.hpp"
#include "app/table_parts.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"
#include "app/write_json.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

using bearing::CourseRun;
using bearing::Instant;
using bearing::Stretch;
using Json = nlohmann::ordered_json;

constexpr double kMinute = 60.0;  ///< [s]

double rpm(const Stretch& s) { return s.subject.operation.omega * 30.0 / kPi; }

Json stretch_json(const Stretch& s, const CourseRun& run, std::size_t k) {
  Json json;
  json["speed"] = {{"value", s.subject.operation.omega}, {"unit", "rad/s"}};
  json["duration"] = {{"value", s.duration}, {"unit", "s"}};
  json["passed"] = k < run.ends.size();
  if (k >= run.ends.size()) return json;
  const Instant& end = run.instants[run.ends[k]];
  for (const auto& q : kFollowedInstants) {
    json["end"][q.name] = {{"value", end.*q.value}, {"unit", q.unit}};
  }
  return json;
}

/// A line of a panel, in the unit shown.
struct Line {
  const char* label;
  double Instant::*value;
  double factor;
  double zero;
};

void draw_over_time(Svg& svg, const Box& box, const CourseRun& run, const std::string& title,
                    const std::string& unit, const std::vector<Line>& lines, const Theme& theme) {
  LinePlot plot;
  plot.title = title;
  plot.x = round_axis(0.0, run.instants.back().t / kMinute, 8, "time [min]");
  plot.y_title = "[" + unit + "]";
  plot.from_zero = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    Series series{lines[k].label, {}, {}, theme.series[k % theme.series.size()], ""};
    for (const Instant& i : run.instants) {
      series.x.push_back(i.t / kMinute);
      series.y.push_back(lines[k].factor * (i.*lines[k].value) - lines[k].zero);
    }
    plot.series.push_back(std::move(series));
  }
  draw_lines(svg, box, plot, theme);
}

void draw_over_speed(Svg& svg, const Box& box, const std::vector<Stretch>& stretches,
                     const CourseRun& run, const Theme& theme) {
  LinePlot plot;
  plot.title = "Friction torque at the end of each stretch";
  plot.y_title = "[N m]";
  Series series{"", {}, {}, theme.series[0], ""};
  double low = 0.0;
  double high = 0.0;
  for (std::size_t k = 0; k < run.ends.size(); ++k) {
    series.x.push_back(rpm(stretches[k]));
    series.y.push_back(run.instants[run.ends[k]].torque);
    low = std::min(low, series.x.back());
    high = std::max(high, series.x.back());
  }
  plot.x = round_axis(low, high, 8, "speed [rpm]");
  plot.series = {series};
  draw_lines(svg, box, plot, theme);
}

std::string how_it_ended(const std::vector<Stretch>& stretches, const CourseRun& run) {
  if (run.end.verdict.good()) return fmt::format("{} stretches", stretches.size());
  return fmt::format("ended after {:.4g} s: {}", run.end.t, reason_of(run.end.verdict));
}

}  // namespace

void write_course_table(std::ostream& out, const std::vector<Stretch>& stretches,
                        const CourseRun& run) {
  const bearing::Case& c = stretches.front().subject;
  out << c.title << '\n';
  if (const std::string changes = describe_changes(c); !changes.empty()) out << changes << '\n';
  out << fmt::format("course, tier {}, grid {} x {}\n\n", to_string(c.model.tier), c.model.grid[0],
                     c.model.grid[1]);
  out << fmt::format("{:>47} {:>12} {:>12} {:>12} {:>12}\n", "", "largest", "largest", "mean",
                     "mean");
  out << fmt::format("{:>12} {:>10} {:>12} {:>10} {:>12} {:>12} {:>12} {:>12}\n", "speed [rpm]",
                     "end [s]", "torque [N m]", "h_min [um]", "film [degC]", "shell [degC]",
                     "back [degC]", "shaft [degC]");
  double end = 0.0;  // of the stretch: the last instant may be before, where all has come to rest
  for (std::size_t k = 0; k < run.ends.size(); ++k) {
    const Instant& i = run.instants[run.ends[k]];
    end += stretches[k].duration;
    out << fmt::format(
        "{:>12.6g} {:>10.6g} {:>12.5g} {:>10.4g} {:>12.2f} {:>12.2f} {:>12.2f} "
        "{:>12.2f}\n",
        rpm(stretches[k]), end, i.torque, 1e6 * i.h_min, i.T_film_max - kZeroCelsius,
        i.T_shell_max - kZeroCelsius, i.T_shell_back - kZeroCelsius, i.T_shaft - kZeroCelsius);
  }
  out << fmt::format("\naudit (relative)  heat in - out - stored at the ends: {:.1e}\n",
                     run.imbalance_at_ends());
  print_list(out, "warnings", words_of(bearing::march_warnings(c.oil, run.instants)));
}

std::string course_json(const std::vector<Stretch>& stretches,
                        const bearing::WarmUpOptions& options, const CourseRun& run) {
  const bearing::Case& c = stretches.front().subject;
  Json json;
  json_parts::add_status(json, run.end.verdict);
  json["title"] = c.title;
  json["tier"] = to_string(c.model.tier);
  json["grid"] = c.model.grid;
  json["start"] = {{"value", options.T_start}, {"unit", "K"}};
  json["stretches"] = Json::array();
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    json["stretches"].push_back(stretch_json(stretches[k], run, k));
  }
  Json times = Json::array();
  for (const Instant& i : run.instants) times.push_back(i.t);
  json["time"] = {{"unit", "s"}, {"values", times}};
  for (const auto& q : kFollowedInstants) {
    Json values = Json::array();
    for (const Instant& i : run.instants) values.push_back(i.*q.value);
    json["quantities"][q.name] = {{"unit", q.unit}, {"values", values}};
  }
  json["audit"] = {{"energy", run.imbalance_at_ends()}};
  json["warnings"] = words_of(bearing::march_warnings(c.oil, run.instants));
  json["assumptions"] = c.assumptions;
  json["provenance"] = Json::parse(result_json(c, {}))["provenance"];
  json_parts::add_case(json, c);  // of the first stretch
  return json_parts::dump(json);
}

std::string course_svg(const std::vector<Stretch>& stretches, const CourseRun& run) {
  const bearing::Case& c = stretches.front().subject;
  const Theme theme = print_theme();
  Svg svg(kOverTimeWidth, kOverTimeHeight);
  svg.rect({0.0, 0.0, kOverTimeWidth, kOverTimeHeight}, theme.paper);
  svg.text({24.0, 36.0}, c.title, {theme.ink, 20.0, Anchor::start, true});
  svg.text({24.0, 58.0},
           fmt::format("Course of speeds, tier {}: {}", to_string(c.model.tier),
                       how_it_ended(stretches, run)),
           {run.end.verdict.good() ? theme.muted : theme.more, 12.5});
  if (!run.instants.empty()) {
    draw_over_time(svg, {70.0, 100.0, 500.0, 300.0}, run, "Temperature", "°C",
                   {{"film, largest", &Instant::T_film_max, 1.0, kZeroCelsius},
                    {"shell, largest", &Instant::T_shell_max, 1.0, kZeroCelsius},
                    {"shell back, mean", &Instant::T_shell_back, 1.0, kZeroCelsius},
                    {"shaft", &Instant::T_shaft, 1.0, kZeroCelsius}},
                   theme);
    draw_over_time(svg, {660.0, 100.0, 500.0, 300.0}, run, "Friction torque", "N m",
                   {{"", &Instant::torque, 1.0, 0.0}}, theme);
    draw_over_time(svg, {70.0, 440.0, 500.0, 300.0}, run, "Smallest film", "µm",
                   {{"", &Instant::h_min, 1e6, 0.0}}, theme);
    draw_over_speed(svg, {660.0, 440.0, 500.0, 300.0}, stretches, run, theme);
  }
  return svg.document(c.title);
}

}  // namespace shellback::app
