#include "app/pictures/svg_cycle_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/labels/cycle_shown.hpp"
#include "app/pictures/svg_cycle.hpp"
#include "app/pictures/svg_film.hpp"
#include "app/pictures/svg_orbit.hpp"
#include "core/make_grid.hpp"

namespace shellback::app {
namespace {

using bearing::CycleFrame;
using bearing::CycleInstant;
using bearing::CycleResult;

constexpr double kFramesWidth = 1180.0;  ///< of the whole [px]
constexpr double kFramesHeight = 372.0;  ///< [px]
constexpr int kBands = 24;               ///< colours of a frame
constexpr int kMostAround = 120;         ///< cells of a frame around the bearing
constexpr int kMostAcross = 17;          ///< and along it
constexpr std::size_t kMostFrames = 72;
const Box kOrbitBox{8.0, 0.0, 330.0, 350.0};
const Box kMapBox{360.0, 0.0, 810.0, 332.0};

/// The grid on which frames are drawn.
FilmGrid thinned(const FilmGrid& grid) {
  if (grid.nt <= kMostAround && grid.nz <= kMostAcross) return grid;
  return make_grid(grid.radius, grid.width, std::min(grid.nt, kMostAround),
                   std::min(grid.nz, kMostAcross), false);
}

bool whole(const CycleResult& cycle, const CycleFrame& frame) {
  const auto cells = static_cast<std::size_t>(cycle.fields.grid.cells());
  return frame.p.size() == cells && drawable(frame.p) &&
         (frame.theta.empty() || (frame.theta.size() == cells && drawable(frame.theta)));
}

FieldMap map_of(const bearing::Case& c, const CycleResult& cycle, const FilmGrid& grid,
                const CycleFrame& frame, const ColourScale& scale) {
  bearing::Result film;
  film.fields.grid = grid;
  film.fields.p = interpolate(cycle.fields.grid, frame.p, grid);
  if (!frame.theta.empty()) {
    film.fields.theta = interpolate(cycle.fields.grid, frame.theta, grid);
  }
  FieldMap map = film_map(c, film, FilmField::pressure, scale, "Film pressure");
  map.marks.clear();
  return map;
}

ColourScale scale_of(const std::vector<const CycleFrame*>& frames) {
  double highest = 0.0;
  for (const CycleFrame* frame : frames) {
    highest = std::max(highest, *std::max_element(frame->p.begin(), frame->p.end()));
  }
  const DisplayUnit unit = display_unit("p", "Pa");
  const Axis range = tight_axis(0.0, unit(highest), 8, "");  // widened if there is no pressure
  return {kCool, range.low, range.high};
}

const CycleInstant* instant_of(const CycleResult& cycle, const CycleFrame& frame) {
  const auto nearest = std::min_element(cycle.instants.begin(), cycle.instants.end(),
                                        [&](const auto& a, const auto& b) {
                                          return std::abs(a.t - frame.t) < std::abs(b.t - frame.t);
                                        });
  return nearest == cycle.instants.end() ? nullptr : &*nearest;
}

std::string words_of(const CycleResult& cycle, const CycleFrame& frame) {
  const auto* i = instant_of(cycle, frame);
  std::string words = has_crank(cycle)
                          ? fmt::format("crank angle {:.0f}°", shown_instant(cycle, frame.t))
                          : "time " + duration_words(frame.t);
  if (i == nullptr) return words;
  return words + fmt::format(", largest pressure {} MPa, smallest film {} µm, load {} kN",
                             figures(1e-6 * i->p_max, 3), figures(1e6 * i->h_min, 3),
                             figures(1e-3 * std::hypot(i->load_x, i->load_y), 3));
}

void draw_frame(Svg& svg, const Frame& place, const OrbitFrame& orbit, const bearing::Case& c,
                const CycleResult& cycle, const CycleFrame& frame, const FieldMap& map) {
  const Theme theme = page_theme();
  svg.begin_clip(place.box);
  draw_film(svg, place, map, kBands);
  svg.end_clip();
  svg.text({place.box.x, kFramesHeight - 8.0}, words_of(cycle, frame), {theme.ink, 13.0});
  const auto* i = instant_of(cycle, frame);
  if (i == nullptr) return;
  const double clearance = c.bearing.radial_clearance;
  const Point at = orbit.at(i->ex / clearance, i->ey / clearance);
  svg.line(orbit.centre, at, {theme.more, 1.4, ""});
  svg.circle(at, 6.0, theme.more, {theme.paper, 1.5, ""});
}

std::string drawn(const bearing::Case& c, const CycleResult& cycle,
                  const std::vector<const CycleFrame*>& frames) {
  const Theme theme = page_theme();
  const FilmGrid grid = thinned(cycle.fields.grid);
  const ColourScale scale = scale_of(frames);
  Svg svg(kFramesWidth, kFramesHeight);
  const OrbitFrame orbit = draw_orbit(svg, kOrbitBox, c, cycle, theme);
  const FieldMap first = map_of(c, cycle, grid, *frames.front(), scale);
  const Frame place = map_frame(kMapBox, first);
  svg.text({place.box.x, kMapBox.y + 14.0}, first.title, {theme.ink, 12.5, Anchor::start, true});
  for (const CycleFrame* frame : frames) {
    svg.begin_group(frame == frames.front() ? "frame now" : "frame");
    draw_frame(svg, place, orbit, c, cycle, *frame, map_of(c, cycle, grid, *frame, scale));
    svg.end_group();
  }
  draw_surroundings(svg, place, first, theme);
  draw_axes(svg, place, theme, GridLines::none);
  return svg.inline_element("Film pressure over the load cycle");
}

}  // namespace

std::string animation_svg(const bearing::Case& c, const CycleResult& cycle,
                          std::size_t most_bytes) {
  std::vector<const CycleFrame*> all;
  for (const CycleFrame& frame : cycle.frames) {
    if (whole(cycle, frame)) all.push_back(&frame);
  }
  if (all.empty() || cycle.fields.grid.cells() == 0) return "";
  std::size_t most = std::min(all.size(), kMostFrames);
  for (;; most = std::max<std::size_t>(1, most / 2)) {
    std::vector<const CycleFrame*> kept;
    for (std::size_t k = 0; k < most; ++k) kept.push_back(all[k * all.size() / most]);
    std::string svg = drawn(c, cycle, kept);
    if (svg.size() <= most_bytes || most == 1) return svg;
  }
}

}  // namespace shellback::app
