#include "app/pictures/svg_orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/pictures/cycle_axis.hpp"
#include "bearing/bore_shape.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::app {
namespace {

using bearing::CycleInstant;
using bearing::CycleResult;

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator*(double f, Point a) { return {f * a.x, f * a.y}; }

constexpr double kOrbitTop = 24.0;   ///< room for the title [px]
constexpr double kRim = 34.0;        ///< around the clearance circle [px]
constexpr double kArrow = 0.24;      ///< arrow of the largest load over the radius of the circle
constexpr int kMostMarks = 8;        ///< instants with arrow and label
constexpr double kLabelRoom = 13.0;  ///< from a mark to its label [px]
constexpr double kMark = 2.6;        ///< radius of a mark [px]
constexpr int kRoomAngles = 360;     ///< at which the room in the bore is looked at
constexpr double kMostRoom = 2.0;    ///< of it that is shown, in clearances
constexpr double kSeen = 0.01;       ///< of the clearance: less is no wider than its line

double largest_load(const CycleResult& cycle) {
  double largest = 0.0;
  for (const CycleInstant& i : cycle.instants) {
    largest = std::max(largest, std::hypot(i.load_x, i.load_y));
  }
  return largest;
}

/// How far out the picture reaches, in clearances: the circle, the room in the bore, or a journal
/// that an elastic shell lets beyond it; `arrow`: with arrows of this length at the largest load.
double reach(const CycleResult& cycle, double c, const std::vector<double>& room, double arrow) {
  const double by_load = largest_load(cycle) > 0.0 ? arrow / largest_load(cycle) : 0.0;
  double farthest = std::max(1.0, std::min(shellback::largest(room) / c, kMostRoom));
  for (const CycleInstant& i : cycle.instants) {
    const double tip = std::hypot(i.ex / c + by_load * i.load_x, i.ey / c + by_load * i.load_y);
    const double e = std::max(std::hypot(i.ex, i.ey) / c, tip);
    if (std::isfinite(e)) farthest = std::max(farthest, e);
  }
  return farthest;
}

/// A straight line with a head at its end.
void draw_arrow(Svg& svg, Point from, Point to, const std::string& colour) {
  constexpr double kHead = 5.0;  // [px]
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 1.0)) return;
  const double ux = (to.x - from.x) / length;
  const double uy = (to.y - from.y) / length;
  svg.line(from, to, {colour, 1.3, ""});
  const Point foot{to.x - kHead * ux, to.y - kHead * uy};
  const double half = 0.45 * kHead;
  svg.fill(line_path({to,
                      {foot.x - half * uy, foot.y + half * ux},
                      {foot.x + half * uy, foot.y - half * ux}}) +
               "Z",
           colour);
}

/// The instant nearest to `x` on the axis of the cycle.
const CycleInstant& nearest(const CycleResult& cycle, double x) {
  const auto off = [&](const CycleInstant& i) { return std::abs(on_axis(cycle, i.t) - x); };
  return *std::min_element(
      cycle.instants.begin(), cycle.instants.end(),
      [&](const CycleInstant& a, const CycleInstant& b) { return off(a) < off(b); });
}

/// Round instants after the start and before the end.
std::vector<double> round_instants(const Axis& axis) {
  std::vector<double> inside;
  const auto n = axis.ticks.size();
  const std::size_t stride = n > kMostMarks + 2 ? 2 : 1;
  for (std::size_t k = 0; k < n; k += stride) {
    const double tick = axis.ticks[k];
    if (tick > axis.low && tick < axis.high) inside.push_back(tick);
  }
  return inside;
}

/// Where the letters of the axes stand: beyond circle and path, which reach as far as `most`.
std::array<Point, 2> letters(const OrbitFrame& frame, double most) {
  return {frame.at(most, 0.0) + Point{11.0, 4.0}, frame.at(0.0, most) + Point{0.0, -7.0}};
}

void draw_circles(Svg& svg, const OrbitFrame& frame, double most, bool round, const Theme& theme) {
  for (const double ratio : {0.25, 0.5, 0.75}) {
    svg.circle(frame.centre, ratio * frame.radius, "none", {theme.rule, 1.0, ""});
  }
  const auto spoke = [&](Point a, Point b) { svg.line(a, b, {theme.rule, 1.0, ""}); };
  spoke(frame.at(-1.0, 0.0), frame.at(1.0, 0.0));
  spoke(frame.at(0.0, -1.0), frame.at(0.0, 1.0));
  svg.circle(frame.centre, frame.radius, "none",
             round ? Stroke{theme.muted, 1.4, ""} : Stroke{theme.rule, 1.0, ""});
  const TextStyle small{theme.muted, 10.5, Anchor::middle};
  const auto [x, y] = letters(frame, most);
  svg.text(x, "X", small);
  svg.text(y, "Y", small);
  const Point half = frame.at(0.5, 0.0);
  svg.text({half.x + 3.0, half.y + 12.0}, "0.5", {theme.muted, 9.5});
}

/// Where the centre of a rigid journal can come to in a bore that is no cylinder.
void draw_room(Svg& svg, const OrbitFrame& frame, double c, const std::vector<double>& room,
               const Theme& theme) {
  std::vector<Point> line;
  const std::size_t n = room.size();
  for (std::size_t k = 0; k <= n; ++k) {
    const double theta = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(n);
    const double r = std::min(room[k % n] / c, kMostRoom);
    line.push_back(frame.at(r * std::cos(theta), r * std::sin(theta)));
  }
  svg.stroke(line_path(line), {theme.muted, 1.4, ""});
}

/// Round instants: a dot, the load's arrow, and what instant it is, outwards of the path.
void draw_instants(Svg& svg, const OrbitFrame& frame, double most, double c,
                   const CycleResult& cycle, const Theme& theme) {
  const Axis axis = cycle_axis(cycle);
  const double largest = largest_load(cycle);
  const auto taken = letters(frame, most);
  std::vector<Point> labels(taken.begin(), taken.end());
  for (const double x : round_instants(axis)) {
    const CycleInstant& i = nearest(cycle, x);
    const Point p = frame.at(i.ex / c, i.ey / c);
    const double load = std::hypot(i.load_x, i.load_y);
    const Point to = load > 0.0 ? Point{i.load_x / load, -i.load_y / load} : Point{-1.0, 0.0};
    svg.circle(p, kMark, theme.paper, {theme.series[0], 1.5, ""});
    if (largest > 0.0) {  // from the mark's rim on: a small load is seen, too
      const double length = kArrow * frame.radius * load / largest;
      draw_arrow(svg, p + kMark * to, p + (kMark + length) * to, theme.more);
    }
    // The label stands on the side away from the load.
    const Point at = p + -kLabelRoom * to + Point{0.0, 3.5};
    const auto near = [&](const Point& other) {
      return std::abs(other.x - at.x) < 24.0 && std::abs(other.y - at.y) < 11.0;
    };
    if (std::any_of(labels.begin(), labels.end(), near)) continue;
    labels.push_back(at);
    svg.text(at, tick_label(axis, x), {theme.ink, 10.0, Anchor::middle, false, false, theme.paper});
  }
}

std::string path_of(const OrbitFrame& frame, double c, const CycleResult& cycle) {
  std::vector<Point> points;
  for (const CycleInstant& i : cycle.instants) points.push_back(frame.at(i.ex / c, i.ey / c));
  return points.size() > 1 ? line_path(points) : "";
}

/// What the path spans.
struct Span {
  Point middle;       ///< eccentricity ratios
  double half = 0.0;  ///< of the longer side [-]
};

Span span_of(double c, const CycleResult& cycle) {
  Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const CycleInstant& i : cycle.instants) {
    low = {std::min(low.x, i.ex / c), std::min(low.y, i.ey / c)};
    high = {std::max(high.x, i.ex / c), std::max(high.y, i.ey / c)};
  }
  return {0.5 * (low + high), 0.5 * std::max(high.x - low.x, high.y - low.y)};
}

/// A path that start and arrows hide, once more and larger, on the far side of the circle's middle.
void draw_small_path(Svg& svg, const OrbitFrame& frame, double c, const CycleResult& cycle,
                     const Theme& theme) {
  constexpr double kSmall = 0.08;  // of the clearance: some marks wide
  constexpr double kInset = 0.3;   // half the inset over the circle's radius
  constexpr double kFilled = 0.8;  // of the inset
  const Span span = span_of(c, cycle);
  if (!(span.half > 0.0) || !(span.half < kSmall)) return;
  const double off = std::hypot(span.middle.x, span.middle.y);
  const Point away = off > 0.0 ? (-1.0 / off) * span.middle : Point{1.0, 0.0};
  const double half = kInset * frame.radius;
  const Point middle = frame.at(0.5 * away.x, 0.5 * away.y);
  const double times = kFilled * kInset / span.half;
  const Box box{middle.x - half, middle.y - half, 2.0 * half, 2.0 * half};
  svg.rect(box, theme.paper);
  svg.frame(box, {theme.muted, 1.0, ""});
  std::vector<Point> path;
  for (const CycleInstant& i : cycle.instants) {
    path.push_back({middle.x + times * frame.radius * (i.ex / c - span.middle.x),
                    middle.y - times * frame.radius * (i.ey / c - span.middle.y)});
  }
  svg.stroke(line_path(path), {theme.series[0], 1.6, ""});
  svg.circle(path.front(), kMark, theme.series[0], {theme.paper, 1.0, ""});
  svg.text({box.x + 4.0, box.y + 12.0}, fmt::format("{:.2g} times", times),
           {theme.muted, 10.0, Anchor::start});
}

}  // namespace

OrbitFrame draw_orbit(Svg& svg, const Box& box, const bearing::Case& c, const CycleResult& cycle,
                      const Theme& theme) {
  const double clearance = c.bearing.radial_clearance;
  const double half = 0.5 * std::min(box.width, box.height - kOrbitTop) - kRim;
  const std::vector<double> room = bearing::room_around(c.bearing, kRoomAngles);
  const auto [least, widest] = std::minmax_element(room.begin(), room.end());
  const bool round = *widest - *least < kSeen * clearance;
  const double most = reach(cycle, clearance, room, kArrow);
  const OrbitFrame frame{{box.x + kRim + half, box.y + kOrbitTop + kRim + half}, half / most};
  svg.text({box.x, box.y + 14.0},
           round ? "Path of the journal; the circle is the cold clearance"
                 : "Path of the journal, and how far the bore lets it",
           {theme.ink, 12.5, Anchor::start, true});
  draw_circles(svg, frame, most, round, theme);
  if (!round) draw_room(svg, frame, clearance, room, theme);
  if (cycle.instants.empty()) return frame;
  svg.stroke(path_of(frame, clearance, cycle), {theme.series[0], 1.8, ""});
  draw_instants(svg, frame, most, clearance, cycle, theme);
  const CycleInstant& start = cycle.instants.front();
  const Point p = frame.at(start.ex / clearance, start.ey / clearance);
  svg.circle(p, 4.6, theme.series[0], {theme.paper, 1.2, ""});
  draw_small_path(svg, frame, clearance, cycle, theme);
  const double foot = box.y + kOrbitTop + 2.0 * (kRim + half);
  svg.text({box.x, foot - 2.0},
           fmt::format("Dot: start of the cycle. Numbers: {}. Arrows: load on the journal.",
                       cycle_axis(cycle).title),
           {theme.muted, 10.5, Anchor::start, false, false, theme.paper});
  return frame;
}

}  // namespace shellback::app
