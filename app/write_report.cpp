#include "app/write_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/html_cycle.hpp"
#include "app/html_page.hpp"
#include "app/html_tables.hpp"
#include "app/labels/cycle_shown.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_film.hpp"
#include "app/pictures/svg_lines.hpp"
#include "app/pictures/svg_map.hpp"
#include "app/pictures/svg_orbit.hpp"
#include "core/largest.hpp"
#include "core/round_off.hpp"

namespace shellback::app {
namespace {

constexpr std::size_t kTitle = 60;      ///< characters above a map
constexpr double kReportMap = 232.0;    ///< height [px]
constexpr double kReportCurve = 220.0;  ///< height [px]
constexpr double kReportPath = 600.0;   ///< height [px]
constexpr double kLastTick = 14.0;      ///< beside a frame for half of its last label [px]

std::string failure_of(const StoredResult& result) {
  if (result.converged) return "";
  return failure_html(result.tier + ": NOT CONVERGED: " + result.status,
                      {result.reason, result.place, result.cure},
                      "Its numbers and fields are those of the last iterate, not a result.");
}

std::string quantity_row(const StoredQuantity& q) {
  const bearing::Quantity& of = q.quantity;
  const DisplayUnit unit = display_unit(of.name, of.unit, std::abs(of.value));
  return fmt::format(
      "<tr data-quantity=\"{}\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
      "<td class=\"unit\">{}</td><td>{}</td></tr>\n",
      escape_markup(of.name), escape_markup(quantity_label(of.name)),
      typeset_number(figures(unit(of.value))), bar_cell(unit.scale * of.error_grid),
      bar_cell(unit.scale * of.error_time), bar_cell(unit.scale * of.error_model),
      escape_markup(typeset_unit(unit.unit)),
      std::isfinite(q.at)
          ? escape_markup(fmt::format("{} {}", figures(q.at), typeset_unit(q.at_unit)))
          : "");
}

std::string quantities_table(const StoredResult& result) {
  if (result.quantities.empty()) return "";
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>quantity</th><th>value</th><th>grid</th>"
      "<th>time steps</th><th>physics</th><th class=\"unit\">unit</th><th>at</th></tr></thead>"
      "<tbody>\n";
  for (const StoredQuantity& q : result.quantities) html += quantity_row(q);
  return html + "</tbody></table></div>\n";
}

Field shown_values(const std::vector<double>& values, const DisplayUnit& unit) {
  Field out;
  for (const double v : values) out.push_back(unit(v));
  return out;
}

/// The scale of what is drawn; depths of supplies are no gaps.
ColourScale field_scale(const StoredResult& result, const StoredValues& field,
                        const Field& values) {
  if (field.name == "theta") return {kCool, 0.0, 1.0};
  const StoredValues* supplied = field.name.starts_with("h") ? result.field("supplied") : nullptr;
  double low = INFINITY, high = -INFINITY;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k]) || (supplied != nullptr && supplied->values[k] != 0.0)) continue;
    low = std::min(low, values[k]);
    high = std::max(high, values[k]);
  }
  if (low > high) low = high = 0.0;
  const bool warm = field.units == "K";
  if (!warm) low = std::min(low, 0.0);
  const Axis range = tight_axis(low, high, 8, "");  // widened if the field is constant
  return {warm ? kWarm : kCool, range.low, range.high};
}

Axis axial_axis(const FilmGrid& grid) {
  return tight_axis(1e3 * grid.z_face.front(), 1e3 * grid.z_face.back(), 5, "z [mm]");
}

/// A field over phi and another coordinate.
std::string map_of(const StoredResult& result, const StoredValues& field) {
  const DisplayUnit unit = display_unit(field.name, field.units);
  const Field values = shown_values(field.values, unit);
  FieldMap map;
  // What fits above a map; the whole stands below it.
  const bool whole = field.long_name.size() <= kTitle;
  map.title = whole ? field.long_name : field.long_name.substr(0, field.long_name.find(','));
  map.unit = typeset_unit(unit.unit);
  map.scale = field_scale(result, field, values);
  map.x = degree_axis();
  if (field.axes == "phi r") {
    Field r;
    for (const double x : result.r) r.push_back(1e3 * x);
    map.surface = around(result.grid, r, values);
    map.y = tight_axis(r.front(), r.back(), 5, "r [mm]");
  } else {
    map.surface = unrolled(result.grid, values);
    map.y = axial_axis(result.grid);
  }
  return figure_html(kColumnWidth, kReportMap, field.long_name, whole ? "" : field.long_name,
                     [&](Svg& svg, const Box& box) { draw_map(svg, box, map, page_theme()); });
}

std::string maps_of(const StoredResult& result) {
  std::string html;
  for (const StoredValues& field : result.fields) {
    const bool drawn = field.axes == "phi z" || (field.axes == "phi r" && result.r.size() > 1);
    if (!drawn || field.name == "supplied" || field.values.empty()) continue;
    html += map_of(result, field);
  }
  if (const StoredValues* T = result.field("T"); T != nullptr && result.s.size() > 1) {
    bearing::Result film;
    film.fields.grid = result.grid;
    film.fields.s = result.s;
    film.fields.T = T->values;
    if (const StoredValues* supplied = result.field("supplied"); supplied != nullptr) {
      film.fields.supplied.assign(supplied->values.begin(), supplied->values.end());
    }
    const FieldMap across =
        across_film_map(film, "temperature across the film " + words_of_mid_line(film));
    html += figure_html(kColumnWidth, kReportMap, across.title, "", [&](Svg& svg, const Box& box) {
      draw_map(svg, box, across, page_theme());
    });
  }
  return figures_html(html);
}

/// Largest of all curves in these units: beside it a component is round-off.
double largest_beside(const std::vector<StoredValues>& all, const std::string& units) {
  double most = 0.0;
  for (const StoredValues& series : all) {
    if (series.units == units) most = larger(most, largest_magnitude(series.values));
  }
  return most;
}

std::string curves_over_cycle(const StoredResult& result) {
  const auto named = [&](const char* name) {
    return std::find_if(result.series.begin(), result.series.end(),
                        [&](const StoredValues& s) { return s.name == name; });
  };
  const bool crank = named("angle") != result.series.end();
  const auto x = named(crank ? "angle" : "t");
  if (x == result.series.end() || x->values.size() < 2) return "";
  const Theme theme = page_theme();
  std::string html, zero;
  for (const StoredValues& series : result.series) {
    if (series.name == "t" || series.name == "angle") continue;
    const double most = largest_magnitude(series.values);
    if (most <= kRoundOff * largest_beside(result.series, series.units)) {
      zero += (zero.empty() ? "Zero throughout: " : "; ") + series.long_name;
      continue;
    }
    const DisplayUnit unit = display_unit(series.name, series.units, most);
    LinePlot plot;
    const bool whole = series.long_name.size() <= kTitle;
    plot.title = whole ? series.long_name : series.long_name.substr(0, series.long_name.find(','));
    plot.x =
        tight_axis(x->values.front(), x->values.back(), 8, crank ? "crank angle [°]" : "time [s]");
    plot.y_title = "[" + typeset_unit(unit.unit) + "]";
    plot.from_zero = false;
    plot.series = {{"", x->values, shown_values(series.values, unit), theme.series.front(), ""}};
    html += figure_html(kColumnWidth, kReportCurve, series.long_name, whole ? "" : series.long_name,
                        [&](Svg& svg, Box box) {
                          box.width -= kLastTick;
                          draw_lines(svg, box, plot, theme);
                        });
  }
  if (!zero.empty()) zero = "<p class=\"scene\">" + escape_markup(zero) + ".</p>\n";
  return figures_html(html) + zero;
}

const std::vector<double>* values_of(const std::vector<StoredValues>& all, const char* name) {
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const StoredValues& v) { return v.name == name; });
  return at == all.end() ? nullptr : &at->values;
}

/// The film at instant k of all that are stored; empty where the file has none.
Field film_at(const StoredResult& result, const char* name, std::size_t k) {
  const auto cells = static_cast<std::size_t>(result.grid.cells());
  const std::vector<double>* all = values_of(result.frames, name);
  if (all == nullptr || all->size() < (k + 1) * cells) return {};
  const auto from = all->begin() + static_cast<std::ptrdiff_t>(k * cells);
  return {from, from + static_cast<std::ptrdiff_t>(cells)};
}

/// Journal and film over the cycle as the pictures of a cycle take them. The unit of length of the
/// journal's path is the clearance.
bearing::CycleResult motion_of(const StoredResult& result) {
  bearing::CycleResult cycle;
  cycle.crank_speed = result.crank_speed;
  cycle.fields.grid = result.grid;
  if (const std::vector<double>* t = values_of(result.series, "t")) {
    std::vector<CycleSeries> all;
    for (const StoredValues& s : result.series)
      all.push_back({s.name, s.units, s.long_name, s.values});
    cycle.instants = instants_of(*t, all);
  }
  const std::vector<double>* t = values_of(result.frames, "t");
  for (std::size_t k = 0; t != nullptr && k < t->size(); ++k) {
    bearing::CycleFrame frame;
    frame.t = (*t)[k];
    frame.p = film_at(result, "p", k);
    frame.theta = film_at(result, "theta", k);
    cycle.frames.push_back(std::move(frame));
  }
  return cycle;
}

/// Path of the journal and the film in motion; of a bore that is no cylinder without its room.
std::string motion_html(const StoredResult& result) {
  const bearing::CycleResult cycle = motion_of(result);
  if (cycle.instants.empty()) return "";
  bearing::Case scaled;
  scaled.bearing.radial_clearance = 1.0;
  scaled.bearing.radius = result.grid.radius;
  scaled.bearing.width = result.grid.width;
  const std::string film = cycle_animation_html(scaled, cycle);
  if (!film.empty()) return film;  // it has the path, too
  return figures_html(figure_html(
      kColumnWidth, kReportPath, "Path of the journal", "",
      [&](Svg& svg, const Box& box) { draw_orbit(svg, box, scaled, cycle, page_theme()); }));
}

std::string audit_told(const StoredResult& result) {
  std::string figures_told, cost;
  for (const auto& [name, value] : result.audit) {
    if (!std::isfinite(value)) continue;
    figures_told += fmt::format("{}{} {:.1e}", figures_told.empty() ? "" : ", ", name, value);
  }
  for (const auto& [name, value] : result.cost) {
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    cost += fmt::format("{}{} {}", cost.empty() ? "" : ", ", words, figures(value, 3));
  }
  const std::string grid = result.grid.cells() > 0
                               ? fmt::format("Grid {} × {}. ", result.grid.nt, result.grid.nz)
                               : std::string();
  return fmt::format("<p>Relative imbalances: {}.</p>\n<p>{}{}.</p>\n", escape_markup(figures_told),
                     grid, escape_markup(cost));
}

}  // namespace

std::string report_html(const StoredResult& result) {
  std::string html =
      page_head({.title = result.title, .scene = {result.scene, result.changes}, .kind = "result"});
  html += failure_of(result);
  html += page_section("Quantities, tier " + escape_markup(result.tier), quantities_table(result));
  html += notes_html(result.warnings, result.limiters, result.assumptions);
  html += page_section("The film over the cycle", motion_html(result));
  html += page_section("Over the cycle", curves_over_cycle(result));
  html += page_section("On the unrolled bearing", maps_of(result));
  html += page_section("Audit and cost", audit_told(result));
  html += page_section("Effects", effects_html(result.effects));
  return html + page_foot(result.provenance, result.verbatim);
}

}  // namespace shellback::app
