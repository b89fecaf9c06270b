#include "app/pictures/svg_map.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace shellback::app {
namespace {

constexpr double kMapLeft = 50.0;    ///< room for the y axis [px]
constexpr double kMapRight = 62.0;   ///< room for the colour bar [px]
constexpr double kMapTop = 24.0;     ///< room for the title [px]
constexpr double kMapBottom = 38.0;  ///< room for the x axis [px]
constexpr double kFullFilm = 0.995;  ///< fill ratio above which the film counts as full [-]
constexpr const char* kLight = "#ffffff";
constexpr const char* kDark = "#10151d";

void draw_outlines(Svg& svg, const Frame& frame, const FieldMap& map) {
  for (const auto& outline : map.outlines) {
    std::vector<Point> points;
    for (const auto& p : outline) points.push_back(frame.at(p.x, p.y));
    const std::string path = line_path(points) + "Z";
    svg.stroke(path, {kDark, 3.0, ""});  // dark beneath light shows on any colour
    svg.stroke(path, {kLight, 1.4, ""});
  }
}

void draw_mark(Svg& svg, const Frame& frame, const Mark& mark) {
  const Point p = frame.at(mark.at.x, mark.at.y);
  svg.circle(p, 3.6, "none", {kDark, 3.2, ""});
  svg.circle(p, 3.6, "none", {kLight, 1.6, ""});
  const bool turn_left = p.x > frame.box.x + 0.62 * frame.box.width;
  const double y = std::clamp(p.y + 4.0, frame.box.y + 14.0, frame.box.bottom() - 6.0);
  svg.text({turn_left ? p.x - 9.0 : p.x + 9.0, y}, mark.label,
           {kLight, 11.0, turn_left ? Anchor::end : Anchor::start, true, false, kDark});
}

}  // namespace

void draw_colour_bar(Svg& svg, const Box& plot, const ColourScale& scale, const std::string& unit,
                     const Theme& theme) {
  constexpr int kSlices = 48;
  const Box bar{plot.right() + 10.0, plot.y, 11.0, plot.height};
  for (int k = 0; k < kSlices; ++k) {
    const double height = bar.height / kSlices;
    // Each slice reaches down to the bottom, so that no seam shows between two of them.
    const Box slice{bar.x, bar.y + k * height, bar.width, bar.height - k * height};
    svg.rect(slice, colour_at(scale.map, 1.0 - (k + 0.5) / kSlices));
  }
  svg.frame(bar, {theme.muted, 0.8, ""});
  const int most = std::max(2, static_cast<int>(plot.height / 26.0));
  const Frame frame{bar, {}, tight_axis(scale.low, scale.high, most, "")};
  for (const double tick : frame.y.ticks) {
    const double y = frame.at(0.0, tick).y;
    svg.line({bar.right(), y}, {bar.right() + 3.0, y}, {theme.muted, 1.0, ""});
    svg.text({bar.right() + 6.0, y + 3.6}, tick_label(frame.y, tick), {theme.muted, 10.5});
  }
  svg.text({bar.x + 0.5 * bar.width, plot.y - 7.0}, unit, {theme.muted, 10.5, Anchor::middle});
}

Frame map_frame(const Box& box, const FieldMap& map) {
  return {{box.x + kMapLeft, box.y + kMapTop, box.width - kMapLeft - kMapRight,
           box.height - kMapTop - kMapBottom},
          map.x,
          map.y};
}

void draw_film(Svg& svg, const Frame& frame, const FieldMap& map, int bands) {
  const Place place = [&](double x, double y) { return frame.at(x, y); };
  draw_bands(svg, map.surface, map.scale, place, bands);
  if (map.full_film && drawable(map.full_film->value)) {
    svg.stroke(superlevel_path(*map.full_film, kFullFilm, place), {kLight, 1.2, "4 3"});
  }
}

void draw_surroundings(Svg& svg, const Frame& frame, const FieldMap& map, const Theme& theme) {
  svg.begin_clip(frame.box);
  draw_outlines(svg, frame, map);
  svg.end_clip();
  for (const auto& mark : map.marks) draw_mark(svg, frame, mark);
  draw_colour_bar(svg, frame.box, map.scale, map.unit, theme);
}

void draw_map(Svg& svg, const Box& box, const FieldMap& map, const Theme& theme) {
  const Frame frame = map_frame(box, map);
  svg.text({frame.box.x, box.y + 14.0}, map.title, {theme.ink, 12.5, Anchor::start, true});
  const bool shown = drawable(map.surface.value);
  if (shown) {
    svg.begin_clip(frame.box);
    draw_film(svg, frame, map);
    svg.end_clip();
    draw_surroundings(svg, frame, map, theme);
  }
  draw_axes(svg, frame, theme, GridLines::none);
  if (!shown) {
    svg.text({frame.box.x + 0.5 * frame.box.width, frame.box.y + 0.5 * frame.box.height},
             "not drawn: the field holds values that are not numbers",
             {theme.more, 12.0, Anchor::middle});
  }
}

}  // namespace shellback::app
