#include "app/write_surface.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/json_parts.hpp"
#include "app/labels/text_table.hpp"
#include "app/reading/surface_columns.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using namespace surface;
using json_parts::Json;
using json_parts::number;
using json_parts::with_unit;

std::string um(double x) { return fmt::format("{:.4g} um", 1e6 * x); }

/// "n/a" of what is not known.
std::string shown(const char* form, double x) {
  return std::isfinite(x) ? fmt::format(fmt::runtime(form), x) : "n/a";
}

std::string length(const CorrelationLength& l) { return (l.at_least ? "> " : "") + um(l.length); }

void write_heights(std::ostream& out, const SurfaceReport& r) {
  const auto& [Ra, Rq, skewness, kurtosis, highest, lowest] = r.heights;
  const Form& f = r.form;
  const Correlation& c = r.correlation;
  TextTable table(2);
  const auto add = [&table](const std::string& name, const std::string& value) {
    table.add({name, value});
  };
  add("map", fmt::format("{} x {} points, {} x {} (along x across the motion)", r.map.nx, r.map.ny,
                         um(r.map.length()), um(r.map.width())));
  add("form removed",
      fmt::format(
          "degree {}: tilt {:.3g} and {:.3g} mrad, curvature {:.3g} and {:.3g} 1/m; without "
          "its tilt it spans {}",
          f.degree, 1e3 * f.slope_x, 1e3 * f.slope_y, f.curvature_x, f.curvature_y,
          um(f.peak_to_valley)));
  add("Ra, Rq",
      fmt::format("{}, {} +- {:.2g} %", um(Ra), um(Rq), 100.0 * c.error_of_Rq(r.heights.kurtosis)));
  add("skewness, kurtosis", fmt::format("{:.3f}, {:.3f} (Gaussian: 0, 3)", skewness, kurtosis));
  add("highest, lowest", fmt::format("{}, {}", um(highest), um(lowest)));
  add("correlation length",
      fmt::format("{} along, {} across the motion", length(c.along), length(c.across)));
  add("orientation gamma",
      has_lay(c)
          ? fmt::format("{:.3g}; lay at {:.0f} deg to the motion", c.gamma, c.lay * 180.0 / kPi)
          : fmt::format("{:.3g}; no lay (longest length {:.2g} times the shortest)", c.gamma,
                        c.longest.length / c.shortest.length));
  add("independent areas", fmt::format("{:.3g}", c.independent));
  table.print(out);
}

/// K of the counted summits; NaN where the formula is not given.
double counted_factor(const SurfaceReport& r) {
  return scattered(r.counted, r.heights.Rq) ? elastic_factor(r.counted) : NAN;
}

void write_summits(std::ostream& out, const SurfaceReport& r) {
  TextTable table(1);
  table.add({"summits", "spectral moments", fmt::format("counted ({})", r.summits)});
  table.rule();
  const SummitStatistics &a = r.by_moments, &b = r.counted;
  const auto add = [&table](const char* name, double x, double y, double factor) {
    table.add({name, shown("{:.4g}", factor * x), shown("{:.4g}", factor * y)});
  };
  add("density [1/mm2]", a.density, b.density, 1e-6);
  add("mean radius [um]", a.radius, b.radius, 1e6);
  add("summit roughness [um]", a.roughness, b.roughness, 1e6);
  add("mean summit height [um]", a.height, b.height, 1e6);
  add("elastic factor K, two such [-]", elastic_factor(a), counted_factor(r), 1.0);
  table.print(out);
}

void write_contact(std::ostream& out, const SurfaceReport& r) {
  const auto [modulus, hardness] = std::pair(r.options.modulus, r.options.hardness);
  const double scale = modulus ? 1e-6 * *modulus : 1.0;
  const std::string unit = modulus ? " [MPa]" : "/E* [-]";
  TextTable table(1);
  std::vector<std::string> head{"h/Rq",    "two such: formula" + unit,   "summits" + unit,
                                "r_c [-]", "on a plane: summits" + unit, "bearing area [-]"};
  if (hardness) head.push_back("times hardness [MPa]");
  table.add(head);
  table.rule();
  for (const ContactRow& row : r.contact) {
    std::vector<std::string> cells{
        fmt::format("{:.1f}", row.h / r.heights.Rq), shown("{:.3e}", scale * row.pair_formula),
        shown("{:.3e}", scale * row.pair_summits),   shown("{:.3e}", row.pair_contact_ratio),
        shown("{:.3e}", scale * row.plane_summits),  fmt::format("{:.4f}", row.bearing_area)};
    if (hardness) cells.push_back(fmt::format("{:.3e}", 1e-6 * *hardness * row.bearing_area));
    table.add(cells);
  }
  table.print(out);
}

void write_factors(std::ostream& out, const SurfaceReport& r) {
  TextTable table(1);
  table.add(
      {"h/sigma", "contact", "hT/sigma", "phi_x", "phi_z", "phi_s", "phi_f", "phi_fs", "phi_fp"});
  table.rule();
  for (std::size_t k = 0; k < r.factors.rows.size(); ++k) {
    const FactorRow &v = r.factors.rows[k], &e = r.factors.errors[k];
    const auto cell = [&v, &e](double FactorRow::*f) {
      return fmt::format("{:.3f} +- {:.3f}", v.*f, e.*f);
    };
    table.add({fmt::format("{:g}", v.H), fmt::format("{:.3f}", v.contact),
               fmt::format("{:.3f}", v.average_gap), cell(&FactorRow::phi_x),
               cell(&FactorRow::phi_z), cell(&FactorRow::phi_s), cell(&FactorRow::phi_f),
               cell(&FactorRow::phi_fs), cell(&FactorRow::phi_fp)});
  }
  table.print(out);
}

/// The lines of a case for this surface, without those that the map does not tell.
void write_case_lines(std::ostream& out, const SurfaceReport& r) {
  const bool table = r.fault.problem.empty();
  out << fmt::format(
      "\nIn a case (counted summits):\n"
      "  [surfaces.shell]   # or surfaces.shaft\n"
      "  roughness = \"{}\"\n  {}orientation = {:.4g}{}\n",
      um(r.heights.Rq), table ? "# " : "", r.correlation.gamma,
      table ? "   # in the place of flow_factors, for Patir and Cheng's" : "");
  if (scattered(r.counted, r.heights.Rq)) {
    out << fmt::format("  summit_roughness = \"{}\"\n  summit_height = \"{}\"\n",
                       um(r.counted.roughness), um(r.counted.height));
  }
  const double K = counted_factor(r);
  if (!table && !std::isfinite(K)) return;
  out << "  [surfaces]\n";
  if (table) out << "  flow_factors = \"FILE.csv\"   # what --csv FILE.csv writes\n";
  if (!std::isfinite(K)) return;
  const auto modulus = r.options.modulus;
  out << fmt::format(
      "  # contact = {{ elastic_factor = {:.3g}, composite_modulus = \"{}\", friction = ... }}   # "
      "of two such surfaces\n",
      K, modulus ? fmt::format("{:.4g} GPa", 1e-9 * *modulus) : "... GPa");
}

Json summit_json(const SummitStatistics& s, double factor) {
  return {{"density", with_unit(s.density, "1/m2")},
          {"radius", with_unit(s.radius, "m")},
          {"summit_roughness", with_unit(s.roughness, "m")},
          {"summit_height", with_unit(s.height, "m")},
          {"elastic_factor_of_two_such", number(factor)}};
}

Json length_json(const CorrelationLength& l) {
  Json json = with_unit(l.length, "m");
  json["at_least"] = l.at_least;
  return json;
}

Json height_json(const SurfaceReport& r) {
  const HeightStatistics& s = r.heights;
  const Correlation& c = r.correlation;
  return {{"Ra", with_unit(s.Ra, "m")},
          {"Rq", with_unit(s.Rq, "m")},
          {"Rq_relative_error", number(c.error_of_Rq(r.heights.kurtosis))},
          {"skewness", number(s.skewness)},
          {"kurtosis", number(s.kurtosis)},
          {"highest", with_unit(s.highest, "m")},
          {"lowest", with_unit(s.lowest, "m")},
          {"correlation_length_along", length_json(c.along)},
          {"correlation_length_across", length_json(c.across)},
          {"gamma", number(c.gamma)},
          {"lay", {{"value", number(c.lay * 180.0 / kPi)}, {"unit", "deg"}}},
          {"independent_areas", number(c.independent)}};
}

Json map_json(const SurfaceReport& r) {
  const Form& f = r.form;
  return {{"file", r.options.path},
          {"motion", r.options.motion == Motion::x ? "x" : "y"},
          {"points", {r.map.nx, r.map.ny}},
          {"pitch", {with_unit(r.map.dx, "m"), with_unit(r.map.dy, "m")}},
          {"holes", r.holes.count},
          {"holes_filled_by", r.holes.count > 0 ? Json("laplace") : Json(nullptr)},
          {"form",
           {{"degree", f.degree},
            {"slope", {number(f.slope_x), number(f.slope_y)}},
            {"curvature", {with_unit(f.curvature_x, "1/m"), with_unit(f.curvature_y, "1/m")}},
            {"peak_to_valley", with_unit(f.peak_to_valley, "m")}}}};
}

Json contact_json(const SurfaceReport& r) {
  Json rows = Json::array();
  for (const ContactRow& row : r.contact) {
    rows.push_back({{"h", with_unit(row.h, "m")},
                    {"pair_formula", number(row.pair_formula)},
                    {"pair_summits", number(row.pair_summits)},
                    {"pair_contact_ratio", number(row.pair_contact_ratio)},
                    {"plane_summits", number(row.plane_summits)},
                    {"bearing_area", number(row.bearing_area)}});
  }
  Json json{{"pressure_per", "composite modulus"}, {"rows", rows}};
  if (r.options.modulus) json["composite_modulus"] = with_unit(*r.options.modulus, "Pa");
  if (r.options.hardness) json["hardness"] = with_unit(*r.options.hardness, "Pa");
  return json;
}

Json factor_json(const FactorRow& v) {
  return {{"h_over_sigma", number(v.H)},
          {"contact_area", number(v.contact)},
          {"average_gap", number(v.average_gap)},
          {"phi_x", number(v.phi_x)},
          {"phi_z", number(v.phi_z)},
          {"phi_s", number(v.phi_s)},
          {"phi_f", number(v.phi_f)},
          {"phi_fs", number(v.phi_fs)},
          {"phi_fp", number(v.phi_fp)}};
}

}  // namespace

void write_surface_table(std::ostream& out, const SurfaceReport& r) {
  write_heights(out, r);
  out << "\n";
  write_summits(out, r);
  out << "\n";
  write_contact(out, r);
  out << "\nFlow factors (x along the motion, z across; +- standard error, from the map's "
         "quarters)\n";
  write_factors(out, r);
  for (const std::string& note : r.notes) out << "note: " << note << "\n";
  write_case_lines(out, r);
}

std::string surface_json(const SurfaceReport& r) {
  Json json{{"map", map_json(r)}, {"heights", height_json(r)}};
  json["moments"] = {{"m0", with_unit(r.moments.m0, "m2")},
                     {"m2", {number(r.moments.m2x), number(r.moments.m2y)}},
                     {"m4", {with_unit(r.moments.m4x, "1/m2"), with_unit(r.moments.m4y, "1/m2")}},
                     {"alpha", number(r.moments.alpha())}};
  json["summits"] = {{"by_moments", summit_json(r.by_moments, elastic_factor(r.by_moments))},
                     {"counted", summit_json(r.counted, counted_factor(r))},
                     {"count", r.summits}};
  json["contact"] = contact_json(r);
  Json rows = Json::array(), errors = Json::array();
  for (const FactorRow& row : r.factors.rows) rows.push_back(factor_json(row));
  for (const FactorRow& row : r.factors.errors) errors.push_back(factor_json(row));
  json["flow_factors"] = {{"ends", r.options.periodic ? "periodic" : "patch"},
                          {"rows", rows},
                          {"standard_errors", errors}};
  json["notes"] = r.notes;
  return json_parts::dump(json);
}

std::string surface_csv(const SurfaceReport& r) {
  if (!r.fault.problem.empty()) {
    throw InputError(r.options.path,
                     fmt::format("no case can take the factors of this map, and --csv is not "
                                 "written: {}; take other gaps (--gaps) or a larger map",
                                 r.fault.problem));
  }
  constexpr std::array kErrors{&FactorRow::phi_x, &FactorRow::phi_z,  &FactorRow::phi_s,
                               &FactorRow::phi_f, &FactorRow::phi_fs, &FactorRow::phi_fp};
  std::string out = "sigma [um]";
  for (const FactorColumn& column : kFactorColumns) out += fmt::format(",{} [1]", column.name);
  for (const char* note : kFactorNotes) out += fmt::format(",{} [1]", note);
  out += "\n";
  for (std::size_t k = 0; k < r.table.H.size(); ++k) {
    // The table holds the last rows: those above the last closed gap.
    const std::size_t row = r.factors.rows.size() - r.table.H.size() + k;
    out += fmt::format("{:.8g}", 1e6 * r.table.sigma);
    for (const FactorColumn& column : kFactorColumns) {
      out += fmt::format(",{:.8g}", (r.table.*column.values)[k]);
    }
    out += fmt::format(",{:.6g},{:.6g}", r.correlation.gamma, r.factors.rows[row].contact);
    for (const auto error : kErrors) out += fmt::format(",{:.3g}", r.factors.errors[row].*error);
    out += "\n";
  }
  return out;
}

}  // namespace shellback::app
