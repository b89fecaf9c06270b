/// That shell and housing stay joined is told where heat would part them.
#include <catch2/catch.hpp>

#include "bearing/bearing.hpp"
#include "bearing/told_ranges.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// What is said of the rig's bearing, `rise` above where it was fitted [K].
std::vector<Note> told(Case c, double rise) {
  const double T = c.bearing.reference_temperature + rise;
  const BearingModel model = make_bearing(c, physics_of(c, Tier::tehd), {20, 4});
  std::vector<Note> notes;
  add_joint_that_pulls(model, T, T, notes);
  return notes;
}

}  // namespace

TEST_CASE("AJointThatHeatWouldOpenIsTold", "[joint]") {
  const Case c = rig_case();  // steel shell in aluminium, which grows more
  const auto warm = told(c, 80.0);
  REQUIRE(warm.size() == 1);
  const auto& joint = std::get<note::JointPulls>(warm.front());
  CHECK(joint.pressure > 1e6);
  // Loose it grows as steel and a little lining do, joined more than that and less than aluminium.
  const double steel_alone = 11e-6 * 80.0 * c.bearing.radius;
  CHECK(joint.loose > steel_alone);
  CHECK(joint.loose < joint.joined);
  CHECK(joint.joined < 23e-6 * 80.0 * c.bearing.radius);
  CHECK(told(c, 0.0).empty());    // as it was fitted
  CHECK(told(c, -60.0).empty());  // cold it is pressed
  Case held = c;
  held.shell->housing->support = HousingSupport::clamped;
  CHECK(told(held, 80.0).empty());
  Case alike = c;
  alike.shell->housing->material = steel();
  alike.shell->layers.front().material = steel();
  CHECK(told(alike, 80.0).empty());
}
