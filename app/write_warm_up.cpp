#include "app/write_warm_up.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/followed.hpp"
#include "app/json_parts.hpp"
#include "app/pictures/svg_heading.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"
#include "app/write_instants.hpp"
#include "app/write_json.hpp"
#include "core/constants.hpp"
#include "fidelity/tolerance.hpp"

namespace shellback::app {
namespace {

using bearing::Instant;
using bearing::WarmUp;
using fidelity::MarchBars;
using Json = nlohmann::ordered_json;

/// A line of a panel, in the unit shown, with its steady value.
struct SteadyLine {
  const char* label;
  double Instant::*value;
  const char* steady;  ///< name of the quantity
  double factor;
  double zero;
};

class Panel {
 public:
  Panel(const WarmUp& run, const MarchBars& bars, const bearing::Result& steady, const Theme& theme)
      : run_(run),
        bars_(bars),
        steady_(steady),
        theme_(theme),
        t_(over_time(run.instants, &Instant::t)) {}

  void draw(Svg& svg, const Box& box, const std::string& title, const std::string& unit,
            const std::vector<SteadyLine>& lines, bool from_zero) const {
    LinePlot plot;
    plot.title = title;
    plot.x = log_axis(t_.front(), std::max(t_.back(), 10.0 * t_.front()), "time [s]");
    double low = INFINITY;
    double high = -INFINITY;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      Series series =
          over_instants(t_, run_.instants, bars_, lines[k].value, lines[k].factor, lines[k].zero);
      series.name = lines[k].label;
      series.colour = theme_.series[k % theme_.series.size()];
      for (std::size_t n = 0; n < series.y.size(); ++n) {
        const double v = series.y[n];
        const bool tells = series.bar[n] < std::abs(v);  // a longer one would hide the curve
        const double bar = tells ? series.bar[n] : 0.0;
        low = std::min(low, v - bar);
        high = std::max(high, v + bar);
      }
      plot.series.push_back(series);
      const double end = steady_.value(lines[k].steady);
      if (!steady_.verdict.good() || !std::isfinite(end)) continue;
      const double shown = lines[k].factor * end - lines[k].zero;
      low = std::min(low, shown);
      high = std::max(high, shown);
      plot.series.push_back({"", {t_.front(), t_.back()}, {shown, shown}, series.colour, "3 4"});
    }
    if (from_zero) {  // torque against a clockwise turn is negative
      low = std::min(low, 0.0);
      high = std::max(high, 0.0);
    }
    plot.y = round_axis(low, high, 6, "[" + unit + "]");
    draw_lines(svg, box, plot, theme_);
  }

 private:
  const WarmUp& run_;
  const MarchBars& bars_;
  const bearing::Result& steady_;
  const Theme& theme_;
  std::vector<double> t_;
};

KnownAtEnds known(const bearing::Case& c, const WarmUp& run, const MarchBars& bars) {
  if (!run.end.verdict.good() || run.instants.empty()) return {c.model.tolerance, {}, false};
  KnownAtEnds known = known_of_march(c, run.instants, bars, {run.instants.size() - 1});
  known.laminar = fidelity::is_laminar(run.end.warnings);
  return known;
}

std::string how_it_ended(const WarmUp& run, const MarchBars& bars) {
  if (!run.end.verdict.good()) return end_words(run.end, bars);
  return run.end.at_rest
             ? "at rest in the end; dashed: the steady state solved for itself; bands: "
               "bars of grid and steps"
             : fmt::format("shown up to {:.4g} s; bands: bars of grid and steps", run.end.t);
}

}  // namespace

std::vector<std::string> warm_up_warnings(const bearing::Case& c, const WarmUp& run,
                                          const MarchBars& bars, const bearing::Result& steady) {
  auto all = steady.verdict.good() ? words_of(steady.warnings) : c.warnings;
  for (std::string& words : words_of(bearing::warm_up_warnings(c.oil, run, steady))) {
    if (std::find(all.begin(), all.end(), words) == all.end()) all.push_back(std::move(words));
  }
  const std::vector<std::string> of_bars = bar_warnings(bars);
  all.insert(all.end(), of_bars.begin(), of_bars.end());
  const std::vector<std::string> missed = known(c, run, bars).words();
  all.insert(all.end(), missed.begin(), missed.end());
  if (!c.cycle) return all;
  const std::vector<std::string> open = heat_words(run.imbalance());
  all.insert(all.end(), open.begin(), open.end());
  return all;
}

std::vector<std::string> warm_up_assumptions(const bearing::Case& c,
                                             const bearing::Result& steady) {
  return steady.verdict.good() ? words_of(steady.assumptions) : c.assumptions;
}

std::string warm_up_json(const bearing::Case& c, const WarmUp& run,
                         const bearing::WarmUpOptions& options, const MarchBars& bars,
                         const bearing::Result& steady) {
  Json json = march_json(c, run.end.verdict, options.T_start);
  json["end"] = end_json(run.end, bars);
  add_instants(json, run.instants, bars);
  json["audit"] = {{"energy", run.imbalance()}};
  json["tolerance"] = known(c, run, bars).json();
  json["jumps"] = run.end.jumps;
  json["unfollowed"] = run.end.unfollowed;
  json["warnings"] = warm_up_warnings(c, run, bars, steady);
  const Json one = Json::parse(result_json(c, steady));
  json["steady"] = {{"status", one["status"]}, {"quantities", one["quantities"]}};
  json["assumptions"] = warm_up_assumptions(c, steady);
  json["provenance"] = one["provenance"];
  json_parts::add_case(json, c);
  return json_parts::dump(json);
}

std::string warm_up_svg(const bearing::Case& c, const WarmUp& run, const MarchBars& bars,
                        const bearing::Result& steady) {
  const Theme theme = print_theme();
  Svg svg(kOverTimeWidth, kOverTimeHeight);
  svg.rect({0.0, 0.0, kOverTimeWidth, kOverTimeHeight}, theme.paper);
  draw_scene(
      svg, c,
      "Warm-up, tier " + std::string(to_string(c.model.tier)) + ": " + how_it_ended(run, bars),
      run.end.verdict.good(), theme);
  const Panel panel(run, bars, steady, theme);
  panel.draw(svg, {70.0, 110.0, 500.0, 270.0}, "Temperature", "°C",
             {{"film, largest", &Instant::T_film_max, "T_film_max", 1.0, kZeroCelsius},
              {"shell, largest", &Instant::T_shell_max, "T_shell_max", 1.0, kZeroCelsius},
              {"shell back, mean", &Instant::T_shell_back, "T_shell_back", 1.0, kZeroCelsius},
              {"shaft", &Instant::T_shaft, "T_shaft", 1.0, kZeroCelsius}},
             false);
  panel.draw(svg, {660.0, 110.0, 500.0, 270.0}, "Friction torque", "N m",
             {{"", &Instant::torque, "friction_torque", 1.0, 0.0}}, true);
  panel.draw(svg, {70.0, 460.0, 500.0, 270.0}, "Smallest film", "µm",
             {{"", &Instant::h_min, "h_min", 1e6, 0.0}}, false);
  panel.draw(svg, {660.0, 460.0, 500.0, 270.0}, "Heat", "W",
             {{"made", &Instant::heat_in, "", 1.0, 0.0},
              {"carried off", &Instant::heat_out, "", 1.0, 0.0},
              {"stored", &Instant::stored, "", 1.0, 0.0}},
             false);
  return svg.document(c.title);
}

}  // namespace shellback::app
