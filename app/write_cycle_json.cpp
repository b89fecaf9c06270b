#include "app/write_cycle_json.hpp"

#include <cmath>

#include "app/json_parts.hpp"
#include "app/labels/cycle_shown.hpp"

namespace shellback::app {
namespace {

using namespace json_parts;
using bearing::CycleResult;

Json quantities(const CycleResult& cycle) {
  Json all = Json::object();
  for (const auto& q : cycle.quantities) {
    Json& entry = all[q.quantity.name] = with_unit(q.quantity.value, q.quantity.unit);
    if (std::isfinite(q.at)) entry["at"] = with_unit(shown_instant(cycle, q.at), told_unit(cycle));
    add_bars(entry, q.quantity);
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
  const bearing::Result result = bearing::as_result(cycle);
  add_head(json, c, result);
  json["quantities"] = quantities(cycle);
  for (const AuditFigure& a : audit_of(cycle)) json["audit"][a.name] = number(a.value);
  json["effects"] = effects_json(cycle.effects);
  json["cycle"] = over_the_cycle(c, cycle);
  add_notes(json, result);
  json["provenance"] = provenance_json(c);
  add_case(json, c);
  return dump(json);
}

}  // namespace shellback::app
