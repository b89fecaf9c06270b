/// Maps of a sweep over two axes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/pictures/svg_lines.hpp"
#include "app/pictures/svg_map.hpp"
#include "app/pictures/svg_sweep_parts.hpp"

namespace shellback::app {

using study::Sweep;
using study::SweepPoint;

namespace {

using Titled = std::pair<const char*, const char*>;
/// The first four that are known are drawn.
constexpr std::array kMaps{
    Titled{"friction_torque", "Friction torque"},       Titled{"h_min", "Smallest film"},
    Titled{"T_film_max", "Largest film temperature"},   Titled{"p_max", "Largest film pressure"},
    Titled{"eccentricity_ratio", "Eccentricity ratio"}, Titled{"side_flow", "Side flow"}};
constexpr std::array kBoxes{Box{24.0, 84.0, 572.0, 340.0}, Box{616.0, 84.0, 572.0, 340.0},
                            Box{24.0, 432.0, 572.0, 340.0}, Box{616.0, 432.0, 572.0, 340.0}};

/// Points over two numeric axes, both rising.
struct Plane {
  int x_axis = 0;
  int y_axis = 0;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<const SweepPoint*> points;  ///< index i * y.size() + j
  std::string left_out;
};

Plane plane_of(const Sweep& sweep) {
  Plane plane;
  plane.x_axis = x_axis_of(sweep.axes);
  for (std::size_t a = sweep.axes.size(); a-- > 0;) {
    const bool numeric = sweep.axes[a].numbers.size() >= 2;
    if (numeric && static_cast<int>(a) != plane.x_axis) plane.y_axis = static_cast<int>(a);
  }
  const int y_place = plane.y_axis - (plane.y_axis > plane.x_axis ? 1 : 0);
  std::vector<std::pair<double, SweepLine>> rows;
  for (SweepLine& line : lines_along(sweep, plane.x_axis)) {
    bool first = true;
    for (std::size_t k = 0; k < line.others.size(); ++k) {
      first = first && (static_cast<int>(k) == y_place || line.others[k] == 0);
    }
    const double y = sweep.axes[plane.y_axis].numbers[line.others[y_place]];
    if (first) rows.emplace_back(y, std::move(line));
  }
  std::sort(rows.begin(), rows.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  plane.x = rows.front().second.x;
  for (const auto& [y, line] : rows) plane.y.push_back(y);
  for (std::size_t i = 0; i < plane.x.size(); ++i) {
    for (const auto& [y, line] : rows) plane.points.push_back(line.points[i]);
  }
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    if (static_cast<int>(a) == plane.x_axis || static_cast<int>(a) == plane.y_axis) continue;
    plane.left_out += fmt::format("{}at {} = {} only", plane.left_out.empty() ? "" : ", ",
                                  sweep.axes[a].key, sweep.axes[a].words.front());
  }
  return plane;
}

/// A cell is drawn only if all its corners are solved: the rest is covered and marked.
void cover_unsolved(Svg& svg, const Frame& frame, const Plane& plane, const Theme& theme) {
  const int nx = static_cast<int>(plane.x.size());
  const int ny = static_cast<int>(plane.y.size());
  const auto good = [&](int i, int j) { return plane.points[i * ny + j]->good(); };
  for (int i = 0; i + 1 < nx; ++i) {
    for (int j = 0; j + 1 < ny; ++j) {
      if (good(i, j) && good(i + 1, j) && good(i, j + 1) && good(i + 1, j + 1)) continue;
      const Point a = frame.at(plane.x[i], plane.y[j]);
      const Point b = frame.at(plane.x[i + 1], plane.y[j + 1]);
      svg.rect({a.x - 0.3, b.y - 0.3, b.x - a.x + 0.6, a.y - b.y + 0.6}, theme.paper);
    }
  }
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      if (plane.points[i * ny + j]->tried() && !good(i, j)) {
        draw_cross(svg, frame.at(plane.x[i], plane.y[j]), theme.more);
      }
    }
  }
}

/// Values; what is not solved takes any value and is covered afterwards.
std::vector<double> filled(const Plane& plane, const DrawnQuantity& q, bool logarithmic) {
  std::vector<double> values;
  for (const auto* point : plane.points) {
    const double value = q.at(*point);
    values.push_back(logarithmic ? std::log10(value) : value);
  }
  const double any = logarithmic ? std::log10(q.low) : q.low;
  for (double& value : values) {
    if (!std::isfinite(value)) value = any;
  }
  return values;
}

void draw_one(Svg& svg, const Box& box, const Sweep& sweep, const Plane& plane,
              const DrawnQuantity& q, const char* title, const Theme& theme) {
  constexpr double kSteep = 20.0;  // ratio from which colours stand for decades
  const bool logarithmic = q.low > 0.0 && q.high > kSteep * q.low;
  const std::string unit = typeset_unit(q.unit.unit);
  FieldMap map;
  map.title = logarithmic ? fmt::format("{}, decimal logarithm of {}", title, unit)
                          : fmt::format("{} [{}]", title, unit);
  map.surface = {plane.x, plane.y, filled(plane, q, logarithmic)};
  map.scale = {kCool, logarithmic ? std::log10(q.low) : q.low,
               logarithmic ? std::log10(q.high) : q.high};
  if (!(map.scale.high > map.scale.low)) map.scale.high = map.scale.low + 1.0;
  map.x = drawn_axis(sweep.axes[plane.x_axis], 0.0);
  map.y = drawn_axis(sweep.axes[plane.y_axis], 0.0);
  draw_map(svg, box, map, theme);
  // draw_map keeps its frame to itself: the same margins as there.
  constexpr Box kMargins{50.0, 24.0, 50.0 + 62.0, 24.0 + 38.0};
  const Frame frame{{box.x + kMargins.x, box.y + kMargins.y, box.width - kMargins.width,
                     box.height - kMargins.height},
                    map.x,
                    map.y};
  cover_unsolved(svg, frame, plane, theme);
}

}  // namespace

std::string draw_sweep_maps(Svg& svg, const Sweep& sweep, const Theme& theme) {
  const Plane plane = plane_of(sweep);
  std::size_t box = 0;
  for (const auto& [name, title] : kMaps) {
    const auto q = drawn_quantity(sweep, name);
    if (q && box < kBoxes.size()) draw_one(svg, kBoxes[box++], sweep, plane, *q, title, theme);
  }
  return plane.left_out;
}

}  // namespace shellback::app
