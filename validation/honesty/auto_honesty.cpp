#include "validation/honesty/auto_honesty.hpp"

#include <algorithm>

#include "validation/honesty/auto_trial.hpp"
#include "validation/honesty/auto_wire.hpp"
#include "validation/honesty/child_pool.hpp"

namespace shellback::validation {
namespace {

/// Processor time beyond the budget in which a solve on 800 x 100 cells finds out that it is over
/// [s]: an iteration there takes up to a few.
constexpr double kGrace = 15.0;
/// Clock time over processor time: what a case may use does not hang on what else the machine does,
/// only one that sleeps is ended [-].
constexpr double kPatience = 50.0;

AutoTrial trial_of(const ChildEnd& end) {
  AutoTrial t;
  if (end.how == ChildEnd::How::answered) {
    t = auto_trial_from(end.answer);
  } else if (end.how == ChildEnd::How::timed_out) {
    t.end = CaseEnd::over_budget;
  } else {
    t.end = CaseEnd::failed;
    t.why = end.answer;
  }
  t.processor_s = end.processor_s;
  return t;
}

}  // namespace

std::vector<AutoTrial> judge_auto(const AutoStudy& study) {
  std::vector<AutoTrial> trials;
  const bool all = run_in_children(
      study.cases, {study.at_once, study.budget_s, kGrace, kPatience, study.stop},
      [&](int k) {
        return to_text(try_auto(study.first_seed + k, study.tolerances, &stop_at_limit()));
      },
      [&](int k, const ChildEnd& end) {
        trials.push_back(trial_of(end));
        trials.back().seed = study.first_seed + k;
        if (study.told) study.told(static_cast<int>(trials.size()), study.cases);
      });
  static_cast<void>(all);  // a stopped study keeps what is finished
  std::sort(trials.begin(), trials.end(),
            [](const AutoTrial& a, const AutoTrial& b) { return a.seed < b.seed; });
  return trials;
}

}  // namespace shellback::validation
