/// shellback stress: exit codes and streams.
#include <catch2/catch.hpp>

#include "tests/contains.hpp"
#include "tests/program/run_words.hpp"

using namespace shellback;
using namespace shellback::program;
using namespace shellback::program::tests;
using test::contains;

TEST_CASE("StressScenesAreListedWithoutBeingRun") {
  const Ended ended = run_words({"stress", "--list", "speed-reversed"});
  CHECK(ended.code == kDone);
  CHECK(contains(ended.out, "speed-reversed/isothermal"));
  CHECK_FALSE(contains(ended.out, "load-smooth"));
}

TEST_CASE("AMisspeltStressSceneEndsWithTwoAndTheNearestName") {
  const Ended ended = run_words({"stress", "load-smoth"});
  CHECK(ended.code == kBadInput);
  CHECK(contains(ended.err, "did you mean \"load-smooth\"?"));
}

TEST_CASE("AStressTableOnStandardOutputStandsAlone") {
  const Ended ended = run_words(
      {"stress", "eccentricity-isoviscous/isothermal", "--quick", "--only-default", "--csv", "-"});
  CHECK(ended.code == kDone);
  CHECK(ended.out.rfind("scene,tier,method,value,class", 0) == 0);
  CHECK(contains(ended.out, "\"0.999\",\"converged and audited\""));
  CHECK(ended.err.empty());
}
