#include "app/pictures/svg_comparison.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_film.hpp"
#include "app/pictures/svg_heading.hpp"
#include "app/pictures/svg_profiles.hpp"
#include "app/pictures/svg_waterfall.hpp"

namespace shellback::app {
namespace {

using namespace comparison_sheet;
using bearing::Comparison;
using bearing::Result;

/// The richest result, unless it failed and another one did not: results come in the order of
/// the ladder.
const Result* richest(const Comparison& comparison, FilmField which) {
  const Result* best = nullptr;
  for (const auto& result : comparison.results) {
    if (has_field(result, which) && (!best || result.verdict.good() || !best->verdict.good())) {
      best = &result;
    }
  }
  return best;
}

void draw_film(Svg& svg, const Box& box, const bearing::Case& c, const Comparison& comparison,
               FilmField which, const char* title, const Theme& theme) {
  const Result* result = richest(comparison, which);
  if (!result) return;
  const auto scale = common_scale({result}, which);
  const std::string full_title = fmt::format("{}, {}{}", title, to_string(result->tier),
                                             result->verdict.good() ? "" : " (NOT CONVERGED)");
  draw_map(svg, box, film_map(c, *result, which, scale, full_title), theme);
}

}  // namespace

void draw_heading(Svg& svg, const bearing::Case& c, const Comparison& comparison,
                  const Theme& theme) {
  draw_scene(svg, c, theme);
  std::string failed;
  const auto names = column_names(comparison.results);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Result& result = comparison.results[k];
    if (!result.verdict.good()) failed += fmt::format("  {}: {}", names[k], status_line(result));
  }
  if (!failed.empty()) {
    svg.text({kWidth - 24.0, 36.0}, failed, {theme.more, 13.0, Anchor::end, true});
  }
}

std::string comparison_svg(const bearing::Case& c, const Comparison& comparison) {
  const Theme theme = print_theme();
  Svg svg(kWidth, kHeight);
  svg.rect({0.0, 0.0, kWidth, kHeight}, theme.paper);
  draw_heading(svg, c, comparison, theme);
  const auto profile = [&](const Box& box, Profile which) {
    if (const auto plot = profile_plot(comparison, which, theme)) {
      draw_lines(svg, box, *plot, theme);
    }
  };
  if (comparison.split.steps.empty()) {
    profile(kTopLeft, Profile::pressure);
  } else {
    draw_waterfall(svg, kTopLeft, comparison.split, measured_torque(c), theme);
  }
  profile(kBottomLeft, Profile::gap);
  draw_film(svg, kTopRight, c, comparison, FilmField::pressure, "Film pressure", theme);
  draw_film(svg, kBottomRight, c, comparison, FilmField::temperature, "Mean film temperature",
            theme);
  return svg.document(c.title);
}

}  // namespace shellback::app
