#include "validation/chart/chart_panel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "validation/chart/chart_marks.hpp"
#include "validation/chart/pareto.hpp"

namespace shellback::validation {

using namespace app;
using bearing::Tier;

namespace {

constexpr double kMilli = 1e3;
constexpr double kTogether = 5.0;  ///< marks of one family nearer than this share their words [px]

constexpr std::array<RowLook, kChartQuantities> kRows{
    {{"error in friction torque [%]", 100.0, 0.01, 100.0},
     {"error in smallest film [%]", 100.0, 0.01, 100.0},
     {"error in highest temperature [K]", 1.0, 0.01, 100.0}}};

/// Error in the unit of the row, no lower than the reference is known.
double shown_error(const ChartScene& scene, const ChartPoint& p, int q) {
  return kRows[q].unit * std::max(p.error[q], scene.floor[q]);
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  void take(double v) {
    if (!std::isfinite(v) || !(v > 0.0)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  [[nodiscard]] LogAxis axis() const { return high > 0.0 ? log_axis(low, high) : log_axis(1, 10); }
};

/// Where a point stands, and the arrows of the rims that hold it.
struct Place {
  Point at;
  std::string arrows;
};

Place place_of(const LogPanel& panel, const ChartScene& scene, const ChartPoint& p, int q) {
  const double time = kMilli * p.wall_s;
  const double error = shown_error(scene, p, q);
  Place place;
  if (time < panel.x.low) place.arrows += "←";
  if (error < panel.y.low) place.arrows += "↓";
  if (error > panel.y.high) place.arrows += "↑";
  place.at = panel.at(std::clamp(time, panel.x.low, panel.x.high),
                      std::clamp(error, panel.y.low, panel.y.high));
  return place;
}

void draw_floor(Svg& svg, const LogPanel& panel, double floor, const Theme& theme) {
  if (!(floor > panel.y.low)) return;
  const double y = panel.at(panel.x.low, std::min(floor, panel.y.high)).y;
  svg.rect({panel.box.x, y, panel.box.width, panel.box.bottom() - y}, "#eef0f3");
  svg.line({panel.box.x, y}, {panel.box.right(), y}, {theme.muted, 0.8, "2 3"});
}

/// Coarser of two grids on which the same is compared: in the numbers, not in the picture.
bool repeated(const ChartScene& scene, const ChartPoint& p) {
  if (p.setting.family == ChartFamily::grid) return false;
  return std::any_of(scene.points.begin(), scene.points.end(), [&](const ChartPoint& other) {
    return other.setting.family == p.setting.family && other.setting.mark == p.setting.mark &&
           other.setting.grid[0] > p.setting.grid[0];
  });
}

/// The stairs below which no drawn point lies.
void draw_front(Svg& svg, const LogPanel& panel, const ChartScene& scene, int q) {
  std::vector<CostError> points;
  for (const ChartPoint& p : scene.points) {
    points.push_back({repeated(scene, p) ? NAN : p.wall_s, p.error[q]});
  }
  std::vector<Point> stairs;
  for (const int k : pareto_front(points, scene.floor[q])) {
    const Point at = place_of(panel, scene, scene.points[k], q).at;
    stairs.push_back({at.x, stairs.empty() ? panel.box.y : stairs.back().y});
    stairs.push_back(at);
  }
  if (stairs.empty()) return;
  stairs.push_back({panel.box.right(), stairs.back().y});
  svg.stroke(line_path(stairs), {"#46536a", 1.6, "1.5 3"});
}

/// The grids one after the other.
void draw_ladder(Svg& svg, const LogPanel& panel, const ChartScene& scene, int q) {
  std::vector<Point> line;
  for (const ChartPoint& p : scene.points) {
    if (p.setting.family != ChartFamily::grid || !std::isfinite(p.error[q])) continue;
    line.push_back(place_of(panel, scene, p, q).at);
  }
  if (line.size() > 1) svg.stroke(line_path(line), {look_of(ChartFamily::grid).colour, 1.2, ""});
}

/// A mark with its words; marks that coincide are one.
struct Labelled {
  Point at;
  ChartFamily family;
  std::string words;
};

void join(std::vector<Labelled>& marks, Labelled mark) {
  for (Labelled& other : marks) {
    const double apart = std::hypot(other.at.x - mark.at.x, other.at.y - mark.at.y);
    if (other.family != mark.family || apart > kTogether) continue;
    other.words += ", " + mark.words;
    return;
  }
  marks.push_back(std::move(mark));
}

void draw_points(Svg& svg, const LogPanel& panel, const ChartScene& scene, int q) {
  WordsBesideMarks labels(panel.box);
  std::vector<Labelled> marks;
  for (const ChartPoint& p : scene.points) {
    if (!std::isfinite(p.error[q]) || repeated(scene, p)) continue;
    const Place place = place_of(panel, scene, p, q);
    draw_mark(svg, place.at, p.setting.family);
    labels.block(place.at, kMark);
    const std::string space = place.arrows.empty() ? "" : " ";
    join(marks, {place.at, p.setting.family, p.setting.mark + space + place.arrows});
  }
  for (const ChartPoint& p : scene.points) {
    if (p.verdict.good() || repeated(scene, p)) continue;
    const double time = std::clamp(kMilli * p.wall_s, panel.x.low, panel.x.high);
    const Point at{panel.at(time, panel.y.high).x, panel.box.y + 10.0};
    draw_cross(svg, at, look_of(p.setting.family).colour);
    labels.block(at, kMark);
    join(marks, {at, p.setting.family, p.setting.mark});
  }
  for (const Labelled& m : marks) labels.put(svg, m.at, m.words, look_of(m.family).colour);
}

}  // namespace

const RowLook& row_look(int quantity) { return kRows[quantity]; }

LogAxis error_axis(const std::vector<ChartScene>& scenes, int q) {
  Range r;
  for (const ChartScene& s : scenes) {
    for (const ChartPoint& p : s.points) {
      if (!std::isfinite(p.error[q])) continue;
      r.take(std::clamp(shown_error(s, p, q), kRows[q].low, kRows[q].high));
    }
  }
  return r.axis();
}

LogAxis time_axis(const ChartScene& scene) {
  Range r;
  for (const ChartPoint& p : scene.points) {
    if (p.setting.tier != Tier::estimate) r.take(kMilli * p.wall_s);
  }
  return r.axis();
}

void draw_chart_panel(Svg& svg, const LogPanel& panel, const ChartScene& scene, int q,
                      bool x_labels, bool y_labels, const Theme& theme) {
  draw_floor(svg, panel, kRows[q].unit * scene.floor[q], theme);
  draw_log_panel(svg, panel, theme, x_labels, y_labels);
  const bool any = std::any_of(scene.points.begin(), scene.points.end(),
                               [&](const ChartPoint& p) { return std::isfinite(p.error[q]); });
  if (!any) {
    const bool none = scene.points.empty();
    const bool found = std::any_of(scene.points.begin(), scene.points.end(),
                                   [](const ChartPoint& p) { return p.verdict.good(); });
    svg.text({panel.box.x + 0.5 * panel.box.width, panel.box.y + 0.5 * panel.box.height},
             !scene.verdict.good() && none ? "no reference"
             : !found                      ? "no result"
                                           : "one temperature throughout",
             {theme.muted, 11.0, Anchor::middle});
    return;
  }
  draw_front(svg, panel, scene, q);
  draw_ladder(svg, panel, scene, q);
  draw_points(svg, panel, scene, q);
}

}  // namespace shellback::validation
