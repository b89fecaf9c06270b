#include "app/html_figures.hpp"

#include <fmt/format.h>

#include <functional>

#include "app/html_page.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_film.hpp"
#include "app/pictures/svg_profiles.hpp"
#include "app/pictures/svg_section.hpp"
#include "app/pictures/svg_waterfall.hpp"

namespace shellback::app {
namespace {

using bearing::Case;
using bearing::Comparison;
using bearing::Result;

constexpr double kMapHeight = 232.0;
constexpr double kPlotHeight = 300.0;

/// Index of the last result for which `has` is true; -1: none.
int last_with(const Comparison& comparison, const std::function<bool(const Result&)>& has) {
  for (int k = static_cast<int>(comparison.results.size()) - 1; k >= 0; --k) {
    if (has(comparison.results[k])) return k;
  }
  return -1;
}

std::string named(const Comparison& comparison, int k, const std::string& what) {
  const auto& result = comparison.results[k];
  return fmt::format("{}, {}{}", what, column_names(comparison.results)[k],
                     result.verdict.good() ? "" : " (NOT CONVERGED)");
}

std::string map_figure(const Case& c, const Comparison& comparison, int k, FilmField which,
                       const ColourScale& scale, const std::string& what,
                       const std::string& caption) {
  const std::string title = named(comparison, k, what);
  return figure_html(kColumnWidth, kMapHeight, title, caption, [&](Svg& svg, const Box& box) {
    draw_map(svg, box, film_map(c, comparison.results[k], which, scale, title), page_theme());
  });
}

/// First and last result that have the field, on one scale.
std::string pair_of_maps(const Case& c, const Comparison& comparison, FilmField which,
                         const std::string& what, const std::string& caption) {
  const int last = last_with(comparison, [&](const Result& r) { return has_field(r, which); });
  if (last < 0) return "";
  int first = 0;
  while (!has_field(comparison.results[first], which)) ++first;
  const auto scale = common_scale({&comparison.results[first], &comparison.results[last]}, which);
  std::string html;
  if (first != last) html = map_figure(c, comparison, first, which, scale, what, caption);
  return html + map_figure(c, comparison, last, which, scale, what, caption);
}

std::string last_map(const Case& c, const Comparison& comparison, FilmField which,
                     const std::string& what, const std::string& caption) {
  const int last = last_with(comparison, [&](const Result& r) { return has_field(r, which); });
  if (last < 0) return "";
  const auto scale = common_scale({&comparison.results[last]}, which);
  return map_figure(c, comparison, last, which, scale, what, caption);
}

}  // namespace

std::string waterfall_html(const Case& c, const Comparison& comparison) {
  if (comparison.split.steps.empty()) return "";
  const double height = 74.0 + 38.0 * static_cast<double>(comparison.split.steps.size() + 2);
  return figures_html(
      figure_html(860.0, height, "Friction torque from isothermal to full model",
                  "Effects substituted one after another, from top to bottom; another order would "
                  "share the difference out differently. Percentages are of the isothermal torque.",
                  [&](Svg& svg, const Box& box) {
                    draw_waterfall(svg, box, comparison.split, measured_torque(c), page_theme());
                  }),
      "figures single");
}

std::string profiles_html(const Comparison& comparison) {
  std::string html;
  for (const Profile which :
       {Profile::pressure, Profile::gap, Profile::film_temperature, Profile::shell_temperature}) {
    const auto plot = profile_plot(comparison, which, page_theme());
    if (!plot) continue;
    const std::string caption = which == Profile::gap ? "Inside supply features not drawn." : "";
    html +=
        figure_html(kColumnWidth, kPlotHeight, plot->title, caption,
                    [&](Svg& svg, const Box& box) { draw_lines(svg, box, *plot, page_theme()); });
  }
  return figures_html(html);
}

std::string maps_html(const Case& c, const Comparison& comparison) {
  const std::string dashed = "Dashed: where the full film ends. Supply features outlined.";
  return figures_html(
      pair_of_maps(c, comparison, FilmField::pressure, "Film pressure", dashed) +
      pair_of_maps(c, comparison, FilmField::fill, "Fill ratio", "") +
      pair_of_maps(c, comparison, FilmField::gap, "Gap",
                   "The depth of supply features is beyond the scale.") +
      last_map(c, comparison, FilmField::temperature, "Mean film temperature",
               "Mean across the film. " + dashed) +
      last_map(c, comparison, FilmField::shell_temperature, "Shell temperature at the bore", ""));
}

std::string depth_html(const Case& c, const Comparison& comparison) {
  std::string html;
  const int film = last_with(
      comparison, [](const Result& r) { return !r.fields.T.empty() && r.fields.grid.cells() > 0; });
  if (film >= 0) {
    const std::string place = words_of_mid_line(comparison.results[film]);
    const std::string title = named(comparison, film, "Temperature across the film " + place);
    html += figure_html(
        kColumnWidth, kPlotHeight, title, "The gap is stretched to unit height everywhere.",
        [&](Svg& svg, const Box& box) {
          draw_map(svg, box, across_film_map(comparison.results[film], title), page_theme());
        });
  }
  const int solid = last_with(comparison, [](const Result& r) {
    return !r.fields.T_solid.empty() && r.fields.r.size() > 1;
  });
  if (solid >= 0) {
    const std::string title =
        named(comparison, solid, "Shell and housing temperature at mid-width");
    html +=
        figure_html(kColumnWidth, 430.0, title,
                    "White circles: layer boundaries. Arrows: rotation and load on the journal.",
                    [&](Svg& svg, const Box& box) {
                      draw_section(svg, box, c, comparison.results[solid], title, page_theme());
                    });
  }
  return figures_html(html);
}

}  // namespace shellback::app
