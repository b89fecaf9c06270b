#include "validation/chart/chart_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/pictures/svg_lines.hpp"
#include "core/constants.hpp"

namespace shellback::validation {

using namespace app;

namespace {

constexpr double kMarkText = 10.0;

const std::vector<Look> kLooks{
    {ChartFamily::grid, "#0072b2", "grid: cells around, ours (active set, Lobatto nodes, Newton)"},
    {ChartFamily::extrapolated, "#0072b2", "the same, led on by the grids of its bars"},
    {ChartFamily::nodes, "#56b4e9", "other numbers of nodes"},
    {ChartFamily::layers, "#e69f00", "10, 20, 40 even layers"},
    {ChartFamily::mean, "#a06000", "film-mean temperature"},
    {ChartFamily::tier, "#009e73", "simpler tier"},
    {ChartFamily::cavitation, "#cc79a7", "cavitation: FB Newton, p-θ relaxation, Swift-Stieber"},
    {ChartFamily::elastic, "#d55e00", "elastic fixed point: Aitken, 0.05"},
    {ChartFamily::steps, "#7a3b9a", "steps of a load cycle, to a tolerance"},
    {ChartFamily::automatic, "#000000", "auto, to its tolerance"},
};

std::string polygon(Point c, double r, int corners, double turn) {
  std::string path;
  for (int k = 0; k < corners; ++k) {
    const double a = turn + 2.0 * kPi * k / corners;
    path += fmt::format("{}{} {}", k == 0 ? "M" : "L", coordinate(c.x + r * std::sin(a)),
                        coordinate(c.y - r * std::cos(a)));
  }
  return path + "Z";
}

}  // namespace

const std::vector<Look>& chart_looks() { return kLooks; }
const Look& look_of(ChartFamily family) { return kLooks[static_cast<std::size_t>(family)]; }

void draw_mark(Svg& svg, Point c, ChartFamily family) {
  const std::string colour = look_of(family).colour;
  const Stroke edge{colour, 1.5, ""};
  const auto shape = [&](const std::string& path) {
    svg.fill(path, colour);
    svg.stroke(path, edge);
  };

  switch (family) {
    case ChartFamily::grid:
      return svg.circle(c, kMark, colour, edge);
    case ChartFamily::extrapolated:
      return svg.circle(c, kMark, "#ffffff", edge);
    case ChartFamily::nodes:
      return svg.circle(c, 0.8 * kMark, colour, edge);
    case ChartFamily::layers:
      return shape(polygon(c, 1.2 * kMark, 4, 0.25 * kPi));
    case ChartFamily::mean:
      return shape(polygon(c, 1.2 * kMark, 3, 0.0));
    case ChartFamily::tier:
      return shape(polygon(c, 1.3 * kMark, 4, 0.0));
    case ChartFamily::cavitation:
      return shape(polygon(c, 1.2 * kMark, 6, 0.0));
    case ChartFamily::elastic:
      return shape(polygon(c, 1.3 * kMark, 3, kPi));
    case ChartFamily::steps:
      return svg.circle(c, 0.9 * kMark, "#ffffff", edge);
    case ChartFamily::automatic:
      return shape(polygon(c, 1.4 * kMark, 5, 0.0));
  }
}

void draw_cross(Svg& svg, Point c, const std::string& colour) {
  const Stroke ink{colour, 2.0, ""};
  svg.line({c.x - kMark, c.y - kMark}, {c.x + kMark, c.y + kMark}, ink);
  svg.line({c.x - kMark, c.y + kMark}, {c.x + kMark, c.y - kMark}, ink);
}

void WordsBesideMarks::put(Svg& svg, Point c, const std::string& words, const std::string& colour) {
  const double w = text_width(words, kMarkText);
  const double h = 0.95 * kMarkText;
  const double d = kMark + 3.0;
  const std::array<Box, 12> places{{{c.x + d, c.y - 0.5 * h, w, h},
                                    {c.x - d - w, c.y - 0.5 * h, w, h},
                                    {c.x - 0.5 * w, c.y - d - h, w, h},
                                    {c.x - 0.5 * w, c.y + d, w, h},
                                    {c.x + 0.7 * d, c.y - 0.7 * d - h, w, h},
                                    {c.x + 0.7 * d, c.y + 0.7 * d, w, h},
                                    {c.x - 0.7 * d - w, c.y - 0.7 * d - h, w, h},
                                    {c.x - 0.7 * d - w, c.y + 0.7 * d, w, h},
                                    {c.x + 0.7 * d, c.y + d + h, w, h},
                                    {c.x - 0.7 * d - w, c.y + d + h, w, h},
                                    {c.x + 0.7 * d, c.y - d - 2.0 * h, w, h},
                                    {c.x - 0.7 * d - w, c.y - d - 2.0 * h, w, h}}};
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

double WordsBesideMarks::covered(const Box& b) const {
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

}  // namespace shellback::validation
