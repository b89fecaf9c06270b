/// What the reader of case files refuses is refused of a case that a program fills, too: nothing of
/// it may reach a solver.
#include <catch2/catch.hpp>

#include "bearing/crank.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/over_time/course.hpp"
#include "bearing/over_time/running_in.hpp"
#include "bearing/over_time/warm_up.hpp"
#include "core/contract.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// Key of the first refusal of the rig's bearing after `change`; empty if there is none.
template <class Change>
std::string refused_key(Case c, Change change) {
  change(c);
  for (const Finding& f : judge(c)) {
    if (f.refused()) return f.key;
  }
  return "";
}

}  // namespace

TEST_CASE("WhatNobodySetIsRefusedWhereZeroWouldBeAValue") {
  // A shaft without expansion: mean opening +17 um for -5, and nothing was said.
  CHECK(refused_key(rig_case(), [](Case&) {}).empty());
  CHECK(refused_key(rig_case(), [](Case& c) {
          c.shaft->material = {"steel", 50.0, 7850.0, 460.0, 210e9};
        }) == "shaft.material.poisson_ratio");
  CHECK(refused_key(rig_case(), [](Case& c) {
          c.shaft->material = {"steel", 50.0, 7850.0, 460.0, 210e9, 0.3};
        }) == "shaft.material.expansion");
  CHECK(refused_key(rig_case(), [](Case& c) { c.shaft->material.expansion = 0.0; }).empty());
  CHECK(refused_key(rig_case(), [](Case& c) {
          c.surfaces.contact = solid::ContactParameters{0.001, 53.3e9};
        }) == "surfaces.contact.friction");
}

TEST_CASE("AnEventIsSolvedBesideARunningInThatNobodyAskedFor") {
  // `run` of a coating that flows is sent to a single event, and its case says how it would wear.
  Case c = rig_case();
  c.running_in = RunningIn{1e-8, 350e6, 60.0, 0.0, {}, 0.0};
  LoadCycle event;
  event.t = {0.0, 0.01};
  event.x = {0.0, 0.0};
  event.y = {-1000.0, -2000.0};
  CHECK(refused_key(c, [&](Case& x) { x.cycle = event; }).empty());
  c.cycle = event;
  CHECK_THROWS_WITH(expect_running_in(c, Tier::isothermal),
                    Catch::StartsWith("running_in.until: a single event"));
}

TEST_CASE("WornDepthsAreJudgedAsAShape") {
  const auto key = [](Profile p) {
    return refused_key(rig_case(), [&](Case& x) { x.bearing.wear = p; });
  };
  CHECK(key({{0.0}, {0.0}, {1e-6}}).empty());
  CHECK(key({}) == "bearing.wear");
  CHECK(key({{0.0, 1.0}, {0.0}, {1e-6}}) == "bearing.wear");
  CHECK(key({{1.0, 0.0}, {0.0}, {1e-6, 1e-6}}) == "bearing.wear");
  CHECK(key({{0.0}, {0.0}, {kNan}}) == "bearing.wear");
  CHECK(key({{0.0}, {0.0}, {-200e-6}}) == "bearing.wear");
}

TEST_CASE("OpeningsOfTheEdgesHaveADepthAndALength") {
  const auto key = [](EdgeOpening e) {
    return refused_key(rig_case(), [&](Case& x) { x.bearing.edge_relief = e; });
  };
  CHECK(key({5e-6, 4e-3}).empty());
  CHECK(key({-5e-6, 4e-3}) == "bearing.edge_relief.depth");
  CHECK(key({kNan, 4e-3}) == "bearing.edge_relief.depth");
  CHECK(key({}) == "bearing.edge_relief.length");
  CHECK(refused_key(rig_case(), [](Case& x) {
          x.bearing.chamfer = EdgeOpening{1e-4, -1e-3};
        }) == "bearing.chamfer.length");
}

TEST_CASE("ALawWhoseStressFallsIsRefused") {
  const auto key = [](double r, double m) {
    return refused_key(rig_case(), [&](Case& x) { x.oil.shear = rheology::Cross{r, 1e-7, m}; });
  };
  CHECK(key(0.01, 1.2).empty());  // m (1 - sqrt r) < 1 + sqrt r up to m = 1.22
  CHECK(key(0.01, 1.25) == "oil.viscosity.shear");
  CHECK(key(0.01, 2.0) == "oil.viscosity.shear");
}

TEST_CASE("WhatWearsHasNumbers") {
  const auto key = [](auto change) {
    return refused_key(rig_case(), [&](Case& x) {
      x.running_in = RunningIn{};
      x.running_in->wear_coefficient = 1e-8;
      x.running_in->duration = 100.0;
      x.running_in->hardness = 300e6;
      change(*x.running_in);
    });
  };
  CHECK(key([](RunningIn&) {}).empty());
  CHECK(key([](RunningIn& r) { r.limit_pressure = kNan; }) == "running_in.limit_pressure");
  CHECK(key([](RunningIn& r) { r.limit_pressure = -1e6; }) == "running_in.limit_pressure");
  CHECK(key([](RunningIn& r) { r.hardness = kNan; }) == "running_in.hardness");
  CHECK(key([](RunningIn& r) { r.hardness = -600e6; }) == "running_in.hardness");
}

TEST_CASE("RangesOfTheOilHaveTwoEnds") {
  const auto key = [](auto change) {
    return refused_key(rig_case(), [&](Case& x) { change(x.oil.range); });
  };
  CHECK(key([](auto& r) { std::swap(r.T_min, r.T_max); }) == "oil.valid.temperature");
  CHECK(key([](auto& r) { r.T_max = kNan; }) == "oil.valid.temperature");
  CHECK(key([](auto& r) { r.p_max = -1.0; }) == "oil.valid.pressure");
  CHECK(key([](auto& r) { r.rate_max = kNan; }) == "oil.valid.shear_rate");
}

TEST_CASE("MembersOfAnotherKindOfSupplyAreRefused") {
  CHECK(refused_key(hole_case(), [](Case& x) { x.supplies[0].arc = 0.5; }) == "supply.0.arc");
  CHECK(refused_key(hole_case(), [](Case& x) { x.supplies[0].length = kNan; }) ==
        "supply.0.length");
  CHECK(refused_key(warm_case(), [](Case& x) { x.supplies[0].diameter = kNan; }) ==
        "supply.0.diameter");
  CHECK(refused_key(hole_case(),
                    [](Case& x) {  // the rectangle about the circle
                      x.supplies[0].length = x.supplies[0].diameter;
                      x.supplies[0].arc = x.supplies[0].diameter / x.bearing.radius;
                    })
            .empty());
}

TEST_CASE("AnEquivalentTemperatureIsATemperatureOfOil") {
  const auto hot = [](double kappa) {
    return refused_key(rig_case(), [&](Case& x) {
      x.measured.shell_back_temperature = 400.0;
      x.supplies[0].temperature = 313.15;
      x.model.kappa = kappa;
    });
  };
  CHECK(hot(1.0).empty());
  CHECK(hot(5.0) == "model.equivalent_temperature.kappa");
}

TEST_CASE("ASplineWithoutARowAtZeroIsRefused") {
  const auto key = [](double first) {
    return refused_key(rig_case(), [&](Case& x) {
      x.cycle =
          LoadCycle{{first, 0.01, 0.02, 0.03}, {1e3, 2e3, 3e3, 2e3}, {0.0, 1e3, 0.0, -1e3}, {}};
      x.cycle->period = 0.04;
      x.cycle->interpolation = LoadInterpolation::periodic_spline;
    });
  };
  CHECK(key(0.0).empty());
  CHECK(key(0.005) == "load_cycle.file");
}

TEST_CASE("ACrankThatIsNoneIsRefusedByItsKey") {
  const auto key = [](auto change, double omega = 100.0, int n = 72) {
    Crank c;
    c.stroke = 0.08;
    c.rod_length = 0.14;
    c.bore = 0.08;
    c.period = 4.0 * kPi;
    c.angle = {0.0, 1.0, 6.0};
    c.pressure = {60e5, 10e5, 0.0};
    change(c);
    try {
      static_cast<void>(crank_load(c, omega, CrankFrame::rod, n));
    } catch (const InputError& e) {
      return e.where();
    }
    return std::string();
  };
  const auto as_it_is = [](Crank&) {};
  CHECK(key(as_it_is).empty());
  CHECK(key(as_it_is, 0.0) == "operation.speed");
  CHECK(key(as_it_is, 100.0, 0) == "operation.speed");
  CHECK(key([](Crank& c) { c.stroke = -0.08; }) == "crank.stroke");
  CHECK(key([](Crank& c) { c.rod_length = 0.04; }) == "crank.rod_length");
  CHECK(key([](Crank& c) { c.rod_mass = kNan; }) == "crank.rod_mass");
  CHECK(key([](Crank& c) { c.pressure.pop_back(); }) == "crank.pressure");
  CHECK(key([](Crank& c) { c.pressure[1] = kNan; }) == "crank.pressure");
  CHECK(key([](Crank& c) { std::swap(c.angle[1], c.angle[2]); }) == "crank.pressure");
  CHECK(key([](Crank& c) { c.angle[2] = 4.0 * kPi; }) == "crank.pressure");
  CHECK(key([](Crank& c) { c.period = 0.0; }) == "load_cycle.period");
}

TEST_CASE("OptionsOfAWarmUpAreThoseOfAMarch") {
  const auto refused = [](auto change) {
    WarmUpOptions o;
    o.end = 3.0;
    change(o);
    try {
      static_cast<void>(warm_up(warm_case(), Tier::thd, o));
    } catch (const InputError& e) {
      return e.where();
    }
    return std::string();
  };
  WarmUpOptions celsius;
  celsius.T_start = 20.0;  // of a course as well
  CHECK_THROWS_AS(run_course({{warm_case(), 3.0}}, Tier::thd, celsius), InputError);
  CHECK(refused([](WarmUpOptions& o) { o.end = kNan; }) == "WarmUpOptions::end");
  CHECK(refused([](WarmUpOptions& o) { o.end = -1.0; }) == "WarmUpOptions::end");
  CHECK(refused([](WarmUpOptions& o) { o.error = 0.0; }) == "WarmUpOptions::error");
  CHECK(refused([](WarmUpOptions& o) { o.T_start = 20.0; }) == "WarmUpOptions::T_start");
  CHECK(refused([](WarmUpOptions& o) { o.T_start = kNan; }) == "WarmUpOptions::T_start");
  CHECK(refused([](WarmUpOptions& o) { o.steps = {5.0, -3.0, 1.0}; }) == "WarmUpOptions::steps");
  CHECK(refused([](WarmUpOptions& o) { o.steps = {1.0, 1.0}; }) == "WarmUpOptions::steps");
}

TEST_CASE("TheTierThatRunsInIsTheOneAskedFor") {
  Case c = warm_case();
  c.running_in = RunningIn{};
  c.model.tier = Tier::isothermal;  // of the case; what is asked for is another
  CHECK_THROWS_AS(run_in(c, Tier::lumped), InputError);
}

TEST_CASE("ASolutionThatIsNoneIsNoStart") {
  const Case c = plain_case();
  const Solution cold = solve_tier(c, Tier::isothermal);
  const Solution from_none = solve_tier_from(c, Tier::isothermal, Solution{});
  REQUIRE(from_none.verdict.good());
  CHECK(from_none.film.least.h == cold.film.least.h);
}
