#include "fidelity/rectangular_holes.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "fidelity/quantities.hpp"
#include "tests/coupling/sample_bearing.hpp"

namespace shellback::fidelity {
namespace {

using namespace coupling;
using namespace coupling::tests;

std::vector<Quantity> solved(Case c) {
  c.model.grid = {400, 51};
  const Solution s = solve_tier(c, Tier::isothermal);
  REQUIRE(s.verdict.good());
  return quantities_of(s, Tier::isothermal);
}

}  // namespace

TEST_CASE("ARectangleFeedsTheFilmAsItsHoleDoes") {
  for (const double pressure : {0.0, 3e5}) {  // the oil is dragged along, or pressed in
    INFO(pressure);
    Case c = plain_case();
    Supply hole;
    hole.angle = 90.0 * kDegree;
    hole.diameter = 6e-3;
    hole.pressure = pressure;
    hole.temperature = 313.15;
    c.supplies = {hole};
    const auto round = solved(c);
    const auto rectangle = solved(with_rectangular_holes(c));
    // The circle's cells leave 2 % of its flow open; a square of half the area is off by a third.
    CHECK(value_in(rectangle, "side_flow") == Approx(value_in(round, "side_flow")).epsilon(0.03));
    CHECK(value_in(rectangle, "h_min") == Approx(value_in(round, "h_min")).epsilon(4e-3));
    CHECK(value_in(rectangle, "friction_torque") ==
          Approx(value_in(round, "friction_torque")).epsilon(4e-3));
  }
}

TEST_CASE("TheShapeOfHolesHasItsBar") {
  CHECK(hole_bar(grooved_case(), "h_min") == 0.0);
  CHECK(hole_bar(rig_case(), "h_min") > 0.0);
  CHECK(hole_bar(rig_case(), "side_flow") > hole_bar(rig_case(), "h_min"));
  CHECK(hole_bar(rig_case(), "eccentricity_ratio") == 0.0);
}

TEST_CASE("GroovesAndLinesStayAsTheyAre") {
  const Case c = grooved_case();
  const Case same = with_rectangular_holes(c);
  CHECK(same.supplies[0].kind == c.supplies[0].kind);
  CHECK(same.supplies[0].arc == c.supplies[0].arc);
  CHECK(same.supplies[0].length == c.supplies[0].length);
}

}  // namespace shellback::fidelity
