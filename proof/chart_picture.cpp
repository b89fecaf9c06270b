#include "proof/chart_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/svg_lines.hpp"
#include "proof/log_panel.hpp"

namespace shellback::proof {
namespace {

using namespace app;

constexpr double kPanelWidth = 268.0;
constexpr double kPanelHeight = 216.0;
constexpr double kGap = 18.0;   ///< between panels
constexpr double kLeft = 74.0;  ///< room for the labels of y
constexpr double kRight = 16.0;
constexpr double kTop = 118.0;    ///< room for title, legend and names
constexpr double kBottom = 52.0;  ///< room for the labels of x
constexpr double kMark = 4.2;     ///< radius of a mark
constexpr double kMarkText = 10.0;
constexpr double kMilli = 1e3;

struct Look {
  ChartFamily family;
  const char* colour;  ///< after Okabe and Ito: told apart by colour-blind readers
  const char* words;
};
constexpr std::array<Look, 8> kLooks{{
    {ChartFamily::grid, "#0072b2", "grid: cells around, ours (active set, 5 nodes, Newton)"},
    {ChartFamily::nodes, "#56b4e9", "3, 7, 9 Lobatto nodes"},
    {ChartFamily::layers, "#e69f00", "10, 20, 40 even layers"},
    {ChartFamily::mean, "#a06000", "film-mean temperature"},
    {ChartFamily::tier, "#009e73", "simpler tier"},
    {ChartFamily::cavitation, "#cc79a7", "cavitation: FB Newton, p-θ relaxation, Swift-Stieber"},
    {ChartFamily::elastic, "#d55e00", "elastic fixed point: Aitken, 0.05"},
    {ChartFamily::automatic, "#000000", "auto, to its tolerance"},
}};
const Look& look_of(ChartFamily family) { return kLooks[static_cast<std::size_t>(family)]; }

std::string polygon(Point c, double r, int corners, double turn) {
  std::string path;
  for (int k = 0; k < corners; ++k) {
    const double a = turn + 2.0 * 3.14159265358979 * k / corners;
    path += fmt::format("{}{} {}", k == 0 ? "M" : "L", coordinate(c.x + r * std::sin(a)),
                        coordinate(c.y - r * std::cos(a)));
  }
  return path + "Z";
}

void draw_mark(Svg& svg, Point c, ChartFamily family, bool hollow) {
  const std::string colour = look_of(family).colour;
  const Stroke edge{colour, 1.5, ""};
  const std::string inside = hollow ? "#ffffff" : colour;
  const auto shape = [&](const std::string& path) {
    svg.fill(path, inside);
    svg.stroke(path, edge);
  };
  const double pi = 3.14159265358979;
  switch (family) {
    case ChartFamily::grid:
      return svg.circle(c, kMark, inside, edge);
    case ChartFamily::nodes:
      return svg.circle(c, 0.8 * kMark, inside, edge);
    case ChartFamily::layers:
      return shape(polygon(c, 1.2 * kMark, 4, 0.25 * pi));
    case ChartFamily::mean:
      return shape(polygon(c, 1.2 * kMark, 3, 0.0));
    case ChartFamily::tier:
      return shape(polygon(c, 1.3 * kMark, 4, 0.0));
    case ChartFamily::cavitation:
      return shape(polygon(c, 1.2 * kMark, 6, 0.0));
    case ChartFamily::elastic:
      return shape(polygon(c, 1.3 * kMark, 3, pi));
    case ChartFamily::automatic:
      return shape(polygon(c, 1.4 * kMark, 5, 0.0));
  }
}

/// Puts words beside marks where they cover least.
class Labels {
 public:
  explicit Labels(Box inside) : inside_(inside) {}
  void block(Point c, double r) { taken_.push_back({c.x - r, c.y - r, 2.0 * r, 2.0 * r}); }
  void put(Svg& svg, Point c, const std::string& words, const std::string& colour) {
    const double w = text_width(words, kMarkText);
    const double h = 0.95 * kMarkText;
    const double d = kMark + 3.0;
    const std::array<Box, 8> places{{{c.x + d, c.y - 0.5 * h, w, h},
                                     {c.x - d - w, c.y - 0.5 * h, w, h},
                                     {c.x - 0.5 * w, c.y - d - h, w, h},
                                     {c.x - 0.5 * w, c.y + d, w, h},
                                     {c.x + 0.7 * d, c.y - 0.7 * d - h, w, h},
                                     {c.x + 0.7 * d, c.y + 0.7 * d, w, h},
                                     {c.x - 0.7 * d - w, c.y - 0.7 * d - h, w, h},
                                     {c.x - 0.7 * d - w, c.y + 0.7 * d, w, h}}};
    const Box* best = &places.front();
    double least = std::numeric_limits<double>::infinity();
    for (const Box& place : places) {
      const double cover = covered(place);
      if (cover < least - 1e-9) {
        least = cover;
        best = &place;
      }
    }
    taken_.push_back(*best);
    svg.text({best->x, best->bottom() - 0.15 * h}, words,
             {colour, kMarkText, Anchor::start, false, false, "#ffffff"});
  }

 private:
  [[nodiscard]] double covered(const Box& b) const {
    const auto common = [](const Box& p, const Box& q) {
      const double w = std::min(p.right(), q.right()) - std::max(p.x, q.x);
      const double h = std::min(p.bottom(), q.bottom()) - std::max(p.y, q.y);
      return w > 0.0 && h > 0.0 ? w * h : 0.0;
    };
    double sum = b.width * b.height - common(b, inside_);
    sum *= 4.0;  // words outside the frame are worse than words on words
    for (const Box& t : taken_) sum += common(b, t);
    return sum;
  }
  Box inside_;
  std::vector<Box> taken_;
};

struct RowLook {
  const char* title;
  double unit;  ///< shown per unit of ChartPoint::error
};
constexpr std::array<RowLook, kChartQuantities> kRows{{{"error in friction torque [%]", 100.0},
                                                       {"error in smallest film [%]", 100.0},
                                                       {"error in highest temperature [K]", 1.0}}};

/// Error as it is drawn: no lower than the reference is known.
double drawn_error(const ChartScene& scene, const ChartPoint& p, int q) {
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

LogAxis row_axis(const std::vector<ChartScene>& scenes, int q) {
  Range r;
  for (const ChartScene& s : scenes) {
    for (const ChartPoint& p : s.points) {
      if (std::isfinite(p.error[q])) r.take(drawn_error(s, p, q));
    }
  }
  return r.axis();
}

LogAxis column_axis(const ChartScene& scene) {
  Range r;
  for (const ChartPoint& p : scene.points) r.take(kMilli * p.wall_s);
  return r.axis();
}

void draw_floor(Svg& svg, const LogPanel& panel, double floor, const Theme& theme) {
  if (!(floor > panel.y.low)) return;
  const double y = panel.at(panel.x.low, std::min(floor, panel.y.high)).y;
  svg.rect({panel.box.x, y, panel.box.width, panel.box.bottom() - y}, "#eef0f3");
  svg.line({panel.box.x, y}, {panel.box.right(), y}, {theme.muted, 0.8, "2 3"});
}

/// The stairs below which no point lies.
void draw_front(Svg& svg, const LogPanel& panel, const ChartScene& scene, int q) {
  std::vector<const ChartPoint*> front;
  for (const ChartPoint& p : scene.points) {
    if (p.on_front[q]) front.push_back(&p);
  }
  std::sort(front.begin(), front.end(),
            [](const auto* a, const auto* b) { return a->wall_s < b->wall_s; });
  std::vector<Point> stairs;
  for (const ChartPoint* p : front) {
    const Point at = panel.at(kMilli * p->wall_s, drawn_error(scene, *p, q));
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
    line.push_back(panel.at(kMilli * p.wall_s, drawn_error(scene, p, q)));
  }
  if (line.size() > 1) svg.stroke(line_path(line), {look_of(ChartFamily::grid).colour, 1.2, ""});
}

/// A point off the first compared grid has a hollow mark.
bool hollow(const ChartScene& scene, const ChartPoint& p) {
  if (p.setting.family == ChartFamily::grid || p.setting.family == ChartFamily::automatic) {
    return false;
  }
  int finest = 0;
  for (const ChartPoint& other : scene.points) {
    if (other.setting.family == p.setting.family) finest = std::max(finest, other.setting.grid[0]);
  }
  return p.setting.grid[0] < finest;
}

void draw_points(Svg& svg, const LogPanel& panel, const ChartScene& scene, int q) {
  Labels labels(panel.box);
  std::vector<std::pair<Point, const ChartPoint*>> marks;
  for (const ChartPoint& p : scene.points) {
    if (!std::isfinite(p.error[q])) continue;
    const Point at = panel.at(kMilli * p.wall_s, drawn_error(scene, p, q));
    draw_mark(svg, at, p.setting.family, hollow(scene, p));
    labels.block(at, kMark);
    marks.emplace_back(at, &p);
  }
  for (const ChartPoint& p : scene.points) {
    if (p.verdict.good()) continue;
    const Point at{panel.at(kMilli * p.wall_s, panel.y.high).x, panel.box.y + 8.0};
    const Stroke ink{look_of(p.setting.family).colour, 2.0, ""};
    svg.line({at.x - kMark, at.y - kMark}, {at.x + kMark, at.y + kMark}, ink);
    svg.line({at.x - kMark, at.y + kMark}, {at.x + kMark, at.y - kMark}, ink);
    labels.block(at, kMark);
    marks.emplace_back(at, &p);
  }
  for (const auto& [at, p] : marks) {
    labels.put(svg, at, p->setting.mark, look_of(p->setting.family).colour);
  }
}

void draw_panel(Svg& svg, const LogPanel& panel, const ChartScene& scene, int q, bool left,
                bool bottom, const Theme& theme) {
  draw_floor(svg, panel, kRows[q].unit * scene.floor[q], theme);
  draw_log_panel(svg, panel, theme, bottom, left);
  const bool any = std::any_of(scene.points.begin(), scene.points.end(),
                               [&](const ChartPoint& p) { return std::isfinite(p.error[q]); });
  if (!any) {
    const bool failed = !scene.verdict.good() && scene.points.empty();
    svg.text({panel.box.x + 0.5 * panel.box.width, panel.box.y + 0.5 * panel.box.height},
             failed ? "no reference" : "one temperature throughout",
             {theme.muted, 11.0, Anchor::middle});
    return;
  }
  draw_front(svg, panel, scene, q);
  draw_ladder(svg, panel, scene, q);
  draw_points(svg, panel, scene, q);
}

bool occurs(const std::vector<ChartScene>& scenes, ChartFamily family) {
  return std::any_of(scenes.begin(), scenes.end(), [&](const ChartScene& s) {
    return std::any_of(s.points.begin(), s.points.end(),
                       [&](const ChartPoint& p) { return p.setting.family == family; });
  });
}

void draw_legend(Svg& svg, const std::vector<ChartScene>& scenes, double width,
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
  for (const Look& look : kLooks) {
    if (!occurs(scenes, look.family)) continue;
    next(look.words, [&](Point c) { draw_mark(svg, c, look.family, false); });
  }
  next("hollow: on the coarser grid", [&](Point c) { draw_mark(svg, c, ChartFamily::tier, true); });
  next("Pareto front", [&](Point c) {
    svg.line({c.x - 7.0, c.y}, {c.x + 8.0, c.y}, {"#46536a", 1.6, "1.5 3"});
  });
  next("uncertainty of the reference", [&](Point c) {
    svg.rect({c.x - 6.0, c.y - 5.0, 13.0, 10.0}, "#dfe3e8");
  });
  next("failed, by name", [&](Point c) {
    const Stroke ink{theme.ink, 2.0, ""};
    svg.line({c.x - kMark, c.y - kMark}, {c.x + kMark, c.y + kMark}, ink);
    svg.line({c.x - kMark, c.y + kMark}, {c.x + kMark, c.y - kMark}, ink);
  });
}

}  // namespace

std::string chart_svg(const std::vector<ChartScene>& scenes) {
  const Theme theme = print_theme();
  const auto columns = static_cast<double>(std::max<std::size_t>(scenes.size(), 2));
  const double width = kLeft + columns * (kPanelWidth + kGap) - kGap + kRight;
  const double height = kTop + kChartQuantities * (kPanelHeight + kGap) - kGap + kBottom;
  Svg svg(width, height);
  svg.rect({0.0, 0.0, width, height}, theme.paper);
  svg.text({kLeft, 26.0}, "Error against wall time of a cold solve, one thread",
           {theme.ink, 16.0, Anchor::start, true});
  draw_legend(svg, scenes, width, theme);
  for (int q = 0; q < kChartQuantities; ++q) {
    const LogAxis y = row_axis(scenes, q);
    const double top = kTop + q * (kPanelHeight + kGap);
    svg.text({20.0, top + 0.5 * kPanelHeight}, kRows[q].title,
             {theme.ink, 11.5, Anchor::middle, false, true});
    for (std::size_t c = 0; c < scenes.size(); ++c) {
      const double left = kLeft + static_cast<double>(c) * (kPanelWidth + kGap);
      const LogPanel panel{{left, top, kPanelWidth, kPanelHeight}, column_axis(scenes[c]), y};
      const bool bottom = q + 1 == kChartQuantities;
      if (q == 0)
        svg.text({left, top - 8.0}, scenes[c].title, {theme.ink, 12.5, Anchor::start, true});
      draw_panel(svg, panel, scenes[c], q, c == 0, bottom, theme);
      if (!bottom) continue;
      svg.text({left + 0.5 * kPanelWidth, panel.box.bottom() + 34.0}, "wall time [ms]",
               {theme.ink, 11.5, Anchor::middle});
    }
  }
  return svg.document(
      "Error of friction torque, smallest film and highest temperature against "
      "wall time, for grids, tiers and methods");
}

}  // namespace shellback::proof
