#include "validation/honesty/auto_honesty.hpp"

#include <algorithm>

#include "validation/honesty/auto_trial.hpp"
#include "validation/honesty/auto_wire.hpp"
#include "validation/honesty/honesty_child.hpp"

namespace shellback::validation {

std::vector<AutoTrial> judge_auto(const AutoStudy& study) {
  std::vector<AutoTrial> trials;
  const bool all = run_in_children(
      study.cases, pool_of_cases(study.at_once, study.budget_s, study.stop),
      [&](int k) {
        return to_text(try_auto(study.first_seed + k, study.tolerances, &stop_at_limit()));
      },
      [&](int k, const ChildEnd& end) {
        trials.push_back(told_by(end, auto_trial_from));
        trials.back().seed = study.first_seed + k;
        if (study.told) study.told(static_cast<int>(trials.size()), study.cases);
      });
  static_cast<void>(all);  // a stopped study keeps what is finished
  std::sort(trials.begin(), trials.end(),
            [](const AutoTrial& a, const AutoTrial& b) { return a.seed < b.seed; });
  return trials;
}

}  // namespace shellback::validation
