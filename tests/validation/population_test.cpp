// Random bearings: the same everywhere, within what is claimed, covering it.
#include "validation/honesty/population.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "bearing/bearing.hpp"
#include "core/constants.hpp"
#include "validation/draw.hpp"

using namespace shellback;
using namespace shellback::bearing;
using validation::Draw;
using validation::random_case;

TEST_CASE("DrawsFollowTheSequenceOfTheStandard") {
  // ISO C++, [rand.predef]: the 10000th number of a default mt19937_64 (seed 5489).
  Draw d(5489);
  for (int k = 1; k < 10000; ++k) static_cast<void>(d.unit());
  CHECK(d.unit() == static_cast<double>(9981545732273789042ULL >> 11U) * 0x1.0p-53);
}

TEST_CASE("TheSameSeedGivesTheSameBearing") {
  const Case a = random_case(17);
  const Case b = random_case(17);
  CHECK(a.bearing.radius == b.bearing.radius);
  CHECK(a.operation.omega == b.operation.omega);
  CHECK(a.shell == b.shell);
  CHECK(random_case(18).bearing.radius != a.bearing.radius);
}

TEST_CASE("RandomBearingsKeepToTheClaimedSpace") {
  for (int seed = 1; seed <= 500; ++seed) {
    INFO("seed " << seed);
    const Case c = random_case(seed);
    const Bearing& b = c.bearing;
    const double D = 2.0 * b.radius;
    REQUIRE((D >= 0.02 && D <= 0.2));
    REQUIRE((b.width >= 0.2 * D && b.width <= 1.2 * D));
    REQUIRE((b.radial_clearance >= 0.5e-3 * b.radius && b.radial_clearance <= 3e-3 * b.radius));
    const double rpm = std::abs(c.operation.omega) * 30.0 / kPi;
    REQUIRE((rpm > 49.9 && rpm < 10001.0));
    REQUIRE(std::abs(c.operation.omega) * b.radius < 60.1);
    if (const auto* load = std::get_if<LoadGiven>(&c.operation.position)) {
      const double specific = load->force / (D * b.width);
      REQUIRE((specific >= 0.05e6 && specific <= 60.1e6));
    }
    for (const Supply& s : c.supplies) {
      REQUIRE(std::abs(s.z) + 0.5 * s.length < 0.5 * b.width);
      REQUIRE((s.pressure >= 0.2e5 && s.pressure <= 6e5));
    }
    REQUIRE((c.shell && c.shaft));
  }
}

TEST_CASE("RandomBearingsAreOfEveryKind") {
  std::set<SupplyKind> supplies;
  int tilted = 0;
  int rough = 0;
  int backwards = 0;
  int two = 0;
  std::set<int> support;
  for (int seed = 1; seed <= 500; ++seed) {
    const Case c = random_case(seed);
    for (const Supply& s : c.supplies) supplies.insert(s.kind);
    const auto* tilt = std::get_if<TiltGiven>(&c.operation.alignment);
    tilted += tilt == nullptr || tilt->about_x != 0.0;
    rough += c.surfaces.shell.roughness > 0.0;
    backwards += c.operation.omega < 0.0;
    two += c.supplies.size() == 2;
    support.insert(c.shell->housing ? static_cast<int>(c.shell->housing->support) : -1);
  }
  CHECK(supplies.size() == 3);
  CHECK(support.size() == 4);
  // Of 500: a fifth, a half, a tenth, a quarter; four standard deviations either way.
  CHECK((tilted > 64 && tilted < 136));
  CHECK((rough > 205 && rough < 295));
  CHECK((backwards > 23 && backwards < 77));
  CHECK((two > 80 && two < 160));
}

TEST_CASE("EveryRandomBearingFitsOnTheUsualGrid") {
  for (int seed = 1; seed <= 100; ++seed) {
    const Case c = random_case(seed);
    INFO("seed " << seed);
    CHECK_NOTHROW(make_bearing(c, physics_of(c, Tier::isothermal), {200, 25}));
  }
}
