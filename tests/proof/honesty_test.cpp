// What counts as an honest bar, and a small selection on which the bars are.
#include "proof/honesty.hpp"

#include <catch2/catch.hpp>

#include "proof/honesty_report.hpp"
#include "proof/population.hpp"

using namespace shellback;
using namespace shellback::coupling;
using namespace shellback::proof;

namespace {

/// A bar of length `bar` on a value that is off by `error`, size 1.
BarSample sample(double bar, double error) {
  BarSample s{0, Tier::thd, {100, 13}, "friction_torque"};
  s.value = 5.0;
  s.size = 1.0;
  s.error_grid = bar;
  s.error_model = NAN;
  s.truth_tier = 5.0 + error;
  s.truth_limit = s.truth_full = NAN;
  return s;
}

}  // namespace

TEST_CASE("ABarHoldsItsTruthOrNot") {
  const std::vector<BarSample> samples{sample(1.0, 0.5), sample(1.0, -2.0), sample(1.0, 0.25),
                                       sample(1.0, 1.0)};
  const Coverage c = coverage_of(samples, BarKind::grid);
  CHECK(c.count == 4);
  CHECK(c.held == Approx(0.75));
  CHECK(c.median == Approx(2.0));  // of 0.5, 1, 2, 4: the upper one of the middle two
}

TEST_CASE("AnInfinitelyLongBarIsNoGoodBar") {
  const Coverage c = coverage_of({sample(INFINITY, 0.5), sample(NAN, 0.5)}, BarKind::grid);
  CHECK(c.count == 0);
  CHECK(c.unknown == 2);
}

TEST_CASE("WhatTheCaseGivesAndWhatIsExactTestsNothing") {
  BarSample given = sample(1.0, 0.5);
  given.given = true;
  CHECK_FALSE(testable(given, BarKind::grid));
  CHECK_FALSE(testable(sample(0.0, 0.0), BarKind::grid));
  CHECK(testable(sample(0.0, 1e-3), BarKind::grid));  // no bar but an error: counted, and missed
}

TEST_CASE("TheTotalBarIsTestedWhereTheModelBarIsKnown") {
  BarSample s = sample(0.1, 0.0);
  s.truth_full = 5.5;
  CHECK_FALSE(testable(s, BarKind::total));
  s.error_model = 0.5;
  REQUIRE(testable(s, BarKind::total));
  CHECK(bar_against_error(s, BarKind::total).bar == Approx(0.6));
  CHECK(bar_against_error(s, BarKind::total).error == Approx(0.5));
  s.error_model = NAN;
  s.richest = true;  // the full physics itself: its grid bar is all
  CHECK(testable(s, BarKind::total));
}

TEST_CASE("BarsOfRandomBearingsHold") {
  // Coarse grids, so that it is quick; the full measurement is `shellback honesty`. Few cases
  // scatter: a whole bearing may be missed at once, hence 80 % here for the 90 % there. The truth,
  // twice as fine, keeps 2^-1.3 = 40 % of the error, so that errors look 1.6 times shorter than
  // they are: 8 here for the 5 there.
  std::vector<HonestyCase> cases;
  for (const int seed : {2, 4, 7, 10, 13, 16}) cases.push_back({random_case(seed), "random"});
  HonestyOptions o;
  o.tiers = {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd};
  o.grids = {{60, 9}};
  o.truth_grid = {120, 17};
  const HonestyRecord record = measure_honesty(cases, o);
  for (const BarKind kind : {BarKind::grid, BarKind::total}) {
    const Coverage c = coverage_of(record.samples, kind);
    CHECK(c.count > 150);
    CHECK(c.held > 0.8);
    CHECK(c.median < 8.0);
  }
  for (const HonestyRefusal& r : record.refusals) CHECK_FALSE(r.reason.empty());
  const std::string svg = honesty_svg(record);
  CHECK(svg.find("bar over true error") != std::string::npos);
  CHECK(honesty_json(record).find("nan") == std::string::npos);
}

TEST_CASE("AStoppedMeasurementKeepsWhatIsFinished") {
  std::atomic<bool> stop{true};
  HonestyOptions o;
  o.tiers = {Tier::isothermal};
  o.grids = {{60, 9}};
  o.stop = &stop;
  const HonestyRecord record = measure_honesty({{random_case(1), "random"}}, o);
  CHECK(record.samples.empty());
  CHECK_FALSE(record.finished.front());
}
