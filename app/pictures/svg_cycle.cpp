#include "app/pictures/svg_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/labels/cycle_shown.hpp"
#include "app/pictures/svg_film.hpp"
#include "app/pictures/svg_heading.hpp"
#include "app/pictures/svg_orbit.hpp"
#include "app/words/ending_words.hpp"
#include "core/constants.hpp"
#include "core/largest.hpp"

namespace shellback::app {
namespace {

using bearing::CycleInstant;
using bearing::CycleResult;

constexpr double kKilonewton = 1e-3;  ///< kN per N
constexpr double kKilowatt = 1e-3;    ///< kW per W

constexpr double kWidestGap = 2.5;  ///< that a map shows, over the clearance [-]

constexpr double kCycleWidth = 1240.0;  ///< of the sheet [px]

/// A quantity of an instant over the cycle, times `factor`.
template <class Value>
Series curve(const CycleResult& cycle, const std::string& name, const std::string& colour,
             double factor, Value value) {
  Series series{name, {}, {}, colour, ""};
  for (const CycleInstant& i : cycle.instants) {
    series.x.push_back(on_axis(cycle, i.t));
    series.y.push_back(factor * value(i));
  }
  return series;
}

/// Whether summits press on each other by as much as can be seen beside the film's pressure: tails
/// of their heights touch at any gap.
bool shows_contact(double contact, double film) {
  constexpr double kSeen = 1e-3;  // of the largest film pressure: a line's width
  return contact > kSeen * film;
}

bool shows_contact(const CycleResult& cycle) {
  double film = 0.0, contact = 0.0;
  for (const CycleInstant& i : cycle.instants) {
    film = std::max(film, i.p_max);
    contact = std::max(contact, i.p_asperity_max);
  }
  return shows_contact(contact, film);
}

bool all_alike(const CycleResult& cycle, double CycleInstant::*value) {
  return std::all_of(cycle.instants.begin(), cycle.instants.end(), [&](const CycleInstant& i) {
    return i.*value == cycle.instants.front().*value;
  });
}

/// A field of the cycle as if it were the pressure or the gap of a steady film, without the marks
/// of the steady state.
FieldMap map_of(const bearing::Case& c, const CycleResult& cycle, FilmField which,
                const Field& field, const std::string& title) {
  bearing::Result film;
  film.fields.grid = cycle.fields.grid;
  film.fields.supplied.assign(cycle.fields.in_supply.begin(), cycle.fields.in_supply.end());
  film.quantities = quantities_of(cycle);
  (which == FilmField::gap                 ? film.fields.h
   : which == FilmField::shell_temperature ? film.fields.T_shell_surface
                                           : film.fields.p) = field;
  ColourScale scale = common_scale({&film}, which);
  if (which == FilmField::gap) {  // beyond it there is no film to look at
    scale.high = std::min(scale.high, kWidestGap * 1e6 * c.bearing.radial_clearance);
  }
  return film_map(c, film, which, scale, title);
}

/// The mark of h_min, which the rims know as well, in the column of cells where it is.
FieldMap marked_where_least(FieldMap map, const CycleResult& cycle) {
  if (map.marks.empty() || cycle.instants.empty()) return map;
  const auto least = std::min_element(
      cycle.instants.begin(), cycle.instants.end(),
      [](const CycleInstant& a, const CycleInstant& b) { return a.h_min < b.h_min; });
  const FilmGrid& g = cycle.fields.grid;
  const auto off = [&](int i) {
    return std::abs(std::remainder(g.phi[i] - least->h_min_angle, 2.0 * kPi));
  };
  int i = 0;
  for (int k = 1; k < g.nt; ++k) i = off(k) < off(i) ? k : i;
  const auto row = cycle.fields.h_min.begin() + g.index(i, 0);
  const auto j = std::min_element(row, row + g.nz) - row;
  const double degrees = g.phi[i] * 180.0 / kPi;
  map.marks.front().at = {degrees - 360.0 * std::floor(degrees / 360.0), 1e3 * g.z[j]};
  return map;
}

/// Without the mark that calls the largest value p_max.
FieldMap unmarked(FieldMap map) {
  map.marks.clear();
  return map;
}

/// Power per area [W/m2].
FieldMap power_map(const bearing::Case& c, const CycleResult& cycle, const Field& field,
                   const std::string& title) {
  Field shown;
  const DisplayUnit pressure = display_unit("p", "Pa");  // in which the map will show it
  for (const double v : field) shown.push_back(kKilowatt * v / pressure.scale);
  FieldMap map = unmarked(map_of(c, cycle, FilmField::pressure, shown, title));
  map.unit = "kW/m²";
  return map;
}

std::string status_words(const bearing::Case& c, const CycleResult& cycle) {
  std::string words = "Load cycle, tier " + std::string(to_string(cycle.tier)) + ": ";
  if (cycle.verdict.good()) return words + how_it_ran(c, cycle);
  return words + status_line(head_of(cycle)) + "; " + reason_of(cycle.verdict);
}

bool has_heat(const CycleResult& cycle) { return !cycle.fields.T_shell.empty(); }

constexpr double kMapRow = 290.0;  ///< [px]

/// Two maps; four where there is contact beside heat.
std::vector<FieldMap> maps_of(const bearing::Case& c, const CycleResult& cycle) {
  const std::size_t most = has_heat(cycle) && shows_contact(cycle) ? 4 : 2;
  std::vector<FieldMap> maps;
  for (const CycleMap which : {CycleMap::pressure, CycleMap::shell, CycleMap::contact,
                               CycleMap::gap, CycleMap::friction}) {
    auto map = cycle_map(c, cycle, which);
    if (map && maps.size() < most) maps.push_back(*std::move(map));
  }
  return maps;
}

void draw_maps(Svg& svg, double y, const std::vector<FieldMap>& maps, const Theme& theme) {
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const double column = static_cast<double>(k % 2), row = static_cast<double>(k / 2);
    draw_map(svg, {8.0 + 616.0 * column, y + kMapRow * row, 604.0, 270.0}, maps[k], theme);
  }
}

}  // namespace

LinePlot cycle_plot(const CycleResult& cycle, CycleCurve which, const Theme& theme) {
  const std::string& colour = theme.series[0];
  LinePlot plot;
  plot.x = cycle_axis(cycle);
  switch (which) {
    case CycleCurve::film:
      plot.title = "Smallest film";
      plot.y_title = "[µm]";
      plot.series = {curve(cycle, "", colour, 1e6, [](const auto& i) { return i.h_min; })};
      break;
    case CycleCurve::pressure:
      plot.title = "Largest pressure";
      plot.y_title = "[MPa]";
      plot.series = {curve(cycle, "", colour, 1e-6, [](const auto& i) { return i.p_max; })};
      if (!shows_contact(cycle)) break;
      plot.series.front().name = "film";
      plot.series.push_back(curve(cycle, "contact", theme.more, 1e-6,
                                  [](const auto& i) { return i.p_asperity_max; }));
      break;
    case CycleCurve::torque:
      plot.title = "Friction torque";
      plot.y_title = "[N m]";
      plot.series = {curve(cycle, "all", colour, 1.0, [](const auto& i) { return i.torque; }),
                     curve(cycle, "of asperities", theme.more, 1.0,
                           [](const auto& i) { return i.torque_asperity; })};
      break;
    case CycleCurve::load:
      plot.title = "Load on the journal";
      plot.y_title = "[kN]";
      plot.series = {
          curve(cycle, "magnitude", theme.ink, kKilonewton,
                [](const auto& i) { return std::hypot(i.load_x, i.load_y); }),
          curve(cycle, "X", theme.series[1], kKilonewton, [](const auto& i) { return i.load_x; }),
          curve(cycle, "Y", theme.series[2], kKilonewton, [](const auto& i) { return i.load_y; })};
      plot.series[1].dash = plot.series[2].dash = "5 3";
      break;
    case CycleCurve::speed:
      plot.title = "Speed of the journal against the shell";
      plot.y_title = "[rpm]";
      plot.series = {curve(cycle, "", colour, 1.0 / kRpm, [](const auto& i) { return i.omega; })};
      break;
    case CycleCurve::temperature:
      plot.title = "Largest temperatures";
      plot.from_zero = false;
      plot.y_title = "[°C]";
      plot.series = {curve(cycle, "film", colour, 1.0,
                           [](const auto& i) { return i.T_film_max - kZeroCelsius; }),
                     curve(cycle, "shell", theme.more, 1.0,
                           [](const auto& i) { return i.T_shell_max - kZeroCelsius; })};
      break;
    case CycleCurve::heat:
      plot.title = "Heat of the film";
      plot.y_title = "[W]";
      plot.series = {curve(cycle, "into the shell", theme.more, 1.0,
                           [](const auto& i) { return i.heat_to_shell; }),
                     curve(cycle, "into the shaft", colour, 1.0,
                           [](const auto& i) { return i.heat_to_shaft; })};
      break;
  }
  return plot;
}

namespace {

/// Those that the cycle has, two in a row.
std::vector<CycleCurve> curves_of(const CycleResult& cycle) {
  std::vector<CycleCurve> curves{CycleCurve::film, CycleCurve::pressure, CycleCurve::torque,
                                 CycleCurve::load};
  if (!all_alike(cycle, &CycleInstant::omega)) curves.push_back(CycleCurve::speed);
  if (has_heat(cycle)) {
    curves.insert(curves.end(), {CycleCurve::temperature, CycleCurve::heat});
  }
  return curves;
}

double rows_of(const std::vector<CycleCurve>& curves) {
  return static_cast<double>((curves.size() + 1) / 2);
}

}  // namespace

double height_of_cycle_curves(const CycleResult& cycle) {
  constexpr double kRow = 168.0;  // title, legend and axis take half of it [px]
  return kRow * rows_of(curves_of(cycle));
}

void draw_cycle_curves(Svg& svg, const Box& box, const CycleResult& cycle, const Theme& theme) {
  constexpr double kSpace = 8.0;  // between curves [px]
  const std::vector<CycleCurve> curves = curves_of(cycle);
  const double width = 0.5 * box.width;
  const double height = box.height / rows_of(curves);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const double x = box.x + static_cast<double>(k % 2) * width;
    const double y = box.y + static_cast<double>(k / 2) * height;
    draw_lines(svg, {x, y, width - kSpace, height - kSpace}, cycle_plot(cycle, curves[k], theme),
               theme);
  }
}

std::optional<FieldMap> cycle_map(const bearing::Case& c, const CycleResult& cycle,
                                  CycleMap which) {
  const auto& f = cycle.fields;
  const auto known = [&](const Field& field) {
    return !field.empty() && f.grid.cells() == static_cast<int>(field.size());
  };
  switch (which) {
    case CycleMap::pressure:
      if (!known(f.p_max)) return {};
      return map_of(c, cycle, FilmField::pressure, f.p_max, "Largest film pressure of each place");
    case CycleMap::contact:
      if (!known(f.p_asperity_max)) return {};
      if (!shows_contact(largest(f.p_asperity_max), largest(f.p_max))) return {};
      return unmarked(map_of(c, cycle, FilmField::pressure, f.p_asperity_max,
                             "Largest contact pressure of each place"));
    case CycleMap::gap:
      if (!known(f.h_min)) return {};
      return marked_where_least(
          map_of(c, cycle, FilmField::gap, f.h_min, "Smallest gap of each place"), cycle);
    case CycleMap::friction:
      if (!known(f.friction_power)) return {};
      return power_map(c, cycle, f.friction_power, "Friction power, mean of the cycle");
    case CycleMap::shell:
      if (!known(f.T_shell)) return {};
      return map_of(c, cycle, FilmField::shell_temperature, f.T_shell,
                    "Temperature of the shell, mean of the cycle");
    case CycleMap::shell_heat:
      if (!known(f.heat_to_shell)) return {};
      return power_map(c, cycle, f.heat_to_shell, "Heat into the shell, mean of the cycle");
  }
  return {};
}

std::string cycle_svg(const bearing::Case& c, const CycleResult& cycle) {
  constexpr double kTop = 94.0, kSpace = 30.0, kLeast = 506.0;  // [px]
  const Theme theme = print_theme();
  const std::vector<FieldMap> maps = maps_of(c, cycle);
  const double curves = std::max(kLeast, height_of_cycle_curves(cycle));
  const double height =
      kTop + curves + kSpace + kMapRow * static_cast<double>((maps.size() + 1) / 2);
  Svg svg(kCycleWidth, height);
  svg.rect({0.0, 0.0, kCycleWidth, height}, theme.paper);
  draw_scene(svg, c, status_words(c, cycle), cycle.verdict.good(), theme);
  draw_orbit(svg, {24.0, kTop, 480.0, kLeast - 4.0}, c, cycle, theme);
  if (!cycle.instants.empty()) {
    draw_cycle_curves(svg, {520.0, kTop, 712.0, curves}, cycle, theme);
  }
  draw_maps(svg, kTop + curves + kSpace, maps, theme);
  return svg.document(c.title);
}

}  // namespace shellback::app
