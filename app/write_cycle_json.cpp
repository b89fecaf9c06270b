#include "app/write_cycle_json.hpp"

#include <cmath>

#include "app/json_parts.hpp"
#include "app/labels/cycle_shown.hpp"
#include "app/words/note_words.hpp"

namespace shellback::app {
namespace {

using namespace json_parts;
using bearing::CycleResult;

Json quantities(const CycleResult& cycle) {
  Json all = Json::object();
  for (const auto& q : cycle.quantities) {
    const std::string& unit = q.quantity.unit;
    Json& entry = all[q.quantity.name] = with_unit(q.quantity.value, unit);
    if (std::isfinite(q.at)) entry["at"] = with_unit(shown_instant(cycle, q.at), told_unit(cycle));
    const auto add = [&](const char* key, double bar) {  // what is not known is not there
      if (std::isfinite(bar)) entry[key] = with_unit(bar, unit)["value"];
    };
    add("error", q.quantity.error());
    add("error_grid", q.quantity.error_grid);
    add("error_time", q.quantity.error_time);
    add("error_model", q.quantity.error_model);
  }
  return all;
}

Json series_json(const CycleSeries& series) {
  Json values = Json::array();
  for (const double v : series.values) values.push_back(with_unit(v, series.unit)["value"]);
  return {{"unit", with_unit(0.0, series.unit)["unit"]}, {"values", values}};
}

Json over_the_cycle(const bearing::Case& c, const CycleResult& cycle) {
  Json json;
  const CycleSeries instants = instants_told(cycle);
  json[instants.name] = series_json(instants);
  for (const CycleSeries& series : followed(c, cycle)) json[series.name] = series_json(series);
  json["closure"] = number(cycle.closure);
  if (std::isfinite(cycle.growth)) json["growth"] = cycle.growth;
  json["cycles"] = cycle.cycles;
  json["steps"] = cycle.steps;
  json["rejected_steps"] = cycle.rejected_steps;
  json["period"] = with_unit(cycle.period, "s");
  return json;
}

}  // namespace

std::string cycle_json(const bearing::Case& c, const CycleResult& cycle) {
  Json json;
  add_status(json, cycle.verdict);
  json["tier"] = to_string(cycle.tier);
  if (cycle.choice) {
    const bearing::AutoChoice& k = *cycle.choice;
    json["chosen_by"] = "auto";
    json["solved"] = k.solved;
  }
  if (cycle.verdict.good()) json["tolerance"] = tolerance_json(c, bearing::as_result(cycle));
  json["title"] = cycle.title;
  json["quantities"] = quantities(cycle);
  for (const AuditFigure& a : audit_of(cycle)) json["audit"][a.name] = number(a.value);
  json["cycle"] = over_the_cycle(c, cycle);
  json["limiters"] = limiters_json(cycle.limiters);
  json["warnings"] = words_of(cycle.warnings);
  json["assumptions"] = words_of(cycle.assumptions);
  json["grid"] = cycle.grid;
  json["cost"] = cost_json(cycle.cost);
  json["provenance"] = provenance_json(c);
  add_case(json, c);
  return dump(json);
}

}  // namespace shellback::app
