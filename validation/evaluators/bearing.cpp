#include <fmt/format.h>

#include <cmath>

#include "app/reading/read_case.hpp"
#include "app/words/ending_words.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/steady/solve.hpp"
#include "core/contract.hpp"
#include "validation/evaluators/bearing_numbers.hpp"
#include "validation/evaluators/evaluators.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::validation {
namespace {

using bearing::Case;
using bearing::Solution;

/// Case of one bearing with the row's numbers and the changes put in.
Case case_of(const Question& q, const BearingPart& part) {
  std::vector<app::Override> overrides;
  for (const Vary& vary : q.entry.vary) {
    if (!vary.bearing.empty() && vary.bearing != part.name) continue;
    const double number = vary.factor * q.number(vary.column);
    overrides.push_back(
        {vary.key, fmt::format("{:.15g}{}{}", number, vary.unit.empty() ? "" : " ", vary.unit),
         fmt::format("{}/entry.toml: {}", q.entry.folder, vary.key)});
  }
  const auto changed = q.changes.find(part.name);
  if (changed != q.changes.end()) {
    overrides.insert(overrides.end(), changed->second.begin(), changed->second.end());
  }
  return with_rivals(app::read_case(part.file, overrides));
}

/// Adds the quantities of one bearing: the first one's as they are, torques and powers of all.
void add_bearing(const std::vector<bearing::Quantity>& quantities, const BearingPart& part,
                 bool first, Values& values) {
  for (const bearing::Quantity& quantity : quantities) {
    for (const char* summed : {"friction_torque", "friction_torque_asperity"}) {
      if (quantity.name != summed) continue;
      const std::string total = fmt::format("total_{}", summed);
      values.value[total] += part.times * quantity.value;
      values.value[total + "." + part.name] = part.times * quantity.value;
    }
    values.value[quantity.name + "." + part.name] = quantity.value;
    if (first) values.value[quantity.name] = quantity.value;
  }
}

/// One bearing, steady or over its cycle; its verdict.
Verdict solve_bearing(const Question& q, const BearingPart& part, bool first, Values& values) {
  const Case c = case_of(q, part);
  if (c.cycle) {
    const bearing::CycleResult r = bearing::solve_cycle(c, c.model.tier, q.control);
    if (r.verdict.good()) add_bearing(bearing::as_result(r).quantities, part, first, values);
    return r.verdict;
  }
  const Solution s = bearing::solve_tier(c, c.model.tier, q.control);
  if (!s.verdict.good()) return s.verdict;
  add_bearing(bearing::quantities_of(s, c.model.tier), part, first, values);
  if (first) add_bearing_numbers(s, values.value);
  return s.verdict;
}

}  // namespace

Values bearing_values(const Question& q) {
  Values values;
  if (q.entry.bearings.empty()) {
    throw InputError(q.entry.folder + "/entry.toml",
                     "the evaluator \"bearings\" needs at least one [[bearing]] with a case file");
  }
  for (const BearingPart& part : q.entry.bearings) {
    const bool first = &part == &q.entry.bearings.front();
    const Verdict verdict = solve_bearing(q, part, first, values);
    values.interrupted = verdict.status == Status::interrupted;
    if (verdict.good()) continue;
    const std::string why = app::reason_of(verdict);
    values.failure = fmt::format("{}: {}{}{}", part.name, to_string(verdict.status),
                                 why.empty() ? "" : ": ", why);
    values.value.clear();
    return values;
  }
  return values;
}

}  // namespace shellback::validation
