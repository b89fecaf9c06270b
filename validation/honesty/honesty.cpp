#include "validation/honesty/honesty.hpp"

#include <algorithm>

#include "validation/honesty/child_pool.hpp"
#include "validation/honesty/honesty_trial.hpp"
#include "validation/honesty/honesty_wire.hpp"

namespace shellback::validation {
namespace {

/// Processor time beyond the budget in which a solve on the truth's grid finds out that it is over
/// [s]: an iteration on 800 x 100 cells takes up to a few.
constexpr double kGrace = 15.0;
/// Clock time over processor time: what a case may use does not hang on what else the machine does,
/// only one that sleeps is ended [-].
constexpr double kPatience = 50.0;

HonestySubject subject_of(const ChildEnd& end) {
  HonestySubject s;
  if (end.how == ChildEnd::How::answered) {
    s = honesty_subject_from(end.answer);
  } else if (end.how == ChildEnd::How::timed_out) {
    s.end = CaseEnd::over_budget;
  } else {
    s.end = CaseEnd::failed;
    s.why = end.answer;
  }
  s.processor_s = end.processor_s;
  return s;
}

}  // namespace

HonestyRecord measure_honesty(const std::vector<HonestyCase>& cases,
                              const HonestyOptions& options) {
  const int count = static_cast<int>(cases.size());
  std::vector<HonestySubject> subjects(cases.size());
  int done = 0;
  const bool all = run_in_children(
      count, {options.at_once, options.budget_s, kGrace, kPatience, options.stop},
      [&](int k) { return to_text(try_bars(cases[k].input, k, options, &stop_at_limit())); },
      [&](int k, const ChildEnd& end) {
        subjects[k] = subject_of(end);
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
