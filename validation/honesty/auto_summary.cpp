#include <algorithm>
#include <cmath>

#include "app/json_parts.hpp"
#include "validation/honesty/auto_report.hpp"
#include "validation/honesty/auto_wire.hpp"

namespace shellback::validation {
namespace {

using namespace app::json_parts;

double median(std::vector<double> x) {
  if (x.empty()) return NAN;
  std::nth_element(x.begin(), x.begin() + static_cast<long>(x.size() / 2), x.end());
  return x[x.size() / 2];
}

void add(bool holds, Share& share) {
  share.held += holds;
  ++share.of;
}

/// Costs of the answers with a truth, summed and one by one.
struct Costs {
  double ours = 0.0;
  double truth = 0.0;
  double usual = 0.0;
  double tamed = 0.0;  ///< sum of shares: no sum that one hard case rules
  std::vector<double> seconds, to_usual, to_truth;

  void add(const AutoTrial& t, const AutoAnswer& a) {
    ours += a.seconds;
    truth += t.truth_seconds;
    usual += t.usual_seconds;
    tamed += a.seconds / t.truth_seconds;
    seconds.push_back(a.seconds);
    to_usual.push_back(t.usual_seconds / a.seconds);
    to_truth.push_back(t.truth_seconds / a.seconds);
  }
  void put(AutoSummary& s) const {
    const auto n = static_cast<double>(seconds.size());
    s.mean_seconds = ours / n;
    s.cheaper_usual = usual / ours;
    s.cheaper_truth = truth / ours;
    s.mean_tamed = n / tamed;
    s.median_seconds = median(seconds);
    s.median_usual = median(to_usual);
    s.median_truth = median(to_truth);
  }
};

AutoSummary summary_of(const std::vector<AutoTrial>& trials, double tolerance) {
  AutoSummary s;
  s.tolerance = tolerance;
  Costs costs;
  for (const AutoTrial& t : trials) {
    const auto found = std::find_if(t.answers.begin(), t.answers.end(),
                                    [&](const AutoAnswer& a) { return a.tolerance == tolerance; });
    const bool answered = found != t.answers.end() && found->converged;
    add(!answered, s.no_answer);
    if (!answered) continue;
    const AutoAnswer& a = *found;
    add(!t.truth_converged, s.without_truth);
    if (!t.truth_converged) continue;
    add(a.within(), s.within);
    add(a.met, s.met);
    if (a.met) add(a.within(), s.met_within);
    add(a.holds_truth, s.holds_truth);
    add(a.holds_limit, s.holds_limit);
    costs.add(t, a);
  }
  costs.put(s);
  return s;
}

Json share_json(const Share& s) {
  const ShareInterval i = s.interval();
  return {{"held", s.held},
          {"of", s.of},
          {"share", number(s.value())},
          {"interval_95", {i.low, i.high}}};
}

}  // namespace

double Share::value() const { return of > 0 ? static_cast<double>(held) / of : NAN; }

std::vector<AutoSummary> summarize(const std::vector<AutoTrial>& trials,
                                   const std::vector<double>& tolerances) {
  std::vector<AutoSummary> list;
  for (const double tolerance : tolerances) list.push_back(summary_of(trials, tolerance));
  return list;
}

std::string auto_honesty_json(const std::vector<AutoTrial>& trials, const AutoStudy& study) {
  const bool complete = static_cast<int>(trials.size()) == study.cases;
  Json all{{"budget_s", study.budget_s},
           {"complete", complete},
           {"summary", Json::array()},
           {"trials", Json::array()}};
  for (const AutoSummary& s : summarize(trials, study.tolerances)) {
    all["summary"].push_back({{"tolerance", s.tolerance},
                              {"without_truth", share_json(s.without_truth)},
                              {"no_answer", share_json(s.no_answer)},
                              {"within", share_json(s.within)},
                              {"met", share_json(s.met)},
                              {"met_within", share_json(s.met_within)},
                              {"holds_truth", share_json(s.holds_truth)},
                              {"holds_limit", share_json(s.holds_limit)},
                              {"mean_s", number(s.mean_seconds)},
                              {"median_s", number(s.median_seconds)},
                              {"truth_over_auto", number(s.cheaper_truth)},
                              {"usual_over_auto", number(s.cheaper_usual)}});
  }
  for (const AutoTrial& t : trials) all["trials"].push_back(trial_json(t));
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shellback::validation
