#include "app/pictures/svg_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellback::app {
namespace {

constexpr double kLinesLeft = 56.0;    ///< room for the y axis [px]
constexpr double kLinesRight = 12.0;   ///< [px]
constexpr double kLinesTop = 44.0;     ///< room for title and legend [px]
constexpr double kLinesBottom = 38.0;  ///< room for the x axis [px]

/// The y axis holds the lines, and of their bars what is no longer than the lines are far from
/// zero: longer ones would flatten all else. `height` of the frame [px].
Axis y_axis(const LinePlot& plot, double height) {
  constexpr double kTick = 20.0;  // between ticks, so that figures do not touch [px]
  const int ticks = std::clamp(static_cast<int>(height / kTick), 2, 6);

  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& series : plot.series) {
    for (const double v : series.y) {
      if (!std::isfinite(v)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
  if (low > high) low = high = 0.0;
  const double most = std::max(std::abs(low), std::abs(high));
  const double least_shown = low - most, most_shown = high + most;
  for (const auto& series : plot.series) {
    for (std::size_t k = 0; k < series.bar.size(); ++k) {
      const double v = series.y[k], bar = series.bar[k];
      if (!std::isfinite(v + bar)) continue;
      low = std::min(low, std::max(v - bar, least_shown));
      high = std::max(high, std::min(v + bar, most_shown));
    }
  }
  if (plot.from_zero) low = std::min(low, 0.0);
  return round_axis(low, high, ticks, plot.y_title);
}

/// Where the bars are known, between lines that are. One area for all of it, each stretch from left
/// to right: a line that comes back over itself is shaded once, not rubbed out.
void draw_band(Svg& svg, const Frame& frame, const Series& s) {
  constexpr double kOpacity = 0.22;  // lines of other series stay legible through it
  const auto known = [&](std::size_t k) { return std::isfinite(s.y[k] + s.bar[k]); };
  std::string path;
  for (std::size_t k = 1; k < s.bar.size(); ++k) {
    if (!known(k - 1) || !known(k)) continue;
    const bool onward = s.x[k] >= s.x[k - 1];
    const std::size_t l = onward ? k - 1 : k, r = onward ? k : k - 1;
    path += line_path({frame.at(s.x[l], s.y[l] + s.bar[l]), frame.at(s.x[r], s.y[r] + s.bar[r]),
                       frame.at(s.x[r], s.y[r] - s.bar[r]), frame.at(s.x[l], s.y[l] - s.bar[l])}) +
            "Z";
  }
  if (!path.empty()) svg.shade(path, s.colour, kOpacity);
}

/// The k-th point of a series.
void draw_dot(Svg& svg, const Frame& frame, const Series& s, std::size_t k) {
  constexpr double kDot = 2.6;  // [px]
  if (k < s.bar.size() && std::isfinite(s.bar[k])) {
    svg.line(frame.at(s.x[k], s.y[k] - s.bar[k]), frame.at(s.x[k], s.y[k] + s.bar[k]),
             {s.colour, 0.9, ""});
  }
  svg.circle(frame.at(s.x[k], s.y[k]), kDot, s.colour, {s.colour, 0.5, ""});
}

void draw_series(Svg& svg, const Frame& frame, const Series& series) {
  std::string path;
  std::vector<Point> run;
  const auto flush = [&](std::size_t end) {
    if (run.size() > 1) path += line_path(run);
    if (run.size() == 1 && series.dots) draw_dot(svg, frame, series, end - 1);
    run.clear();
  };
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    if (std::isfinite(series.y[k])) {
      run.push_back(frame.at(series.x[k], series.y[k]));
    } else {
      flush(k);
    }
  }
  flush(series.x.size());
  svg.stroke(path, {series.colour, 1.8, series.dash});
}

void draw_legend(Svg& svg, Point at, const LinePlot& plot, const Theme& theme) {
  for (const auto& series : plot.series) {
    if (series.name.empty()) continue;
    svg.line({at.x, at.y - 3.5}, {at.x + 20.0, at.y - 3.5}, {series.colour, 2.2, series.dash});
    svg.text({at.x + 25.0, at.y}, series.name, {theme.muted, 10.5});
    at.x += 25.0 + text_width(series.name, 10.5) + 16.0;
  }
}

}  // namespace

Frame draw_lines(Svg& svg, const Box& box, const LinePlot& plot, const Theme& theme) {
  const double height = box.height - kLinesTop - kLinesBottom;
  const Frame frame{
      {box.x + kLinesLeft, box.y + kLinesTop, box.width - kLinesLeft - kLinesRight, height},
      plot.x,
      plot.y ? *plot.y : y_axis(plot, height)};
  svg.text({frame.box.x, box.y + 14.0}, plot.title, {theme.ink, 12.5, Anchor::start, true});
  draw_legend(svg, {frame.box.x, box.y + 34.0}, plot, theme);
  draw_axes(svg, frame, theme, GridLines::horizontal);
  svg.begin_clip(frame.box);
  for (const auto& series : plot.series) draw_band(svg, frame, series);
  for (const auto& series : plot.series) draw_series(svg, frame, series);
  svg.end_clip();
  return frame;
}

}  // namespace shellback::app
