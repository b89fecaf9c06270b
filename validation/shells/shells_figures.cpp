#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/html_page.hpp"
#include "app/pictures/cycle_axis.hpp"
#include "app/pictures/svg_cycle.hpp"
#include "app/pictures/svg_lines.hpp"
#include "app/pictures/svg_map.hpp"
#include "core/largest.hpp"
#include "validation/shells/shells_page.hpp"

namespace shellback::validation {
namespace {

using app::LinePlot;
using app::Series;
using app::Svg;
using app::Theme;
using bearing::CycleInstant;
using bearing::Tier;

constexpr double kWidth = 560.0;     ///< [px]
constexpr double kHeight = 340.0;    ///< [px]
constexpr double kHalfLabel = 14.0;  ///< right of the box, for half a label [px]
constexpr double kApart = 6.0;       ///< bars at one speed [px]

/// One curve for each shell over the cycle with temperatures.
template <class Value>
std::string curve(const ShellsStudy& study, const std::string& title, const std::string& unit,
                  const Value& value, const std::string& caption) {
  const Theme theme = app::page_theme();
  LinePlot plot;
  plot.title = title;
  plot.y_title = unit;
  for (int k = 0; k < kShells; ++k) {
    const bearing::CycleResult& r = study.cycles[k][0].result;
    if (!study.cycles[k][0].good()) continue;
    plot.x = app::cycle_axis(r);
    Series s{shell_kinds()[k].name, {}, {}, theme.series[static_cast<std::size_t>(k)], ""};
    for (const CycleInstant& i : r.instants) {
      s.x.push_back(app::on_axis(r, i.t));
      s.y.push_back(value(i));
    }
    plot.series.push_back(std::move(s));
  }
  if (plot.series.empty()) {
    const bool tried = std::any_of(study.cycles.begin(), study.cycles.end(),
                                   [](const auto& shell) { return shell[0].tried; });
    return fmt::format(
        "<figure><figcaption>{}: {}</figcaption></figure>\n", app::escape_markup(title),
        tried ? "no shell has been found over the cycle." : "no cycle has been run yet.");
  }
  Svg svg(kWidth, kHeight);
  draw_lines(svg, {0.0, 0.0, kWidth - kHalfLabel, kHeight}, plot, theme);
  return app::figure_html(svg, title, caption);
}

}  // namespace

std::string shell_curves(const ShellsStudy& study) {
  return curve(
             study, "Largest film pressure", "[MPa]",
             [](const CycleInstant& i) { return 1e-6 * i.p_max; },
             "Over the cycle, tier tehd; after Figure 14 of the paper.") +
         curve(
             study, "Largest contact pressure", "[MPa]",
             [](const CycleInstant& i) { return 1e-6 * i.p_asperity_max; }, "The same.") +
         curve(
             study, "Friction power of the film", "[W]",
             [](const CycleInstant& i) { return (i.torque - i.torque_asperity) * i.omega; },
             "Viscous torque times the speed of the pin in the rod.") +
         curve(
             study, "Friction power of asperities", "[W]",
             [](const CycleInstant& i) { return i.torque_asperity * i.omega; }, "The same.");
}

std::string shell_maps(const ShellsStudy& study) {
  const Theme theme = app::page_theme();
  std::string all;
  for (const auto& [which, words] :
       {std::pair{app::CycleMap::friction, "Friction power per area, mean over the cycle"},
        std::pair{app::CycleMap::shell, "Temperature of the lining's surface, mean"},
        std::pair{app::CycleMap::shell_heat, "Heat into the shell, mean"},
        std::pair{app::CycleMap::contact, "Largest contact pressure of each place"}}) {
    std::vector<std::optional<app::FieldMap>> maps;
    double low = INFINITY, high = -INFINITY;
    for (const auto& shell : study.cycles) {
      maps.push_back(shell[0].good() ? app::cycle_map(shell[0].input, shell[0].result, which)
                                     : std::nullopt);
      if (!maps.back()) continue;
      low = std::min(low, maps.back()->scale.low);
      high = std::max(high, maps.back()->scale.high);
    }
    for (int k = 0; k < kShells; ++k) {
      if (!maps[k]) continue;
      maps[k]->scale.low = low;  // one scale for all shells
      maps[k]->scale.high = high;
      maps[k]->title = shell_kinds()[k].name;
      Svg svg(kWidth, 280.0);
      draw_map(svg, {12.0, 0.0, kWidth - kHalfLabel - 12.0, 280.0}, *maps[k], theme);
      all += app::figure_html(svg, words, fmt::format("{}: {}.", shell_kinds()[k].name, words));
    }
  }
  return all;
}

namespace {

std::string capability_figure(const ShellsStudy& study, bool worn) {
  const Theme theme = app::page_theme();
  LinePlot plot;
  plot.title = worn ? "Load capability, run in" : "Load capability, new";
  plot.y_title = "largest load of the cycle [kN]";
  const auto& rpm = study.plan.rpm;
  const double fastest = *std::max_element(rpm.begin(), rpm.end());
  plot.x = app::round_axis(0.0, 1.1 * fastest, 6, "speed [rpm]");  // room for bars beside
  std::vector<std::vector<double>> bars;                           // of each series
  double most = 0.0;
  for (const Tier tier : {Tier::tehd, Tier::isothermal}) {
    for (int k = 0; k < kShells; ++k) {
      const bool heat = tier == Tier::tehd;
      Series s{heat ? shell_kinds()[k].name : "",
               {},
               {},
               theme.series[static_cast<std::size_t>(k)],
               heat ? "" : "5 4"};
      std::vector<double>& bar = bars.emplace_back();
      for (const double n : rpm) {
        const Capability* c = study.at(k, tier, n, worn);
        s.x.push_back(n);
        const bool borne = c != nullptr && c->good.factor > 0.0;
        const double per_load = borne ? 1e-3 * c->peak / c->good.factor : NAN;  // [kN]
        const bool met = borne && std::isfinite(c->met);
        s.y.push_back(met ? per_load * c->met : borne ? 1e-3 * c->peak : NAN);
        bar.push_back(met ? per_load * c->met_error : NAN);
        const double top = s.y.back() + (std::isfinite(bar.back()) ? bar.back() : 0.0);
        if (std::isfinite(top)) most = std::max(most, top);
      }
      plot.series.push_back(std::move(s));
    }
  }
  plot.y = app::round_axis(0.0, std::max(most, 1.0), 6, plot.y_title);
  Svg svg(kWidth, kHeight);
  const app::Frame frame = draw_lines(svg, {0.0, 0.0, kWidth - kHalfLabel, kHeight}, plot, theme);
  const auto beside = [&](std::size_t k, double x, double y) {  // each series a little apart
    app::Point p = frame.at(x, y);
    p.x += kApart * (static_cast<double>(k) - 0.5 * static_cast<double>(bars.size() - 1));
    return p;
  };
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const Series& s = plot.series[k];
    for (std::size_t n = 0; n < s.x.size(); ++n) {
      if (!std::isfinite(s.y[n])) continue;
      svg.circle(beside(k, s.x[n], s.y[n]), 3.0, s.colour, {s.colour, 1.0});
      if (!std::isfinite(bars[k][n])) continue;
      const double low = std::max(s.y[n] - bars[k][n], 0.0);
      const double high = std::min(s.y[n] + bars[k][n], plot.y->high);
      svg.line(beside(k, s.x[n], low), beside(k, s.x[n], high), {s.colour, 1.2});
    }
  }
  return app::figure_html(
      svg, plot.title,
      "Solid: temperatures solved, dashed: isothermal at the oil temperature of the case. "
      "Points, drawn a little apart: the load at which the limit is met, or the largest that "
      "was borne where that is not known; bars: what the grid moves it by. The table below "
      "says which limit.");
}

}  // namespace

std::string capability_figures(const ShellsStudy& study) {
  return capability_figure(study, false) + capability_figure(study, true);
}

}  // namespace shellback::validation
