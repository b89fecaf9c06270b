#include "validation/chart/chart_picture.hpp"

#include <algorithm>

#include "app/pictures/svg_lines.hpp"
#include "validation/chart/chart_marks.hpp"
#include "validation/chart/chart_panel.hpp"

namespace shellback::validation {
namespace {

using namespace app;

constexpr double kPanelWidth = 290.0;
constexpr double kPanelHeight = 236.0;
constexpr double kGap = 16.0;   ///< between panels
constexpr double kLeft = 74.0;  ///< room for the labels of y
constexpr double kRight = 16.0;
constexpr double kUnderLegend = 34.0;  ///< room for names of scenes
constexpr double kBottom = 52.0;       ///< room for the labels of x

bool occurs(const std::vector<ChartScene>& scenes, ChartFamily family) {
  return std::any_of(scenes.begin(), scenes.end(), [&](const ChartScene& s) {
    return std::any_of(s.points.begin(), s.points.end(),
                       [&](const ChartPoint& p) { return p.setting.family == family; });
  });
}

/// Its last line [px].
double draw_legend(Svg& svg, const std::vector<ChartScene>& scenes, double width,
                   const Theme& theme) {
  constexpr double kText = 11.0;
  Point at{kLeft, 48.0};
  const auto next = [&](const std::string& words, auto&& sample) {
    const double room = 18.0 + text_width(words, kText) + 14.0;
    if (at.x + room > width - kRight) at = {kLeft, at.y + 18.0};
    sample(Point{at.x + 6.0, at.y - 4.0});
    svg.text({at.x + 18.0, at.y}, words, {theme.ink, kText});
    at.x += room;
  };
  for (const Look& look : chart_looks()) {
    if (!occurs(scenes, look.family)) continue;
    next(look.words, [&](Point c) { draw_mark(svg, c, look.family); });
  }
  next("Pareto front", [&](Point c) {
    svg.line({c.x - 7.0, c.y}, {c.x + 8.0, c.y}, {"#46536a", 1.6, "1.5 3"});
  });
  next("uncertainty of the reference", [&](Point c) {
    svg.rect({c.x - 6.0, c.y - 5.0, 13.0, 10.0}, "#dfe3e8");
  });
  next("← ↑ ↓  beyond the rim", [](Point) {});
  next("failed, by name", [&](Point c) { draw_cross(svg, c, theme.ink); });
  return at.y;
}

}  // namespace

std::string chart_svg(const std::vector<ChartScene>& scenes) {
  const Theme theme = print_theme();
  const auto columns = static_cast<double>(std::max<std::size_t>(scenes.size(), 2));
  const double width = kLeft + columns * (kPanelWidth + kGap) - kGap + kRight;
  Svg measured(width, 0.0);
  const double first = draw_legend(measured, scenes, width, theme) + kUnderLegend;
  const double height = first + kChartQuantities * (kPanelHeight + kGap) - kGap + kBottom;
  Svg svg(width, height);
  svg.rect({0.0, 0.0, width, height}, theme.paper);
  svg.text({kLeft, 26.0}, "Error against wall time of a cold solve, one thread",
           {theme.ink, 16.0, Anchor::start, true});
  draw_legend(svg, scenes, width, theme);
  for (int q = 0; q < kChartQuantities; ++q) {
    const LogAxis y = error_axis(scenes, q);
    const double top = first + q * (kPanelHeight + kGap);
    svg.text({20.0, top + 0.5 * kPanelHeight}, row_look(q).title,
             {theme.ink, 11.5, Anchor::middle, false, true});
    for (std::size_t c = 0; c < scenes.size(); ++c) {
      const double left = kLeft + static_cast<double>(c) * (kPanelWidth + kGap);
      const LogPanel panel{{left, top, kPanelWidth, kPanelHeight}, time_axis(scenes[c]), y};
      const bool bottom = q + 1 == kChartQuantities;
      if (q == 0)
        svg.text({left, top - 8.0}, scenes[c].title, {theme.ink, 12.5, Anchor::start, true});
      draw_chart_panel(svg, panel, scenes[c], q, bottom, c == 0, theme);
      if (!bottom) continue;
      svg.text({left + 0.5 * kPanelWidth, panel.box.bottom() + 34.0}, "wall time [ms]",
               {theme.ink, 11.5, Anchor::middle});
    }
  }
  return svg.document(
      "Error of friction torque, smallest film and highest temperature against "
      "wall time, for grids, tiers and methods");
}

}  // namespace shellback::validation
