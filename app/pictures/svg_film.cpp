#include "app/pictures/svg_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/constants.hpp"

namespace shellback::app {
namespace {

using bearing::Case;
using bearing::Fields;
using bearing::Result;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

const Field& field_of(const Fields& f, FilmField which) {
  switch (which) {
    case FilmField::pressure:
      return f.p;
    case FilmField::fill:
      return f.theta;
    case FilmField::gap:
      return f.h;
    case FilmField::temperature:
      return f.T_mean;
    case FilmField::shell_temperature:
      return f.T_shell_surface;
  }
  return f.p;
}

DisplayUnit unit_of(FilmField which) {
  switch (which) {
    case FilmField::pressure:
      return display_unit("p", "Pa");
    case FilmField::fill:
      return {"", 1.0, 0.0};
    case FilmField::gap:
      return display_unit("h", "m");
    default:
      return display_unit("T_mean", "K");
  }
}

Field shown(const Field& field, const DisplayUnit& unit) {
  Field out;
  for (const double v : field) out.push_back(unit(v));
  return out;
}

bool supplied(const Fields& f, int cell) { return !f.supplied.empty() && f.supplied[cell] != 0; }

double degrees_of(double phi) {
  const double turns = phi / (2.0 * kPi);
  return 360.0 * (turns - std::floor(turns));
}

Mark mark(const Fields& f, int cell, const std::string& label) {
  return {{degrees_of(f.grid.phi[cell / f.grid.nz]), 1e3 * f.grid.z[cell % f.grid.nz]}, label};
}

int index_of(const Field& field, Field::const_iterator at) {
  return static_cast<int>(at - field.begin());
}

/// Mark of the extreme that belongs to the map. The smallest gap and the largest pressure are
/// labelled with the reported quantities, which also know the rims; the circle is at the cell.
std::vector<Mark> marks_of(const Result& result, FilmField which) {
  const Fields& f = result.fields;
  const Field& field = field_of(f, which);
  if (!drawable(field)) return {};
  const int highest = index_of(field, std::max_element(field.begin(), field.end()));
  const int lowest = index_of(field, std::min_element(field.begin(), field.end()));
  const auto shown_value = [&](const char* name, double in_field) {
    return figures(unit_of(which)(result.has(name) ? result.value(name) : in_field), 3);
  };
  switch (which) {
    case FilmField::pressure:
      return {mark(f, highest, "p_max " + shown_value("p_max", field[highest]) + " MPa")};
    case FilmField::gap:
      return {mark(f, lowest, "h_min " + shown_value("h_min", field[lowest]) + " µm")};
    case FilmField::temperature:
    case FilmField::shell_temperature:
      return {mark(f, highest, "max " + figures(unit_of(which)(field[highest]), 4) + " °C")};
    case FilmField::fill:
      break;
  }
  return {};
}

Axis z_axis(const FilmGrid& grid) {
  return tight_axis(1e3 * grid.z_face.front(), 1e3 * grid.z_face.back(), 5, "z [mm]");
}

/// The two rows of cells beside a place along the bearing, and the weight of the first.
struct RowsBeside {
  int a = 0;
  int b = 0;
  double weight = 1.0;
};
RowsBeside rows_beside(const FilmGrid& grid, double z) {
  int b = 0;
  while (b + 1 < grid.nz && grid.z[b] < z) ++b;
  const int a = std::max(0, b - 1);
  const double span = grid.z[b] - grid.z[a];
  return {a, b, span > 0.0 ? std::clamp((grid.z[b] - z) / span, 0.0, 1.0) : 0.0};
}

bool supplied_all_round(const Fields& f, int row) {
  for (int i = 0; i < f.grid.nt; ++i) {
    if (!supplied(f, f.grid.index(i, row))) return false;
  }
  return f.grid.nt > 0;
}

/// Mid-width; of a groove all round there the middle of the land beside it, on the side of z > 0.
double place_of_lines(const Fields& f) {
  if (f.supplied.empty()) return 0.0;
  const auto [a, b, weight] = rows_beside(f.grid, 0.0);
  if (!supplied_all_round(f, a) && !supplied_all_round(f, b)) return 0.0;
  int land = b;
  while (land + 1 < f.grid.nz && supplied_all_round(f, land)) ++land;
  return 0.5 * (f.grid.z_face[land] + f.grid.z_face.back());
}

}  // namespace

bool has_field(const Result& result, FilmField which) {
  return !field_of(result.fields, which).empty() && result.fields.grid.cells() > 0;
}

ColourScale common_scale(const std::vector<const Result*>& results, FilmField which) {
  const DisplayUnit unit = unit_of(which);
  const bool warm = which == FilmField::temperature || which == FilmField::shell_temperature;
  if (which == FilmField::fill) return {kCool, 0.0, 1.0};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Result* result : results) {
    const Field& field = field_of(result->fields, which);
    for (std::size_t k = 0; k < field.size(); ++k) {
      if (!std::isfinite(field[k])) continue;
      if (which == FilmField::gap && supplied(result->fields, static_cast<int>(k))) continue;
      low = std::min(low, unit(field[k]));
      high = std::max(high, unit(field[k]));
    }
  }
  if (low > high) low = high = 0.0;
  if (!warm) low = std::min(low, 0.0);
  const Axis range = tight_axis(low, high, 8, "");  // widened if the field is constant
  return {warm ? kWarm : kCool, range.low, range.high};
}

FieldMap film_map(const Case& c, const Result& result, FilmField which, const ColourScale& scale,
                  const std::string& title) {
  const Fields& f = result.fields;
  const DisplayUnit unit = unit_of(which);
  FieldMap map{title,
               typeset_unit(unit.unit),
               unrolled(f.grid, shown(field_of(f, which), unit)),
               scale,
               degree_axis(),
               z_axis(f.grid),
               {},
               {},
               marks_of(result, which)};
  for (const auto& supply : c.supplies) {
    if (supply.kind == bearing::SupplyKind::drilling) continue;  // it is everywhere in turn
    const auto raw = supply_outline(supply, c.bearing.radius);
    for (int turn = -2; turn <= 2; ++turn) {
      std::vector<Point> moved = raw;
      for (auto& p : moved) p.x += 360.0 * turn;
      const auto seen = [](const Point& p) { return p.x >= 0.0 && p.x <= 360.0; };
      if (std::any_of(moved.begin(), moved.end(), seen)) map.outlines.push_back(moved);
    }
  }
  if (!f.theta.empty()) {
    // The sides are moved out of sight: only the film's own ends are to be drawn.
    Surface film = unrolled(f.grid, f.theta);
    film.x.front() -= 1.0;
    film.x.back() += 1.0;
    film.y.front() -= 1.0;
    film.y.back() += 1.0;
    map.full_film = std::move(film);
  }
  return map;
}

FieldMap across_film_map(const Result& result, const std::string& title) {
  const Fields& f = result.fields;
  const auto ns = static_cast<int>(f.s.size());
  const RowsBeside mid = rows_beside(f.grid, place_of_lines(f));
  const DisplayUnit unit = unit_of(FilmField::temperature);
  std::vector<double> T;
  for (int i = 0; i < f.grid.nt; ++i) {
    for (int k = 0; k < ns; ++k) {
      const double a = f.T[f.grid.index(i, mid.a) * ns + k];
      const double b = f.T[f.grid.index(i, mid.b) * ns + k];
      T.push_back(unit(mid.weight * a + (1.0 - mid.weight) * b));
    }
  }
  ColourScale scale{kWarm, 0.0, 1.0};
  if (drawable(T)) {
    const auto [low, high] = std::minmax_element(T.begin(), T.end());
    const Axis range = tight_axis(*low, *high, 8, "");
    scale = {kWarm, range.low, range.high};
  }
  return {title,
          "°C",
          around(f.grid, f.s, T),
          scale,
          degree_axis(),
          tight_axis(0.0, 1.0, 5, "y/h  (0 shell, 1 journal)"),
          {},
          {},
          {}};
}

std::vector<Point> supply_outline(const bearing::Supply& supply, double radius) {
  constexpr int kCorners = 48;  ///< of the polygon that stands for a hole
  const double phi = supply.angle * 180.0 / kPi;
  const double z = 1e3 * supply.z;
  std::vector<Point> outline;
  if (supply.kind == bearing::SupplyKind::hole) {
    const double half = 0.5 * supply.diameter;
    for (int k = 0; k < kCorners; ++k) {
      const double a = 2.0 * kPi * k / kCorners;
      outline.push_back(
          {phi + half / radius * 180.0 / kPi * std::cos(a), z + 1e3 * half * std::sin(a)});
    }
    return outline;
  }
  const double half_arc = 0.5 * supply.arc * 180.0 / kPi;
  const double half_length = 0.5e3 * supply.length;
  return {{phi - half_arc, z - half_length},
          {phi + half_arc, z - half_length},
          {phi + half_arc, z + half_length},
          {phi - half_arc, z + half_length}};
}

std::string words_of_mid_line(const Result& result) {
  const double z = place_of_lines(result.fields);
  return z > 0.0 ? "midway on a land, z = " + figures(1e3 * z, 3) + " mm" : "at mid-width";
}

Series mid_line(const Result& result, const Field& field, const DisplayUnit& show,
                bool hide_supplied) {
  const Fields& f = result.fields;
  const FilmGrid& grid = f.grid;
  const RowsBeside mid = rows_beside(grid, place_of_lines(f));
  std::vector<int> order(grid.nt);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return degrees_of(grid.phi[a]) < degrees_of(grid.phi[b]); });
  Series series;
  for (const int i : order) {
    const int a = grid.index(i, mid.a);
    const int b = grid.index(i, mid.b);
    const double value = show(mid.weight * field[a] + (1.0 - mid.weight) * field[b]);
    series.x.push_back(degrees_of(grid.phi[i]));
    series.y.push_back(hide_supplied && (supplied(f, a) || supplied(f, b)) ? kNotANumber : value);
  }
  return series;
}

}  // namespace shellback::app
