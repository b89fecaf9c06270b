// Children that end badly are told apart, and none takes the others along.
#include "validation/honesty/child_pool.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "validation/stress/stress_cell.hpp"

using namespace shellback;
using namespace shellback::validation;

namespace {

using How = ChildEnd::How;

/// The work of child k: each ends in its own way.
std::string work(int k) {
  switch (k) {
    case 0:
      return "42";
    case 1:
      std::raise(SIGSEGV);
      return "";
    case 2:
      throw std::runtime_error("no answer");
    case 3:
      _Exit(7);
    case 4:
      for (volatile double x = 0.0;;) x = x + 1.0;
    case 5:
      return std::string(300000, 'x');  // more than a pipe holds
    default:
      std::abort();
  }
}

std::map<int, ChildEnd> ends_of(int count, int at_once) {
  std::map<int, ChildEnd> ends;
  const bool all = run_in_children(count, {at_once, 1.0}, work,
                                   [&](int k, const ChildEnd& end) { ends[k] = end; });
  CHECK(all);
  return ends;
}

ChildEnd answered(const StressAnswer& a) { return {How::answered, to_text(a), 0.1}; }

}  // namespace

TEST_CASE("CrashHangExceptionAndAnswerAreToldApart") {
  auto ends = ends_of(7, 3);
  REQUIRE(ends.size() == 7);
  CHECK(ends[0].how == How::answered);
  CHECK(ends[0].answer == "42");
  CHECK(ends[1].how == How::crashed);
  CHECK(ends[2].how == How::threw);
  CHECK(ends[2].answer == "no answer");
  CHECK(ends[3].how == How::crashed);
  CHECK(ends[4].how == How::timed_out);
  CHECK(ends[5].how == How::answered);
  CHECK(ends[5].answer.size() == 300000);
  CHECK(ends[6].how == How::crashed);
}

TEST_CASE("AtItsLimitAChildMayGiveTheAnswerThatItHas") {
  ChildEnd end;
  const auto waits_long = [](int) {
    const std::atomic<bool>& stop = stop_at_limit();
    for (volatile double x = 0.0; !stop.load();) x = x + 1.0;
    return std::string("half an answer");
  };
  CHECK(run_in_children(1, {1, 1.0, 5.0}, waits_long, [&](int, const ChildEnd& e) { end = e; }));
  CHECK(end.how == How::answered);
  CHECK(end.answer == "half an answer");
  CHECK(end.processor_s >= 0.5);  // the clock of the limit and this one differ by a tenth and more
  CHECK(end.processor_s < 5.0);
  // One that takes no notice is ended when the grace is over.
  const auto deaf = [](int) {
    static_cast<void>(stop_at_limit());
    for (volatile double x = 0.0;;) x = x + 1.0;
    return std::string();
  };
  CHECK(run_in_children(1, {1, 1.0, 1.0}, deaf, [&](int, const ChildEnd& e) { end = e; }));
  CHECK(end.how == How::timed_out);
}

TEST_CASE("StoppedWorkEndsItsChildren") {
  std::atomic<bool> stop{true};
  int finished = 0;
  CHECK_FALSE(run_in_children(3, {2, 100.0, 1.0, 4.0, &stop}, work,
                              [&](int, const ChildEnd&) { ++finished; }));
  CHECK(finished == 0);
}

TEST_CASE("EachEndOfAChildHasItsClass") {
  CHECK(judge_end({How::crashed, "Segmentation fault", 0.1}).result == StressClass::crashed);
  CHECK(judge_end({How::threw, "why", 0.1}).result == StressClass::crashed);
  CHECK(judge_end({How::timed_out, "", 9.0}).result == StressClass::timed_out);
  CHECK(judge_end({How::answered, "no JSON", 0.1}).result == StressClass::crashed);
  StressAnswer a;
  a.status = "converged";
  CHECK(judge_end(answered(a)).result == StressClass::converged);
  a.faults = {"mass audit 1e-3"};
  CHECK(judge_end(answered(a)).result == StressClass::wrong);
  a.not_a_number = true;
  CHECK(judge_end(answered(a)).result == StressClass::not_a_number);
  a = {};
  a.status = "no steady state";
  CHECK(judge_end(answered(a)).result == StressClass::no_steady_state);
  a.status = "iteration limit";
  CHECK(judge_end(answered(a)).result == StressClass::not_found);
  a.status = "invalid number";
  CHECK(judge_end(answered(a)).result == StressClass::not_a_number);
  a.status = "refused input";
  CHECK(judge_end(answered(a)).result == StressClass::refused_input);
  for (const auto c : {StressClass::converged, StressClass::no_steady_state,
                       StressClass::refused_input, StressClass::not_found}) {
    CHECK_FALSE(is_fault(c));
  }
  for (const auto c : {StressClass::wrong, StressClass::wrong_refusal, StressClass::not_a_number,
                       StressClass::crashed, StressClass::timed_out}) {
    CHECK(is_fault(c));
  }
}
