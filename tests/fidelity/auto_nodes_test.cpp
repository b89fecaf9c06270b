#include <catch2/catch.hpp>
#include <cmath>

#include "fidelity/auto_probe.hpp"
#include "fidelity/quantities.hpp"
#include "fidelity/solve_case.hpp"
#include "tests/bearing/sample_bearing.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;
using namespace bearing::tests;

Solution coarse(int nodes) {
  Case c = grooved_case();
  c.model.grid = {40, 9};
  c.model.film_nodes = nodes;
  return solve_tier(c, Tier::thd);
}

double change(const Solution& from, const Solution& to, const char* name) {
  const double x = value_in(quantities_of(from, Tier::thd), name);
  return std::abs(value_in(quantities_of(to, Tier::thd), name) / x - 1.0);
}

}  // namespace

TEST_CASE("NodesAreAddedUntilTwoMoreChangeLittle") {
  const Solution three = coarse(3);
  const Solution nine = coarse(9);
  REQUIRE(three.verdict.good());
  REQUIRE(nine.verdict.good());
  EquilibriumCost cost;
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    INFO(tolerance);
    Solution probe = three;
    const NodeChoice n = choose_nodes(probe, tolerance, false, {}, cost);
    CHECK(n.known);
    CHECK(n.nodes == probe.model.input.model.film_nodes);
    // Two more change a tenth at most, and the steps shrink: all that is left is within a third.
    CHECK(change(probe, nine, "friction_torque") < 0.33 * tolerance);
    CHECK(change(probe, nine, "h_min") < 0.33 * tolerance);
  }
}

TEST_CASE("WhatTwoMoreNodesChangeIsTold") {
  Solution probe = coarse(3);
  const Solution five = coarse(5);
  EquilibriumCost cost;
  const NodeChoice n = choose_nodes(probe, 1e-9, true, {}, cost);
  CHECK(n.nodes == 3);  // as the case gives
  CHECK(probe.model.input.model.film_nodes == 3);
  const double told = std::abs(value_in(n.left, "friction_torque"));
  const double is = change(probe, five, "friction_torque") * torque_of(probe);
  // Both to the tolerance of the thermal loop, 1e-4 of the temperatures per turn.
  CHECK(told == Approx(std::abs(is)).epsilon(0.05));
  CHECK(told > 1e-3 * std::abs(torque_of(probe)));  // three do not resolve this film
}

TEST_CASE("AutoKeepsTheNodesOfTheCaseAndChoosesItsOwnElse") {
  Case c = grooved_case();
  c.model.tier = Tier::automatic;
  c.model.tolerance = 0.01;
  c.model.film_nodes = 3;
  const Result chosen = solve_case(c);
  REQUIRE(chosen.verdict.good());
  c.model.film_nodes_given = true;
  const Result given = solve_case(c);
  REQUIRE(given.verdict.good());
  c.model.film_nodes = 7;
  const Result rich = solve_case(c);
  REQUIRE(rich.choice);
  CHECK(chosen.value("friction_torque") == Approx(rich.value("friction_torque")).epsilon(0.01));
  // Three nodes are further off, and the bar says so.
  const double off = std::abs(given.value("friction_torque") / rich.value("friction_torque") - 1.0);
  CHECK(off > 1e-3);
  CHECK(given.choice->bar_friction > off);
}

TEST_CASE("WithoutResolvedTemperatureNoNodesAreChosen") {
  Case c = plain_case();
  Solution probe = solve_tier(c, Tier::isothermal);
  EquilibriumCost cost;
  CHECK(choose_nodes(probe, 1e-3, false, {}, cost).nodes == 0);
}

}  // namespace shellback::fidelity
