#include "app/json_parts.hpp"
#include "validation/honesty/coverage.hpp"
#include "validation/honesty/honesty_report.hpp"
#include "validation/honesty/honesty_wire.hpp"

namespace shellback::validation {
namespace {

using namespace app::json_parts;
using bearing::Tier;

Json coverage_json(const Coverage& c) {
  const ShareInterval missing = wilson(c.no_truth, c.count + c.no_truth);
  return {{"bars", c.count},
          {"held", number(c.held)},
          {"held_95", {c.interval.low, c.interval.high}},
          {"held_95_by_bearing", {c.by_bearing.low, c.by_bearing.high}},
          {"median_ratio", number(c.median)},
          {"without_truth", c.no_truth},
          {"share_without_truth", number(c.share_without_truth())},
          {"share_without_truth_95", {missing.low, missing.high}},
          {"unknown", c.unknown}};
}

/// The three kinds of bars against their truths.
Json coverages_json(const std::vector<BarSample>& samples) {
  return {{"grid_bars", coverage_json(coverage_of(samples, BarKind::grid))},
          {"grid_bars_to_the_limit", coverage_json(coverage_of(samples, BarKind::limit))},
          {"total_bars", coverage_json(coverage_of(samples, BarKind::total))}};
}

Json cases_json(const HonestyRecord& record) {
  Json list = Json::array();
  for (std::size_t k = 0; k < record.subjects.size(); ++k) {
    Json one{{"case", record.subjects[k]},
             {"set", record.sets[k]},
             {"end", to_string(record.ends[k])},
             {"processor_s", record.processor_s[k]}};
    if (!record.whys[k].empty()) one["why"] = record.whys[k];
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace

std::string honesty_json(const HonestyRecord& record) {
  Json json = coverages_json(record.samples);
  for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd}) {
    std::vector<BarSample> some;
    for (const BarSample& s : record.samples) {
      if (s.tier == tier) some.push_back(s);
    }
    if (!some.empty()) json["by_tier"][to_string(tier)] = coverages_json(some);
  }
  json["budget_s"] = record.budget_s;
  json["cases"] = cases_json(record);
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
  for (const BarSample& s : record.samples) {
    Json one{{"case", record.subjects[s.subject]}};
    one.update(bar_json(s));
    json["samples"].push_back(std::move(one));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shellback::validation
