// Bars of load cycles: what a finer grid and shorter steps give lies within them.
#include "fidelity/cycle_bars.hpp"

#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "core/constants.hpp"
#include "fidelity/bar_rules.hpp"
#include "tests/bearing/solved.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Case pulsed() {
  Case c = plain_case();
  c.supplies[0].pressure = 1e5;
  c.supplies[0].arc = 20.0 * kDegree;
  c.supplies[0].length = 0.02;
  LoadCycle cycle;
  cycle.crank_speed = c.operation.omega;
  cycle.period = 4.0 * kPi / c.operation.omega;
  for (int k = 0; k < 144; ++k) {
    const double angle = 4.0 * kPi * k / 144;
    const double from = angle - 2.0 * kPi;
    cycle.t.push_back(angle / c.operation.omega);
    cycle.x.push_back(1e3 * std::cos(angle));
    cycle.y.push_back(1e3 * std::sin(angle) - 6e3 * std::exp(-from * from / 0.2));
  }
  cycle.interpolation = LoadInterpolation::periodic_spline;
  cycle.journal_mass = 0.5;
  c.cycle = cycle;
  c.model.grid = {96, 17};
  return c;
}

}  // namespace

TEST_CASE("BarsOfACycleHoldAFinerGridAndShorterSteps", "[cycle]") {
  Case c = pulsed();
  const CycleResult usual = fidelity::solve_cycle_with_bars(c);
  REQUIRE(usual.verdict.good());
  Case shorter = c;
  shorter.model.tolerance = 1e-3;
  const CycleResult in_time = solve_cycle(shorter, Tier::isothermal);
  c.model.grid = {192, 33};
  const CycleResult finer = solve_cycle(c, Tier::isothermal);
  for (const char* name : {"friction_torque", "h_min", "side_flow"}) {
    INFO(name);
    const CycleQuantity& q = named(usual, name);
    const double grid = named(finer, name).quantity.value - q.quantity.value;
    const double time = named(in_time, name).quantity.value - q.quantity.value;
    REQUIRE(std::isfinite(q.quantity.error_grid));
    REQUIRE(std::isfinite(q.quantity.error_time));
    CHECK(std::abs(grid) <= q.quantity.error_grid + q.quantity.error_time);
    // Means and extremes of one cycle against another are known to 1e-4 (closure).
    CHECK(std::abs(time) <= q.quantity.error_time + 2e-4 * q.quantity.value);
    CHECK(q.quantity.error_grid < 0.2 * q.quantity.value);  // and the bar says something
  }
  // As much oil leaves the periodic film as is fed; the told flows differ by what is gathered.
  const Quantity &side = named(usual, "side_flow").quantity,
                 &supply = named(usual, "supply_flow").quantity;
  CHECK(std::abs(side.value - supply.value) <= std::min(side.error_time, supply.error_time));
}

TEST_CASE("WhatLiesBetweenInstantsIsThatOfAParabola") {
  // A parabola is met exactly, wherever the instants around its vertex lie, in uneven steps, too.
  for (const double vertex : {1.9, 2.0, 2.2, 2.4}) {
    std::vector<CycleInstant> all(4);
    const double t[] = {0.0, 1.0, 2.0, 3.5};
    for (int k = 0; k < 4; ++k) {
      all[k].t = t[k];
      all[k].h_min = 5.0 + 3.0 * (t[k] - vertex) * (t[k] - vertex);
    }
    CHECK(fidelity::beyond_instants(all, &CycleInstant::h_min, 2.0) ==
          Approx(all[2].h_min - 5.0).margin(1e-12));
  }
}

TEST_CASE("WhereCoarserGridsAreLackingAFinerOneTellsTheBars", "[cycle]") {
  Case c = pulsed();
  c.model.grid = {24, 4};  // nothing coarser is worth a solve
  const CycleResult usual = fidelity::solve_cycle_with_bars(c);
  REQUIRE(usual.verdict.good());
  c.model.grid = {96, 17};
  const CycleResult finer = solve_cycle(c, Tier::isothermal);
  REQUIRE(finer.verdict.good());
  for (const char* name : {"friction_torque", "h_min", "side_flow"}) {
    INFO(name);
    const CycleQuantity& q = named(usual, name);
    CHECK(std::abs(named(finer, name).quantity.value - q.quantity.value) <= q.quantity.error_grid);
    CHECK(std::isfinite(q.quantity.error_time));
  }
}

TEST_CASE("BarsOfGivenStepsThatTheLoadsCornersCutHoldShorterOnes", "[cycle]") {
  Case c = pulsed();
  c.model.grid = {60, 9};
  c.cycle->interpolation = LoadInterpolation::linear;  // a corner every five degrees
  c.cycle->step = c.cycle->period;                     // longer than any step can be
  const CycleResult usual = fidelity::solve_cycle_with_bars(c);
  REQUIRE(usual.verdict.good());
  c.cycle->step = c.cycle->period / 720.0;
  const CycleResult shorter = solve_cycle(c, Tier::isothermal);
  for (const char* name : {"friction_torque", "side_flow"}) {
    INFO(name);
    const CycleQuantity& q = named(usual, name);
    const double time = named(shorter, name).quantity.value - q.quantity.value;
    CHECK(q.quantity.error_time > 0.0);
    CHECK(std::abs(time) <= q.quantity.error_time + 2e-4 * q.quantity.value);  // closure, as above
  }
}

TEST_CASE("BarsOfATorqueThatChangesItsSignHoldShorterSteps", "[cycle]") {
  Case c = rig_case();  // rough surfaces, which carry while the journal turns back
  c.model.grid = {60, 9};
  LoadCycle swing;
  swing.period = 1.0;
  for (int k = 0; k < 24; ++k) {
    swing.t.push_back(k / 24.0);
    swing.omega.push_back(20.0 * std::cos(2.0 * kPi * k / 24.0));
  }
  swing.x.assign(24, 0.0);
  swing.y.assign(24, -2.5e3);
  swing.journal_mass = 5.0;
  c.cycle = swing;
  const CycleResult usual = fidelity::solve_cycle_with_bars(c);
  INFO(app::reason_of(usual.verdict));
  REQUIRE(usual.verdict.good());
  c.model.tolerance = 1e-3;
  const CycleResult shorter = solve_cycle(c, Tier::isothermal);
  const CycleQuantity& q = named(usual, "friction_torque");
  REQUIRE(q.quantity.magnitude > 20.0 * std::abs(q.quantity.value));
  const double time = named(shorter, "friction_torque").quantity.value - q.quantity.value;
  CHECK(std::abs(time) <=
        q.quantity.error_time + 2e-4 * q.quantity.magnitude);  // closure, as above
  CHECK(q.quantity.error_time > 1e-6 * q.quantity.magnitude);
  INFO(q.quantity.value << " " << q.quantity.magnitude << " " << q.quantity.error_time << " "
                        << time);
  CHECK(q.quantity.error_time < 0.05 * q.quantity.magnitude);
}

TEST_CASE("ALayerThatThePressuresBarReachesHasNoBarOfItsOwn") {
  // Coarser grids on which it does not flow either made the bar 0 where finer ones have 13 nm.
  Case c = plain_case();
  solid::Material coating;
  coating.hardness = 38e6;
  c.shell = Shell{};
  c.shell->layers = {{coating, 20e-6}};
  c.shell->layers[0].elasto_plastic = true;
  Quantity depth{"layer_depth", 0.0, "m"}, p_max{"p_max", 37e6, "Pa"};
  p_max.error_grid = 2e6;
  CHECK(fidelity::layer_may_have_flowed(c, depth, p_max));
  p_max.error_grid = 0.5e6;
  CHECK_FALSE(fidelity::layer_may_have_flowed(c, depth, p_max));
  p_max.error_grid = 2e6;
  depth.value = 1e-9;  // it has flowed: grids tell how much
  CHECK_FALSE(fidelity::layer_may_have_flowed(c, depth, p_max));
  depth.value = 0.0;
  c.shell->layers[0].elasto_plastic = false;
  CHECK_FALSE(fidelity::layer_may_have_flowed(c, depth, p_max));
}
