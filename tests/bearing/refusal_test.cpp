/// Solves that end without a solution say so, and by name.
#include <catch2/catch.hpp>

#include "bearing/compare.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// A case whose film heats itself without bound: viscosity that rises with temperature, heat that
/// leaves with the oil alone.
Case runaway_case() {
  Case c = warm_case();
  c.oil.temperature = rheology::ReynoldsSlope{0.03, 313.15, -0.05};
  c.operation.omega *= 2.0;
  c.shell->back = ConvectiveBack{1.0, 303.15};
  c.shell->end_heat_transfer = 0.0;
  c.shaft->heat_transfer = 0.0;
  c.model.switches.thermal_deformation = false;  // the shaft would seize first
  return c;
}

bool says(const Verdict& v, const std::string& words) {
  return v.reason.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("ThermalRunawayIsRefusedByName", "[refusal]") {
  for (const Tier tier : {Tier::lumped, Tier::thd, Tier::tehd}) {
    INFO(to_string(tier));
    const Solution s = solve_tier(runaway_case(), tier);
    INFO(s.verdict.reason);
    CHECK(s.verdict.status == Status::no_steady_state);
    CHECK(says(s.verdict, "thermal runaway"));
    CHECK_FALSE(s.verdict.cure.empty());
    const Result r = summarize(s, tier);  // the last state can be looked at
    CHECK(r.verdict.status == Status::no_steady_state);
  }
}

TEST_CASE("RigidBarusLimitIsRefusedWithItsName", "[refusal]") {
  Case c = rig_case();
  c.surfaces = {};
  set_load(c, 80e3);
  const Solution s = solve_tier(c, Tier::isothermal);
  CHECK(s.verdict.status == Status::no_steady_state);
  CHECK(says(s.verdict, "cannot carry 8e+04 N"));
  CHECK(says(s.verdict, "1/alpha"));
  CHECK_FALSE(s.verdict.place.empty());
}

TEST_CASE("SmoothJournalBeyondTheClearanceIsRefused", "[refusal]") {
  Case c = plain_case();
  place_journal(c, 1.02, 0.3);
  const Solution s = solve_tier(c, Tier::isothermal);
  CHECK(s.verdict.status == Status::no_steady_state);
  CHECK(says(s.verdict, "touch"));
}

TEST_CASE("ShrunkenClearanceIsRefused", "[refusal]") {
  Case c = warm_case();  // 100 K above the reference on a shell that cannot grow: 30 um are gone
  c.bearing.reference_temperature = 213.15;
  c.shell->housing->support = HousingSupport::clamped;
  const Solution s = solve_tier(c, Tier::tehd);
  INFO(s.verdict.reason);
  CHECK(s.verdict.status == Status::no_steady_state);
  CHECK(says(s.verdict, "clearance is used up by thermal growth"));
}

TEST_CASE("StopFlagEndsEverySolve", "[refusal]") {
  const std::atomic<bool> stop{true};
  SolveControl control;
  control.stop = &stop;
  for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd}) {
    const Solution s = solve_tier(rig_case(), tier, control);
    CHECK(s.verdict.status == Status::interrupted);
    CHECK(summarize(s, tier).verdict.status == Status::interrupted);
  }
}

TEST_CASE("StopDuringTheThermalLoopKeepsTheState", "[refusal]") {
  for (const Tier tier : {Tier::lumped, Tier::thd, Tier::tehd}) {
    std::atomic<bool> stop{false};
    SolveControl control;
    control.stop = &stop;
    int calls = 0;
    control.progress = [&](const Progress&) { stop = ++calls >= 3; };
    const Solution s = solve_tier(rig_case(), tier, control);
    CHECK(s.verdict.status == Status::interrupted);
    CHECK(calls == 3);
    const Result r = summarize(s, tier);
    CHECK(r.value("friction_torque") > 0.0);
  }
}

TEST_CASE("InterruptedComparisonKeepsWhatIsFinished", "[refusal]") {
  std::atomic<bool> stop{false};
  SolveControl control;
  control.stop = &stop;
  control.progress = [&](const Progress&) { stop = true; };  // the isothermal tier sends none
  const Comparison c = compare(grooved_case(), {Tier::isothermal, Tier::thd, Tier::tehd}, control);
  REQUIRE(c.results.size() == 2);
  CHECK(c.results[0].verdict.good());
  CHECK(c.results[1].verdict.status == Status::interrupted);
  CHECK(c.split.steps.empty());
}

TEST_CASE("SurfacesPressedBeyondTheContactLawAreMarked", "[refusal]") {
  Case c = rig_case();
  c.model.switches.pressure_dependence = false;
  place_journal(c, 1.1, 0.3);  // 2.4 um into each other, where the law ends at 1.3 um
  const auto marked = [](const Result& r) {
    return std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
      return w.find("no longer describes it") != std::string::npos;
    });
  };
  const Result r = summarize(solve_tier(c, Tier::isothermal), Tier::isothermal);
  INFO(r.verdict.reason);
  REQUIRE(r.verdict.good());
  const double sigma = std::hypot(0.28e-6, 0.13e-6), delta = 0.60e-6;  // of the two surfaces
  REQUIRE(r.value("h_min") < delta - 6.3 * sigma);
  CHECK(marked(r));
  CHECK(std::any_of(r.limiters.begin(), r.limiters.end(), [](const LimiterCount& l) {
    return l.what.find("contact law") != std::string::npos && l.count > 0;
  }));
  const Result usual = summarize(solve_tier(rig_case(), Tier::isothermal), Tier::isothermal);
  CHECK_FALSE(marked(usual));
}
