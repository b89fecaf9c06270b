#include "app/write_cycle_comparison.hpp"

#include <cmath>

#include "app/html_figures.hpp"
#include "app/html_page.hpp"
#include "app/html_tables.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_comparison.hpp"
#include "app/pictures/svg_cycle.hpp"
#include "app/pictures/svg_profiles.hpp"
#include "app/pictures/svg_waterfall.hpp"

namespace shellback::app {
namespace {

using namespace comparison_sheet;
using bearing::CycleComparison;
using bearing::CycleResult;

/// The first curve of each tier's plot, called by its tier.
LinePlot of_all_tiers(const CycleComparison& comparison, CycleCurve which, const Theme& theme) {
  LinePlot all;
  for (const CycleResult& r : comparison.cycles) {
    const std::string& colour = tier_colour(r.tier, theme);
    LinePlot one = cycle_plot(r, which, theme);
    const bool known = !one.series.empty() && std::isfinite(one.series.front().y.back());
    if (r.instants.empty() || !known) continue;
    Series series = one.series.front();
    series.name = to_string(r.tier) + std::string(r.verdict.good() ? "" : " (NOT CONVERGED)");
    series.colour = colour;
    if (all.series.empty()) {
      all.x = one.x;
      all.title = one.title;
      all.y_title = one.y_title;
      all.from_zero = one.from_zero;
    }
    all.series.push_back(series);
  }
  return all;
}

void draw_curve(Svg& svg, const Box& box, const CycleComparison& comparison, CycleCurve which,
                const Theme& theme) {
  const LinePlot plot = of_all_tiers(comparison, which, theme);
  if (!plot.series.empty()) draw_lines(svg, box, plot, theme);
}

}  // namespace

std::string cycle_comparison_svg(const bearing::Case& c, const CycleComparison& comparison) {
  const Theme theme = print_theme();
  Svg svg(kWidth, kHeight);
  svg.rect({0.0, 0.0, kWidth, kHeight}, theme.paper);
  draw_heading(svg, c, comparison.sums, theme);
  if (comparison.sums.split.steps.empty()) {
    draw_curve(svg, kTopLeft, comparison, CycleCurve::pressure, theme);
  } else {
    draw_waterfall(svg, kTopLeft, comparison.sums.split, measured_torque(c), theme);
  }
  draw_curve(svg, kBottomLeft, comparison, CycleCurve::film, theme);
  draw_curve(svg, kTopRight, comparison, CycleCurve::torque, theme);
  draw_curve(svg, kBottomRight, comparison, CycleCurve::temperature, theme);
  return svg.document(c.title);
}

std::string cycle_comparison_html(const bearing::Case& c, const CycleComparison& comparison) {
  std::string html = page_head(c, "comparison of load cycles");
  html += failures_html(comparison.sums) + verdict_html(c, comparison.sums);
  html += page_section("Friction difference", waterfall_html(c, comparison.sums));
  html += page_section("Quantities, means and extremes of the cycle",
                       quantities_html(c, comparison.sums) + bars_html(c, comparison.sums));
  std::string curves = "<div class=\"figures\">\n";
  for (const CycleCurve which : {CycleCurve::torque, CycleCurve::film, CycleCurve::pressure,
                                 CycleCurve::temperature, CycleCurve::heat}) {
    const LinePlot plot = of_all_tiers(comparison, which, page_theme());
    if (plot.series.empty()) continue;
    Svg svg(580.0, 300.0);
    draw_lines(svg, {0.0, 0.0, 580.0, 300.0}, plot, page_theme());
    curves += "<figure>" + svg.inline_element(plot.title) + "</figure>\n";
  }
  html += page_section("Over the cycle", curves + "</div>\n");
  return html + notes_html(comparison.sums) + page_foot(c);
}

}  // namespace shellback::app
