#include "validation/honesty/honesty.hpp"

#include <algorithm>

#include "validation/honesty/honesty_child.hpp"
#include "validation/honesty/honesty_trial.hpp"
#include "validation/honesty/honesty_wire.hpp"

namespace shellback::validation {

HonestyRecord measure_honesty(const std::vector<HonestyCase>& cases,
                              const HonestyOptions& options) {
  const int count = static_cast<int>(cases.size());
  std::vector<HonestySubject> subjects(cases.size());
  int done = 0;
  const bool all = run_in_children(
      count, pool_of_cases(options.at_once, options.budget_s, options.stop),
      [&](int k) { return to_text(try_bars(cases[k].input, k, options, &stop_at_limit())); },
      [&](int k, const ChildEnd& end) {
        subjects[k] = told_by(end, honesty_subject_from);
        if (options.progress) options.progress(++done, count);
      });
  static_cast<void>(all);  // what was stopped says so itself
  HonestyRecord out;
  out.budget_s = options.budget_s;
  const auto take = [](auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
  for (int k = 0; k < count; ++k) {
    out.subjects.push_back(cases[k].input.title);
    out.sets.push_back(cases[k].set);
    out.ends.push_back(subjects[k].end);
    out.whys.push_back(subjects[k].why);
    out.processor_s.push_back(subjects[k].processor_s);
    take(subjects[k].samples, out.samples);
    take(subjects[k].refusals, out.refusals);
    take(subjects[k].costs, out.costs);
  }
  return out;
}

}  // namespace shellback::validation
