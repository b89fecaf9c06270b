/// Supplies that turn with the journal, over load cycles.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/crank.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/drillings.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

constexpr double kPart = 100.0 * kDegree;  // from the load to the hole

/// A hole of 6 mm at 2 bar, in the shell or in the journal.
Supply hole(SupplyKind kind, double angle) {
  Supply s;
  s.kind = kind;
  s.angle = angle;
  s.diameter = 6e-3;
  s.pressure = 2e5;
  s.temperature = 313.15;
  if (kind == SupplyKind::drilling) s.carry_over = 0.0;
  return s;
}

/// A load of 1 kN that turns `turns` times in a period of two turns of the journal, from -Y on.
LoadCycle turning_load(double omega, int turns) {
  constexpr int kRows = 96;
  LoadCycle cycle;
  cycle.period = 4.0 * kPi / std::abs(omega);
  cycle.interpolation = LoadInterpolation::periodic_spline;
  for (int k = 0; k < kRows; ++k) {
    const double angle = -0.5 * kPi + 2.0 * kPi * turns * k / kRows;
    cycle.t.push_back(cycle.period * k / kRows);
    cycle.x.push_back(1e3 * std::cos(angle));
    cycle.y.push_back(1e3 * std::sin(angle));
  }
  return cycle;
}

Case drilled() {
  Case c = plain_case();
  c.model.grid = {96, 18};
  c.supplies = {hole(SupplyKind::drilling, -0.5 * kPi + kPart)};
  c.cycle = turning_load(c.operation.omega, 2);
  return c;
}

double mean(const CycleResult& r, double CycleInstant::*what) {
  double sum = 0.0;
  for (const CycleInstant& i : r.instants) sum += i.dt * i.*what / r.period;
  return sum;
}

}  // namespace

TEST_CASE("ADrillingThatTurnsWithTheLoadIsAHoleOfASteadyBearing", "[drilling]") {
  // Seen from the journal, journal, load and drilling stand still and the shell turns backwards:
  // a steady bearing that turns backwards with a hole in what stands still.
  Case c = drilled();
  c.model.tolerance = 3e-3;
  const CycleResult r = solve_cycle(c, Tier::isothermal);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  Case steady = c;
  steady.cycle.reset();
  steady.operation.omega = -c.operation.omega;
  steady.operation.position = LoadGiven{1e3, 1.5 * kPi};
  steady.supplies = {hole(SupplyKind::hole, -0.5 * kPi + kPart)};
  const Result s = solve(steady);
  REQUIRE(s.verdict.good());
  // Film, gap and mouth wander over the cells of the one: of first order where the film ends, and
  // the hole of the other has faces on its edges.
  CHECK(mean(r, &CycleInstant::h_min) == Approx(s.values().h_min).epsilon(0.02));
  CHECK(mean(r, &CycleInstant::supply_flow) == Approx(s.values().supply_flow).epsilon(0.03));
  CHECK(mean(r, &CycleInstant::p_max) == Approx(s.values().p_max).epsilon(0.03));
  CHECK(r.audit.mass < 1e-12);
}

TEST_CASE("AJournalTurnsByTheIntegralOfItsSpeed", "[drilling]") {
  LoadCycle lines;  // 0 to 3 s, speeds 1, 5, 2 rad/s
  lines.t = {0.0, 1.0, 3.0};
  lines.x = {1.0, 1.0, 1.0};
  lines.y = {0.0, 0.0, 0.0};
  lines.omega = {1.0, 5.0, 2.0};
  const LoadCourse event(lines, 0.0);
  CHECK(event.turned(0.0) == 0.0);
  CHECK(event.turned(0.5) == Approx(1.0));
  CHECK(event.turned(2.0) == Approx(3.0 + 4.25));
  CHECK(event.turned(4.0) == Approx(3.0 + 7.0 + 2.0));
  // The pin against the rod: theta + beta, from trapezoids of half a degree.
  Crank crank;
  crank.stroke = 0.137;
  crank.rod_length = 0.207;
  crank.period = 4.0 * kPi;
  crank.piston_mass = 1.0;
  for (const double omega : {200.0, -200.0}) {
    const LoadCourse pin(crank_load(crank, omega), omega);
    for (const double theta : {0.3, 2.0, 5.0, 11.0}) {
      const double turned = pin.turned(theta / 200.0);
      const double exact = theta + crank_motion(crank, theta, 200.0).rod_angle;
      CHECK(std::copysign(turned, 1.0) == Approx(exact).margin(1e-4));
      CHECK(turned * omega > 0.0);
    }
  }
}

TEST_CASE("HeatOfADrilledBearingIsBalanced", "[drilling]") {
  Case c = warm_case();
  c.model.grid = {48, 9};
  c.model.tolerance = 0.03;  // long steps: a balance does not depend on them
  c.supplies = {hole(SupplyKind::drilling, 0.0)};
  c.supplies[0].diameter = 8e-3;
  c.cycle = turning_load(c.operation.omega, -1);  // the mouth passes through the loaded film
  c.cycle->journal_mass = 0.5;
  const CycleResult r = solve_cycle(c, Tier::thd);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  CHECK(std::abs(r.audit.mass) < 1e-12);
  CHECK(std::abs(r.audit.energy) < 1e-8);
  CHECK(mean(r, &CycleInstant::supply_flow) > 0.0);
}

TEST_CASE("AnEventFedByADrillingDoesNotKnowTheTemperatureOfTierIsothermal", "[drilling]") {
  // It begins with walls at the supply's temperature, and says so.
  Case c = warm_case();
  c.model.grid = {32, 5};
  c.model.tolerance = 0.05;
  c.supplies = {hole(SupplyKind::drilling, 0.0)};
  c.cycle = turning_load(c.operation.omega, 2);
  c.cycle->period = std::numeric_limits<double>::infinity();
  c.cycle->interpolation = LoadInterpolation::linear;
  c.cycle->t.resize(12);
  c.cycle->x.resize(12);
  c.cycle->y.resize(12);
  std::vector<double> torques;
  for (const double T : {313.15, 373.15}) {
    c.oil_temperature = T;
    const CycleResult r = solve_cycle(c, Tier::thd);
    INFO(app::reason_of(r.verdict));
    REQUIRE(r.verdict.good());
    torques.push_back(r.instants.back().torque);
    CHECK(std::any_of(r.assumptions.begin(), r.assumptions.end(), [](const Note& n) {
      const auto* plain = std::get_if<note::Plain>(&n);
      return plain != nullptr && *plain == note::Plain::event_without_heat;
    }));
  }
  CHECK(torques[1] == Approx(torques[0]).epsilon(1e-12));
}

TEST_CASE("ADrillingThatDoesNotComeBackIsRefused", "[drilling]") {
  const auto judged = [](const Case& c) {
    for (const Finding& f : judge(c)) {
      if (f.refused()) return f.problem;
    }
    return std::string();
  };
  Case c = drilled();
  CHECK(judged(c).empty());
  c.operation.omega *= 1.01;
  CHECK(judged(c).find("turns 2.02 times") != std::string::npos);
  c = drilled();
  c.cycle.reset();
  CHECK(judged(c).find("belongs to a load cycle") != std::string::npos);
}

TEST_CASE("ADrillingLivesOnItsVesselWhileItsLineIsShut", "[drilling]") {
  Case c = drilled();
  c.model.grid = {48, 8};
  c.model.tolerance = 0.03;  // long steps: oil is conserved in any
  c.cycle->journal_mass = 0.5;
  c.cycle->period = INFINITY;  // passed once
  c.cycle->interpolation = LoadInterpolation::linear;
  const double length = c.cycle->length();
  for (const double volume : {2e-9, 1e-3}) {  // empty at once; hardly emptied
    c.supplies[0].vessel = Vessel{volume, 1.5e9, {{0.0, 0.3 * length}}};
    const CycleResult r = solve_cycle(c, Tier::isothermal);
    CAPTURE(volume, app::reason_of(r.verdict));
    REQUIRE(r.verdict.good());
    CHECK(r.audit.mass < 1e-10);
    CHECK(value_of(r, "p_vessel_min") >= c.model.cavitation_pressure);
    if (volume < 1e-8) {
      CHECK(value_of(r, "p_vessel_min") == Approx(c.model.cavitation_pressure).margin(1e3));
    } else {
      CHECK(value_of(r, "p_vessel_min") > 0.0);
    }
  }
}
