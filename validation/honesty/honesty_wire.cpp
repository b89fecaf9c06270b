#include "validation/honesty/honesty_wire.hpp"

#include "app/json_parts.hpp"
#include "app/reading/read_case.hpp"

namespace shellback::validation {
namespace {

using namespace app::json_parts;

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double v : values) list.push_back(number(v));
  return list;
}

std::vector<double> numbers_from(const Json& list) {
  std::vector<double> values;
  for (const Json& j : list) values.push_back(number_from(j));
  return values;
}

bearing::Tier tier_from(const Json& j) { return app::tier_named(j.at("tier"), "a child's answer"); }

BarSample bar_from(const Json& j) {
  BarSample s;
  s.subject = j.at("subject");
  s.tier = tier_from(j);
  s.grid = j.at("grid").get<std::array<int, 2>>();
  s.quantity = j.at("quantity");
  s.value = number_from(j.at("value"));
  s.size = number_from(j.at("size"));
  s.error_grid = number_from(j.at("error_grid"));
  s.error_model = number_from(j.at("error_model"));
  s.truth_tier = number_from(j.at("truth_tier"));
  s.truth_limit = number_from(j.at("truth_limit"));
  s.truth_full = number_from(j.at("truth_full"));
  s.given = j.at("given");
  s.richest = j.at("richest");
  s.levels = numbers_from(j.at("levels"));
  s.sizes = numbers_from(j.at("cell_sizes"));
  s.node_change = number_from(j.at("node_change"));
  s.model_change = number_from(j.at("model_change"));
  return s;
}

Json refusal_json(const HonestyRefusal& r) {
  return {{"subject", r.subject},
          {"tier", to_string(r.tier)},
          {"grid", r.grid},
          {"status", r.status},
          {"reason", r.reason}};
}

Json cost_json(const BarCost& c) {
  return {
      {"tier", to_string(c.tier)}, {"grid", c.grid}, {"solve_s", c.solve_s}, {"bars_s", c.bars_s}};
}

}  // namespace

Json bar_json(const BarSample& s) {
  return {{"subject", s.subject},
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

std::string to_text(const HonestySubject& subject) {
  Json j{{"over_budget", subject.end == CaseEnd::over_budget},
         {"samples", Json::array()},
         {"refusals", Json::array()},
         {"costs", Json::array()}};
  for (const BarSample& s : subject.samples) j["samples"].push_back(bar_json(s));
  for (const HonestyRefusal& r : subject.refusals) j["refusals"].push_back(refusal_json(r));
  for (const BarCost& c : subject.costs) j["costs"].push_back(cost_json(c));
  return j.dump(-1, ' ', false, Json::error_handler_t::replace);
}

HonestySubject honesty_subject_from(const std::string& text) {
  const Json j = Json::parse(text);
  HonestySubject subject;
  subject.end = j.at("over_budget").get<bool>() ? CaseEnd::over_budget : CaseEnd::done;
  for (const Json& s : j.at("samples")) subject.samples.push_back(bar_from(s));
  for (const Json& r : j.at("refusals")) {
    subject.refusals.push_back({r.at("subject"), tier_from(r),
                                r.at("grid").get<std::array<int, 2>>(), r.at("status"),
                                r.at("reason")});
  }
  for (const Json& c : j.at("costs")) {
    subject.costs.push_back({tier_from(c), c.at("grid").get<std::array<int, 2>>(),
                             number_from(c.at("solve_s")), number_from(c.at("bars_s"))});
  }
  return subject;
}

}  // namespace shellback::validation
