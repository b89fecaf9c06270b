// Tier auto against its truth: what is counted, and what is not judged.
#include "validation/honesty/auto_honesty.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "validation/honesty/auto_report.hpp"
#include "validation/honesty/auto_wire.hpp"

using namespace shellback::validation;

namespace {

AutoAnswer answer(double off, bool holds_truth, bool holds_limit) {
  AutoAnswer a;
  a.tolerance = 0.01;
  a.converged = a.met = true;
  a.friction = 1.0;
  a.seconds = 0.1;
  a.tier = "thd";
  a.off_friction = off;
  a.holds_truth = holds_truth;
  a.holds_limit = holds_limit;
  return a;
}

AutoTrial trial(int seed, bool truth, const AutoAnswer& a) {
  AutoTrial t;
  t.seed = seed;
  t.end = CaseEnd::done;
  t.truth_converged = truth;
  t.truth_seconds = 2.0;
  t.usual_seconds = 0.5;
  t.answers = {a};
  return t;
}

std::vector<AutoTrial> four_trials() {
  std::vector<AutoTrial> trials{trial(1, true, answer(0.005, true, true)),
                                trial(2, true, answer(0.02, true, false)),
                                trial(3, false, answer(0.0, false, false)), AutoTrial{}};
  trials[2].why = "thermal runaway";
  trials[3].seed = 4;
  trials[3].end = CaseEnd::over_budget;  // before its first answer
  return trials;
}

}  // namespace

TEST_CASE("WhatHasNoTruthIsCountedAndNotJudged") {
  const auto summary = summarize(four_trials(), {0.01});
  REQUIRE(summary.size() == 1);
  const AutoSummary& s = summary.front();
  CHECK(s.within.of == 2);
  CHECK(s.within.held == 1);
  CHECK(s.without_truth.held == 1);
  CHECK(s.without_truth.of == 3);
  CHECK(s.no_answer.held == 1);
  CHECK(s.no_answer.of == 4);
  CHECK(s.holds_truth.held == 2);
  CHECK(s.holds_limit.held == 1);
  CHECK(s.holds_limit.interval().high < 1.0);
  CHECK(s.cheaper_truth == Approx(20.0));
}

TEST_CASE("TheTableTellsWhatWasNotJudged") {
  std::ostringstream out;
  AutoStudy study;
  study.tolerances = {0.01};
  write_auto_honesty(out, four_trials(), study);
  CHECK(out.str().find("over the budget") != std::string::npos);
  CHECK(out.str().find("thermal runaway") != std::string::npos);
  CHECK(out.str().find("thd") != std::string::npos);
  const std::string json = auto_honesty_json(four_trials(), study);
  CHECK(json.find("interval_95") != std::string::npos);
  CHECK(json.find("nan") == std::string::npos);
}

TEST_CASE("ATrialPassesBetweenProcessesWhole") {
  AutoTrial t = trial(7, true, answer(0.005, true, false));
  t.answers[0].error_h_min = NAN;
  t.answers[0].chosen = "thd 40x25";
  const AutoTrial back = auto_trial_from(to_text(t));
  CHECK(back.seed == 7);
  CHECK(back.end == CaseEnd::done);
  REQUIRE(back.answers.size() == 1);
  CHECK(std::isnan(back.answers[0].error_h_min));
  CHECK(back.answers[0].chosen == "thd 40x25");
  CHECK(back.answers[0].holds_truth);
  CHECK_FALSE(back.answers[0].holds_limit);
}

TEST_CASE("AStudyEndsWithItsBudgets") {
  AutoStudy study;
  study.first_seed = 2;
  study.cases = 1;
  study.budget_s = 1.0;
  study.tolerances = {0.1};
  const auto trials = judge_auto(study);
  REQUIRE(trials.size() == 1);
  CHECK(trials[0].seed == 2);
  CHECK(trials[0].end == CaseEnd::over_budget);
  CHECK_FALSE(trials[0].truth_converged);
  CHECK(trials[0].processor_s < 20.0);
}
