#include "app/pictures/svg_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_map.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

using bearing::Case;
using bearing::Fields;

constexpr double kThinnest = 0.75;  ///< largest drawn ratio of bore to outer radius [-]

/// Radius on the picture: linear between bore and outside.
struct Ring {
  Point centre;
  double bore_px;
  double outer_px;
  double bore;   ///< [m]
  double outer;  ///< [m]
  [[nodiscard]] double px(double r) const {
    return bore_px + (outer_px - bore_px) * (r - bore) / (outer - bore);
  }
  [[nodiscard]] Point at(double degree, double r) const {
    const double a = degree * kPi / 180.0;
    return {centre.x + px(r) * std::cos(a), centre.y - px(r) * std::sin(a)};
  }
};

/// Arrow from a to b.
void draw_arrow(Svg& svg, Point a, Point b, const Theme& theme) {
  const double angle = std::atan2(b.y - a.y, b.x - a.x);
  const auto barb = [&](double turn) {
    return Point{b.x - 8.0 * std::cos(angle + turn), b.y - 8.0 * std::sin(angle + turn)};
  };
  svg.line(a, b, {theme.ink, 1.6, ""});
  svg.fill(line_path({b, barb(0.4), barb(-0.4)}) + "Z", theme.ink);
}

/// Sense of rotation: an arc inside the bore, counter-clockwise for positive speed.
void draw_rotation(Svg& svg, const Ring& ring, double omega, const Theme& theme) {
  if (omega == 0.0) return;
  const double radius = 0.66 * ring.bore_px;
  std::vector<Point> arc;
  for (int k = 0; k <= 24; ++k) {
    const double a = (30.0 + 5.0 * k) * kPi / 180.0;
    arc.push_back({ring.centre.x + radius * std::cos(a), ring.centre.y - radius * std::sin(a)});
  }
  if (omega < 0.0) std::reverse(arc.begin(), arc.end());
  svg.stroke(line_path(arc), {theme.ink, 1.6, ""});
  draw_arrow(svg, arc[arc.size() - 2], arc.back(), theme);
  svg.text({ring.centre.x, ring.centre.y - radius + 17.0},
           figures(std::abs(omega) * 30.0 / kPi) + " rpm", {theme.ink, 11.0, Anchor::middle});
}

void draw_load(Svg& svg, const Ring& ring, const Case& c, const Theme& theme) {
  const auto* load = std::get_if<bearing::LoadGiven>(&c.operation.position);
  if (!load || load->force <= 0.0) return;
  const double length = 0.5 * ring.bore_px;
  const Point tip{ring.centre.x + length * std::cos(load->angle),
                  ring.centre.y - length * std::sin(load->angle)};
  draw_arrow(svg, ring.centre, tip, theme);
  svg.text({ring.centre.x + 8.0, ring.centre.y + 4.0}, figures(load->force * 1e-3, 3) + " kN",
           {theme.ink, 11.0, Anchor::start, false, false, theme.paper});
}

/// Boundaries of layers, bore and outside.
void draw_circles(Svg& svg, const Ring& ring, const Case& c, const Theme& theme) {
  if (c.shell) {
    double r = c.bearing.radius;
    for (const auto& layer : c.shell->layers) {
      r += layer.thickness;
      if (r < ring.outer) svg.circle(ring.centre, ring.px(r), "none", {"#ffffff", 0.8, ""});
    }
  }
  svg.circle(ring.centre, ring.bore_px, "none", {theme.muted, 1.0, ""});
  svg.circle(ring.centre, ring.outer_px, "none", {theme.muted, 1.0, ""});
}

void draw_angles(Svg& svg, const Ring& ring, const Theme& theme) {
  for (int degree = 0; degree < 360; degree += 90) {
    const double a = degree * kPi / 180.0;
    const double r = ring.outer_px + 5.0;
    const Point tip{ring.centre.x + r * std::cos(a), ring.centre.y - r * std::sin(a)};
    svg.line(ring.at(degree, ring.outer), tip, {theme.muted, 1.0, ""});
    const Point label{ring.centre.x + (r + 15.0) * std::cos(a),
                      ring.centre.y - (r + 10.0) * std::sin(a) + 3.8};
    svg.text(label, fmt::format("{}°", degree), {theme.muted, 10.5, Anchor::middle});
  }
}

}  // namespace

void draw_section(Svg& svg, const Box& box, const Case& c, const bearing::Result& result,
                  const std::string& title, const Theme& theme) {
  const Fields& f = result.fields;
  const auto to_celsius = display_unit("T_solid", "K");
  std::vector<double> T;
  for (const double value : f.T_solid) T.push_back(to_celsius(value));
  svg.text({box.x, box.y + 14.0}, title, {theme.ink, 12.5, Anchor::start, true});
  if (!drawable(T)) {
    svg.text({box.x, box.y + 34.0}, "not drawn: the field holds values that are not numbers",
             {theme.more, 12.0});
    return;
  }
  const double outer_px = 0.5 * std::min(box.width - 110.0, box.height - 80.0);
  const double ratio = f.r.front() / f.r.back();
  const Ring ring{{box.x + 34.0 + outer_px, box.y + 46.0 + outer_px},
                  std::min(ratio, kThinnest) * outer_px,
                  outer_px,
                  f.r.front(),
                  f.r.back()};
  const auto [low, high] = std::minmax_element(T.begin(), T.end());
  const Axis range = tight_axis(*low, *high, 8, "");
  const ColourScale scale{kWarm, range.low, range.high};
  draw_bands(svg, around(f.grid, f.r, T), scale,
             [&](double degree, double r) { return ring.at(degree, r); });
  draw_circles(svg, ring, c, theme);
  draw_angles(svg, ring, theme);
  draw_rotation(svg, ring, c.operation.omega, theme);
  draw_load(svg, ring, c, theme);
  const Box beside{ring.centre.x - outer_px, ring.centre.y - outer_px, 2.0 * outer_px + 26.0,
                   2.0 * outer_px};
  draw_colour_bar(svg, beside, scale, "°C", theme);
  if (ratio > kThinnest) {
    svg.text({box.x, box.bottom() - 6.0},
             fmt::format("radial direction stretched: bore {} mm, outside {} mm",
                         figures(1e3 * ring.bore), figures(1e3 * ring.outer)),
             {theme.muted, 10.5});
  }
}

}  // namespace shellback::app
