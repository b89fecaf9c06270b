#include <cmath>
#include <nlohmann/json.hpp>

#include "proof/honesty_report.hpp"

namespace shellback::proof {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double v : values) list.push_back(number(v));
  return list;
}

Json coverage_json(const Coverage& c) {
  return {{"bars", c.count},
          {"held", number(c.held)},
          {"median_ratio", number(c.median)},
          {"unknown", c.unknown}};
}

Json sample_json(const HonestyRecord& record, const BarSample& s) {
  return {{"case", record.subjects[s.subject]},
          {"tier", to_string(s.tier)},
          {"grid", s.grid},
          {"quantity", s.quantity},
          {"value", number(s.value)},
          {"size", number(s.size)},
          {"error_grid", number(s.error_grid)},
          {"error_model", number(s.error_model)},
          {"truth_tier", number(s.truth_tier)},
          {"truth_limit", number(s.truth_limit)},
          {"truth_full", number(s.truth_full)},
          {"given", s.given},
          {"richest", s.richest},
          {"levels", numbers(s.levels)},
          {"cell_sizes", numbers(s.sizes)},
          {"node_change", number(s.node_change)},
          {"model_change", number(s.model_change)}};
}

}  // namespace

std::string honesty_json(const HonestyRecord& record) {
  Json json;
  json["grid_bars"] = coverage_json(coverage_of(record.samples, BarKind::grid));
  json["grid_bars_to_the_limit"] = coverage_json(coverage_of(record.samples, BarKind::limit));
  json["total_bars"] = coverage_json(coverage_of(record.samples, BarKind::total));
  json["costs"] = Json::array();
  for (const BarCost& c : record.costs) {
    json["costs"].push_back({{"tier", to_string(c.tier)},
                             {"grid", c.grid},
                             {"solve_s", c.solve_s},
                             {"bars_s", c.bars_s}});
  }
  json["refusals"] = Json::array();
  for (const HonestyRefusal& r : record.refusals) {
    json["refusals"].push_back({{"case", record.subjects[r.subject]},
                                {"tier", to_string(r.tier)},
                                {"grid", r.grid},
                                {"status", r.status},
                                {"reason", r.reason}});
  }
  json["samples"] = Json::array();
  for (const BarSample& s : record.samples) json["samples"].push_back(sample_json(record, s));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shellback::proof
