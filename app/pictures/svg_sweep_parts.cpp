#include "app/pictures/svg_sweep_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "app/labels/sweep_columns.hpp"

namespace shellback::app {

using study::Sweep;
using study::SweepPoint;

namespace {

/// The last part of the key: "speed" of operation.speed.
std::string short_name(const std::string& key) {
  std::string name = key.substr(key.rfind('.') + 1);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

int x_axis_of(const std::vector<study::Axis>& axes) {
  for (std::size_t a = 0; a < axes.size(); ++a) {
    if (axes[a].numbers.size() >= 2) return static_cast<int>(a);
  }
  return -1;
}

std::vector<SweepLine> lines_along(const Sweep& sweep, int x) {
  const auto& numbers = sweep.axes[x].numbers;
  std::vector<int> rising(numbers.size());
  std::iota(rising.begin(), rising.end(), 0);
  std::sort(rising.begin(), rising.end(), [&](int a, int b) { return numbers[a] < numbers[b]; });
  std::map<std::vector<int>, std::vector<const SweepPoint*>> found;  // by the other indices
  for (std::size_t k = 0; k < sweep.points.size(); ++k) {
    std::vector<int> others = indices_of(sweep, static_cast<int>(k));
    const int along = others[x];
    others.erase(others.begin() + x);
    auto& points = found[others];
    points.resize(numbers.size());
    points[along] = &sweep.points[k];
  }
  std::vector<SweepLine> lines;
  for (const auto& [others, points] : found) {
    SweepLine line;
    line.others = others;
    for (const int k : rising) {
      line.x.push_back(numbers[k]);
      line.points.push_back(points[k]);
    }
    std::size_t at = 0;
    for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
      if (static_cast<int>(a) == x) continue;
      line.label += fmt::format("{}{} {}", at == 0 ? "" : ", ", short_name(sweep.axes[a].key),
                                sweep.axes[a].words[others[at]]);
      ++at;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string axis_title(const study::Axis& axis) {
  return axis.unit.empty() ? short_name(axis.key)
                           : fmt::format("{} [{}]", short_name(axis.key), typeset_unit(axis.unit));
}

Axis drawn_axis(const study::Axis& axis, double room) {
  const auto [low, high] = std::minmax_element(axis.numbers.begin(), axis.numbers.end());
  if (is_logarithmic(axis)) {
    const double widened = std::pow(*high / *low, room);
    return log_axis(*low / widened, *high * widened, axis_title(axis));
  }
  const double widened = room * (*high - *low);
  return tight_axis(*low - widened, *high + widened, 8, axis_title(axis));
}

double DrawnQuantity::at(const SweepPoint& point) const {
  return point.good() ? unit(point.result.value(name)) : NAN;
}

double DrawnQuantity::bar(const SweepPoint& point) const {
  if (!point.good()) return NAN;
  for (const auto& q : point.result.quantities) {
    if (q.name == name) return std::abs(unit.scale) * q.error();
  }
  return NAN;
}

/// Of the height of the curves, for bars beyond them [-].
constexpr double kRoomForBars = 0.5;

std::optional<DrawnQuantity> drawn_quantity(const Sweep& sweep, const std::string& name) {
  double least = INFINITY;
  double most = -INFINITY;
  double below = INFINITY;  // with the bars
  double above = -INFINITY;
  std::string si_unit;
  for (const SweepPoint& point : sweep.points) {
    if (!point.good() || !point.result.has(name)) continue;
    least = std::min(least, point.result.value(name));
    most = std::max(most, point.result.value(name));
    for (const auto& q : point.result.quantities) {
      if (q.name != name) continue;
      si_unit = q.unit;
      const double bar = std::isfinite(q.error()) ? q.error() : 0.0;
      below = std::min(below, q.value - bar);
      above = std::max(above, q.value + bar);
    }
  }
  if (!(least <= most)) return std::nullopt;
  const DisplayUnit unit = display_unit(name, si_unit, std::max(std::abs(least), std::abs(most)));
  // Bars are drawn to their ends, but those that would press the curve together, and none across
  // zero where all values have one sign.
  const bool arbitrary = si_unit == "K";  // a zero that no curve is drawn from
  const double room = kRoomForBars * (most - (arbitrary ? least : std::min(least, 0.0)));
  const double floor = least >= 0.0 && !arbitrary ? std::max(least - room, 0.0) : least - room;
  return DrawnQuantity{name,
                       unit,
                       unit(least),
                       unit(most),
                       unit(std::clamp(below, floor, least)),
                       unit(std::clamp(above, most, most + room))};
}

void draw_cross(Svg& svg, Point at, const std::string& colour) {
  constexpr double kArm = 4.0;  // [px]
  const Stroke stroke{colour, 1.8, ""};
  svg.line({at.x - kArm, at.y - kArm}, {at.x + kArm, at.y + kArm}, stroke);
  svg.line({at.x - kArm, at.y + kArm}, {at.x + kArm, at.y - kArm}, stroke);
}

}  // namespace shellback::app
