#include "app/write_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/json_parts.hpp"
#include "app/labels/indistinct.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/labels/sweep_columns.hpp"
#include "app/labels/tolerance_words.hpp"
#include "app/words/effect_words.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"

namespace shellback::app {
namespace {

using namespace json_parts;

Json quantities(const bearing::Result& result) {
  Json all = Json::object();
  for (const auto& q : result.quantities) {
    Json& entry = all[q.name] = with_unit(q.value, q.unit);
    add_bars(entry, q);
  }
  return all;
}

template <std::size_t N>
Json rows(const std::array<std::array<double, N>, N>& m, int size) {
  Json all = Json::array();
  for (int i = 0; i < size; ++i) {
    Json row = Json::array();
    for (int j = 0; j < size; ++j) row.push_back(number(m[i][j]));
    all.push_back(row);
  }
  return all;
}

const char* words(bearing::WhirlVerdict verdict) {
  switch (verdict) {
    case bearing::WhirlVerdict::always_stable:
      return "stable whatever the mass";
    case bearing::WhirlVerdict::never_stable:
      return "unstable whatever the mass";
    case bearing::WhirlVerdict::threshold:
      break;
  }
  return "stable up to the critical mass";
}

Json coefficients(const bearing::Coefficients& k) {
  Json json;
  if (!k.verdict.good()) {
    json["reason"] = reason_of(k.verdict);
    return json;
  }
  json["convention"] =
      "force on the journal = -K x - C dx/dt; x right, y up; rows are forces, columns "
      "displacements";
  json["K"] = {{"value", rows(k.K, 2)}, {"unit", "N/m"}};
  json["C"] = {{"value", rows(k.C, 2)}, {"unit", "N s/m"}};
  if (k.unknowns == 4) {  // SI throughout: radians here, as the units say
    json["K_with_tilt"] = {{"value", rows(k.K, 4)}, {"unit", "N, N m per m, rad"}};
    json["C_with_tilt"] = {{"value", rows(k.C, 4)}, {"unit", "N s, N m s per m, rad"}};
  }
  json["load_axes"] = {{"convention", "x along the load, y a quarter turn on with the rotation"},
                       {"K_c_over_W", rows(k.K_load, 2)},
                       {"C_c_omega_over_W", rows(k.C_load, 2)}};
  json["load"] = {{"value", number(k.load)}, {"unit", "N"}};
  json["clearance"] = {{"value", number(k.clearance)}, {"unit", "m"}};
  json["speed"] = {{"value", number(k.omega)}, {"unit", "rad/s"}};
  json["whirl"] = {{"rigid_rotor", words(k.whirl.verdict)},
                   {"critical_mass", {{"value", number(k.whirl.critical_mass)}, {"unit", "kg"}}},
                   {"speed_ratio", number(k.speed_ratio)},
                   {"whirl_ratio", number(k.whirl_ratio)}};
  json["cavitated_share_of_damping"] = number(k.cavitated_share);
  json["wall_s"] = number(k.wall_s);
  return json;
}

/// Temperatures at which the lumped heat balance is met, rising; the lowest stable one is solved.
Json heat_roots(const bearing::Result& result) {
  const auto solution = std::find_if(result.heat_roots.begin(), result.heat_roots.end(),
                                     [](const auto& root) { return root.stable(); });
  Json all = Json::array();
  for (const auto& root : result.heat_roots) {
    all.push_back({{"T_film_mean", with_unit(root.T, "K")},
                   {"stable", root.stable()},
                   {"solution", solution != result.heat_roots.end() && root.T == solution->T},
                   {"friction_torque", with_unit(root.friction_torque, "N m")},
                   {"h_min", with_unit(root.h_min, "m")}});
  }
  return all;
}

Json history(const bearing::Result& result) {
  Json all = Json::array();
  for (const auto& entry : result.history) {
    all.push_back({{"stage", entry.stage},
                   {"residual", number(entry.residual)},
                   {"friction_torque", number(entry.friction_torque)},
                   {"h_min", number(entry.h_min)}});
  }
  return all;
}

Json supplies_json(const bearing::Result& result) {
  Json all = Json::array();
  for (const bearing::SupplyState& s : result.supplies) {
    Json one = {{"flow", with_unit(s.flow, "m3/s")}};
    if (std::isfinite(s.T_mixed)) one["T_mixed"] = with_unit(s.T_mixed, "K");
    all.push_back(std::move(one));
  }
  return all;
}

Json audit_json(const bearing::Audit& a) {
  return {{"mass", number(a.mass)},
          {"energy", number(a.energy)},
          {"load", number(a.load)},
          {"moment", number(a.moment)}};
}

Json to_json(const bearing::Case& c, const bearing::Result& result) {
  Json json;
  add_head(json, c, result);
  json["quantities"] = quantities(result);
  if (!result.supplies.empty()) json["supplies"] = supplies_json(result);
  json["audit"] = audit_json(result.audit);
  if (result.coefficients) json["coefficients"] = coefficients(*result.coefficients);
  if (!result.heat_roots.empty()) json["heat_roots"] = heat_roots(result);
  json["effects"] = effects_json(result.effects);
  add_notes(json, result);
  json["history"] = history(result);
  json["provenance"] = provenance_json(c);
  return json;
}

Json measured_json(const bearing::Measured& m) {
  Json json = Json::object();
  const auto add = [&](const char* name, const std::optional<double>& value, const char* unit) {
    if (value) json[name] = with_unit(*value, unit);
  };
  add("shell_back_temperature", m.shell_back_temperature, "K");
  add("friction_torque", m.friction_torque, "N m");
  add("h_min", m.h_min, "m");
  add("p_max", m.p_max, "Pa");
  add("side_flow", m.side_flow, "m3/s");
  add("eccentricity_ratio", m.eccentricity_ratio, "-");
  add("T_shell_max", m.T_shell_max, "K");
  return json;
}

Json split_json(const bearing::FrictionSplit& split) {
  if (split.steps.empty()) return nullptr;
  Json steps = Json::array();
  for (const auto& step : split.steps) {
    steps.push_back({{"name", step.name}, {"change", number(step.change)}, {"unit", "N m"}});
  }
  return {{"from", number(split.from)},
          {"to", number(split.to)},
          {"unit", "N m"},
          {"steps", steps},
          {"rest", number(unexplained(split))}};
}

Json axis_json(const study::Axis& axis) {
  Json json{{"key", axis.key}, {"spacing", to_string(axis.spacing)}};
  if (axis.numbers.empty()) {
    json["values"] = axis.words;
  } else {
    json["unit"] = axis.unit.empty() ? "1" : axis.unit;
    json["values"] = axis.numbers;
  }
  return json;
}

Json point_json(const study::Sweep& sweep, int index) {
  const study::SweepPoint& point = sweep.points[index];
  Json json{{"at", indices_of(sweep, index)}};
  json["status"] = status_word(point);
  json["converged"] = point.good();
  json["start"] = to_string(point.start);
  json["tries"] = point.tries;
  json["wall_s"] = number(point.wall_s);
  if (!point.tried()) return json;
  json["tier"] = to_string(point.result.tier);
  if (!point.good()) {
    add_status(json, point.result.verdict);
    return json;
  }
  json["quantities"] = quantities(point.result);
  json["audit"] = audit_json(point.result.audit);
  json["warnings"] = words_of(point.result.warnings);
  json["grid"] = point.result.grid;
  json["cost"] = cost_json(point.result.cost);
  return json;
}

}  // namespace

std::string result_json(const bearing::Case& c, const bearing::Result& result) {
  Json json = to_json(c, result);
  add_case(json, c);
  return dump(json);
}

std::string comparison_json(const bearing::Case& c, const bearing::Comparison& comparison) {
  const auto& results = comparison.results;
  const auto failed = [](const auto& r) { return !r.verdict.good(); };
  const auto bad = std::find_if(results.begin(), results.end(), failed);
  Json json;
  add_status(json, bad == results.end() ? Verdict{} : bad->verdict);
  json["title"] = c.title;
  json["results"] = Json::array();
  for (const auto& result : results) json["results"].push_back(to_json(c, result));
  json["indistinct"] = Json::array();
  for (const Indistinct& pair : indistinct(comparison)) {
    json["indistinct"].push_back(
        {{"quantity", pair.quantity}, {"results", {pair.first, pair.second}}});
  }
  add_case(json, c);
  json["measured"] = measured_json(c.measured);
  json["friction_split"] = split_json(comparison.split);
  const bearing::Calibration& at = comparison.calibration;
  json["T_calibrated"] = at.found() ? with_unit(at.T, "K") : Json(nullptr);
  json["provenance"] = provenance_json(c);
  return dump(json);
}

std::string sweep_json(const bearing::Case& subject, const study::Sweep& sweep) {
  Json json{{"title", subject.title}};
  json["converged"] = sweep.count_good();
  json["failed"] = sweep.count_failed();
  json["points_total"] = sweep.points.size();
  json["interrupted"] = sweep.interrupted;
  json["axes"] = Json::array();
  for (const auto& axis : sweep.axes) json["axes"].push_back(axis_json(axis));
  json["points"] = Json::array();
  for (const int index : reading_order(sweep)) json["points"].push_back(point_json(sweep, index));
  json["indistinct"] = Json::array();
  for (const Indistinct& pair : indistinct(sweep)) {
    json["indistinct"].push_back(
        {{"quantity", pair.quantity},
         {"at", {indices_of(sweep, pair.first), indices_of(sweep, pair.second)}}});
  }
  const Missed missed = missed_tolerance(subject, sweep);
  json["tolerance"] = {{"asked", subject.model.tolerance}, {"met", !missed}};
  if (!missed.command.empty()) json["tolerance"]["command"] = missed.command;
  add_case(json, subject);  // at the first point
  json["threads"] = sweep.threads;
  json["wall_s"] = number(sweep.wall_s);
  json["measured"] = measured_json(subject.measured);
  json["provenance"] = provenance_json(subject);
  return dump(json);
}

}  // namespace shellback::app
