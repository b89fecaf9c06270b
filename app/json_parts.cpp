#include "app/json_parts.hpp"

#include <cmath>

#include "app/case_json.hpp"
#include "app/labels/tolerance_words.hpp"
#include "app/provenance.hpp"
#include "app/words/effect_words.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"
#include "core/constants.hpp"
#include "fidelity/tolerance.hpp"

namespace shellback::app::json_parts {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number_from(const Json& json) { return json.is_number() ? json.get<double>() : NAN; }

Json with_unit(double value, const std::string& unit) {
  if (unit == "rad") return {{"value", number(value * 180.0 / kPi)}, {"unit", "deg"}};
  return {{"value", number(value)}, {"unit", unit}};
}

void add_status(Json& json, const Verdict& verdict) {
  json["status"] = to_string(verdict.status);
  json["converged"] = verdict.good();
  if (verdict.good()) return;
  const EndingWords words = words_of(verdict);
  json["reason"] = words.reason;
  json["place"] = words.place;
  json["cure"] = words.cure;
}

void add_bars(Json& entry, const bearing::Quantity& q) {
  const auto add = [&](const char* key, double bar) {  // what is not known is not there
    if (std::isfinite(bar)) entry[key] = with_unit(bar, q.unit)["value"];
  };
  add("error", q.error());
  add("error_grid", q.error_grid);
  add("error_time", q.error_time);
  add("error_model", q.error_model);
  add("limit", q.limit);
}

void add_head(Json& json, const bearing::Case& c, const bearing::Result& result) {
  add_status(json, result.verdict);
  json["tier"] = to_string(result.tier);
  if (result.choice) {
    json["chosen_by"] = "auto";
    json["solved"] = result.choice->solved;
  }
  if (result.verdict.good()) json["tolerance"] = tolerance_json(c, result);
  json["title"] = result.title;
}

void add_notes(Json& json, const bearing::Result& result) {
  json["limiters"] = limiters_json(result.limiters);
  json["warnings"] = app::words_of(result.warnings);
  json["assumptions"] = app::words_of(result.assumptions);
  json["grid"] = result.grid;
  json["cost"] = cost_json(result.cost);
}

Json cost_json(const bearing::Cost& k) {
  return {{"wall_s", number(k.wall_s)},
          {"setup_s", number(k.setup_s)},
          {"factorizations", k.factorizations},
          {"newton_iterations", k.newton_iterations},
          {"outer_iterations", k.outer_iterations},
          {"bars_s", number(k.bars_s)}};
}

Json effects_json(const std::vector<bearing::Effect>& effects) {
  Json all = Json::array();
  for (const auto& e : effects) {
    all.push_back({{"name", name_of(e.kind)},
                   {"included", e.included},
                   {"indicator", number(e.indicator)},
                   {"change_in_friction", number(e.change_in_friction)},
                   {"change_in_h_min", number(e.change_in_h_min)},
                   {"meaning", meaning_of(e)}});
  }
  return all;
}

Json limiters_json(const std::vector<bearing::LimiterCount>& limiters) {
  Json all = Json::array();
  for (const auto& l : limiters) all.push_back({{"what", words_of(l.what)}, {"count", l.count}});
  return all;
}

Json provenance_json(const bearing::Case& c) {
  const Provenance p = provenance(c);
  Json libraries = Json::object();
  for (const auto& [name, version] : p.libraries) libraries[name] = version;
  return {{"version", p.version},
          {"git", p.git},
          {"input", p.input},
          {"input_fnv1a64", p.fingerprint},
          {"libraries", libraries}};
}

Json tolerance_json(const bearing::Case& c, const bearing::Result& result) {
  const auto s = fidelity::shortfall(result, c.model.tolerance);
  const auto& choice = result.choice;
  const bool known = std::isfinite(s.friction.total()) || std::isfinite(s.h_min.total());
  Json json{{"asked", choice ? choice->tolerance : s.tolerance},
            {"met", nullptr},
            {"friction_torque", number(choice ? choice->bar_friction : s.friction.total())},
            {"h_min", number(choice ? choice->bar_h_min : s.h_min.total())}};
  if (choice) json["met"] = choice->met;
  if (!choice && (known || !s.met)) json["met"] = s.met;  // else bars are missing
  const Missed missed = missed_tolerance(c, result);
  if (!missed.command.empty()) json["command"] = missed.command;
  return json;
}

void add_case(Json& json, const bearing::Case& c) {
  json["changes"] = changes_json(c);
  json["case"] = case_json(c);
}

std::string dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shellback::app::json_parts
