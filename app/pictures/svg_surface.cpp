#include "app/pictures/svg_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "app/pictures/svg_lines.hpp"
#include "app/pictures/svg_map.hpp"
#include "core/constants.hpp"

namespace shellback::app {
namespace {

using surface::FactorRow;

constexpr double kSurfaceWidth = 1200.0;  ///< [px]
constexpr double kSurfaceHeight = 820.0;  ///< [px]
constexpr int kMostDrawn = 110;           ///< points each way: finer is not seen
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

constexpr double kLeastSide = 140.0;  ///< of a map with its axes [px]

/// The box of a map that shows both directions in one scale, in the upper left of `room`; a strip
/// is drawn wider than it is, as far as its axes need.
Box to_scale(const Box& room, double length, double width) {
  const double scale = std::min(room.width / length, room.height / width);
  return {room.x, room.y, std::max(scale * length, kLeastSide),
          std::max(scale * width, kLeastSide)};
}

/// Heights in um over um; of a large map every so many-th point.
void draw_heights(Svg& svg, const Box& room, const SurfaceReport& r, const Theme& theme) {
  const surface::HeightMap& map = r.map;
  const auto stride = [](int n) { return (n + kMostDrawn - 1) / kMostDrawn; };
  const int in_x = stride(map.nx), in_y = stride(map.ny);
  FieldMap field;
  field.title = "Heights without form";
  field.unit = "um";
  for (int i = 0; i < map.nx; i += in_x) field.surface.x.push_back(1e6 * i * map.dx);
  for (int j = 0; j < map.ny; j += in_y) field.surface.y.push_back(1e6 * j * map.dy);
  for (int i = 0; i < map.nx; i += in_x) {
    for (int j = 0; j < map.ny; j += in_y) field.surface.value.push_back(1e6 * map.at(i, j));
  }
  constexpr double kShown = 3.0;  // sigmas; single spikes would bleach the rest
  const double reach = kShown * 1e6 * r.heights.Rq;
  field.scale = {kCool, -reach, reach};
  const Box box = to_scale(room, field.surface.x.back(), field.surface.y.back());
  field.x = tight_axis(0.0, field.surface.x.back(), 8,
                       in_x == 1 ? std::string("x along the motion [um]")
                                 : fmt::format("x along the motion [um], one point in {}", in_x));
  field.y = tight_axis(0.0, field.surface.y.back(), 6,
                       in_y == 1 ? std::string("y across [um]")
                                 : fmt::format("y across [um], one point in {}", in_y));
  draw_map(svg, box, field, theme);
}

/// Share of heights per sigma, with the normal distribution.
void draw_distribution(Svg& svg, const Box& box, const SurfaceReport& r, const Theme& theme) {
  constexpr int kBins = 60;
  constexpr double kReach = 5.0;  // sigmas
  const double width = 2.0 * kReach / kBins;
  std::vector<double> share(kBins, 0.0);
  for (const double z : r.map.z) {
    const double bin = (z / r.heights.Rq + kReach) / width;
    if (bin < 0.0 || bin >= kBins) continue;
    share[static_cast<std::size_t>(bin)] += 1.0 / (static_cast<double>(r.map.z.size()) * width);
  }
  Series measured{"measured", {}, {}, theme.series[0], ""},
      normal{"normal", {}, {}, theme.muted, "4 3"};
  for (int k = 0; k < kBins; ++k) {
    const double x = -kReach + (k + 0.5) * width;
    measured.x.push_back(x);
    measured.y.push_back(share[static_cast<std::size_t>(k)]);
    normal.x.push_back(x);
    normal.y.push_back(std::exp(-0.5 * x * x) / std::sqrt(2.0 * kPi));
  }
  draw_lines(svg, box,
             {fmt::format("Heights: Rq {:.3g} um, skewness {:.2f}, kurtosis {:.2f}",
                          1e6 * r.heights.Rq, r.heights.skewness, r.heights.kurtosis),
              tight_axis(-kReach, kReach, 10, "height over Rq [-]"),
              "density [-]",
              {measured, normal}},
             theme);
}

struct SurfaceCurve {
  const char* name;
  double FactorRow::*value;
};

/// Curves over h/sigma with their standard errors as thin lines.
void draw_factors(Svg& svg, const Box& box, const SurfaceReport& r, const char* title,
                  const std::vector<SurfaceCurve>& curves, const Theme& theme) {
  LinePlot plot;
  plot.title = title;
  const auto& rows = r.factors.rows;
  plot.x = tight_axis(rows.front().H, rows.back().H, 10, "h over sigma [-]");
  plot.y_title = "factor [-]";
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto value = curves[c].value;
    Series line{curves[c].name, {}, {}, theme.series[c], ""};
    Series low{"", {}, {}, theme.series[c], "1 3"}, high = low;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      line.x.push_back(rows[k].H);
      line.y.push_back(rows[k].*value);
      low.x.push_back(rows[k].H), high.x.push_back(rows[k].H);
      low.y.push_back(rows[k].*value - r.factors.errors[k].*value);
      high.y.push_back(rows[k].*value + r.factors.errors[k].*value);
    }
    plot.series.push_back(line);
    plot.series.push_back(low);
    plot.series.push_back(high);
  }
  draw_lines(svg, box, plot, theme);
}

void draw_contact(Svg& svg, const Box& box, const SurfaceReport& r, const Theme& theme) {
  const auto log_of = [](double p) { return p > 0.0 ? std::log10(p) : kNone; };
  Series formula{"Greenwood-Tripp", {}, {}, theme.series[0], ""};
  Series summits{"its own summits", {}, {}, theme.series[1], ""};
  Series plane{"on a plane", {}, {}, theme.series[2], "6 3"};
  for (const surface::ContactRow& row : r.contact) {
    for (Series* s : {&formula, &summits, &plane}) s->x.push_back(row.h / r.heights.Rq);
    formula.y.push_back(log_of(row.pair_formula));
    summits.y.push_back(log_of(row.pair_summits));
    plane.y.push_back(log_of(row.plane_summits));
  }
  LinePlot plot{"Contact pressure over E*",
                tight_axis(0.0, r.contact.back().h / r.heights.Rq, 6, "separation over Rq [-]"),
                "log10 p/E*",
                {formula, summits, plane}};
  plot.from_zero = false;
  draw_lines(svg, box, plot, theme);
}

}  // namespace

std::string surface_svg(const SurfaceReport& r) {
  const Theme theme = print_theme();
  Svg svg(kSurfaceWidth, kSurfaceHeight);
  svg.rect({0.0, 0.0, kSurfaceWidth, kSurfaceHeight}, theme.paper);
  const std::string name = std::filesystem::path(r.options.path).filename().string();
  svg.text({24.0, 36.0}, name, {theme.ink, 20.0, Anchor::start, true});
  svg.text(
      {24.0, 58.0},
      fmt::format("{} x {} points, {:.4g} x {:.4g} um; gamma {:.3g}; form of degree {} removed",
                  r.map.nx, r.map.ny, 1e6 * r.map.length(), 1e6 * r.map.width(),
                  r.correlation.gamma, r.form.degree),
      {theme.muted, 12.5});
  draw_heights(svg, {24.0, 76.0, 600.0, 360.0}, r, theme);
  draw_distribution(svg, {640.0, 76.0, 540.0, 350.0}, r, theme);
  draw_factors(
      svg, {24.0, 446.0, 380.0, 350.0}, r, "Pressure and shear flow",
      {{"phi_x", &FactorRow::phi_x}, {"phi_z", &FactorRow::phi_z}, {"phi_s", &FactorRow::phi_s}},
      theme);
  draw_factors(svg, {410.0, 446.0, 380.0, 350.0}, r, "Shear stress",
               {{"phi_f", &FactorRow::phi_f},
                {"phi_fs", &FactorRow::phi_fs},
                {"phi_fp", &FactorRow::phi_fp}},
               theme);
  draw_contact(svg, {796.0, 446.0, 390.0, 350.0}, r, theme);
  return svg.document("Roughness, contact and flow factors of " + name);
}

}  // namespace shellback::app
