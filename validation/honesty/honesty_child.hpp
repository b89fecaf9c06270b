#pragma once
/// One case of a study of honesty in a child process: what it may take, and how it ended.
#include "validation/honesty/child_pool.hpp"
#include "validation/honesty/honesty_record.hpp"

namespace shellback::validation {

/// Of `budget_s` processor time a case [s].
[[nodiscard]] inline ChildPoolOptions pool_of_cases(int at_once, double budget_s,
                                                    const std::atomic<bool>* stop) {
  // In this time beyond the budget a solve on the truth's grid finds out that it is over: an
  // iteration on 800 x 100 cells takes up to a few seconds [s].
  constexpr double kGrace = 15.0;
  // Clock time over processor time: what a case may use does not hang on what else the machine
  // does, only one that sleeps is ended [-].
  constexpr double kPatience = 50.0;
  return {at_once, budget_s, kGrace, kPatience, stop};
}

/// What a child has told, as `read` reads it; of one that told nothing how it ended.
template <class Told>
Told told_by(const ChildEnd& end, Told (*read)(const std::string&)) {
  Told told;
  if (end.how == ChildEnd::How::answered) {
    told = read(end.answer);
  } else if (end.how == ChildEnd::How::timed_out) {
    told.end = CaseEnd::over_budget;
  } else {
    told.end = CaseEnd::failed;
    told.why = end.answer;
  }
  told.processor_s = end.processor_s;
  return told;
}

}  // namespace shellback::validation
