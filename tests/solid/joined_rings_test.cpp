#include "solid/joined_rings.hpp"

#include <catch2/catch.hpp>

using namespace shellback::solid;

namespace {

const Material kBronze{"bronze", 50.0, 8800.0, 380.0, 110e9, 0.34, 18e-6};
const Material kAluminium{"aluminium", 160.0, 2700.0, 900.0, 70e9, 0.33, 23e-6};

}  // namespace

TEST_CASE("RingsOfOneMaterialAreOneRing") {
  // However it is cut: it grows by itself, without stress.
  const JoinedRings one = joined_rings(0.025, {{kAluminium, 0.05, 80.0}});
  const JoinedRings three = joined_rings(
      0.025, {{kAluminium, 0.03, 80.0}, {kAluminium, 0.04, 80.0}, {kAluminium, 0.05, 80.0}});
  CHECK(one.opening == Approx(0.025 * 23e-6 * 80.0));
  CHECK(three.opening == Approx(one.opening).epsilon(1e-12));
  for (const double p : three.pressures) CHECK(std::abs(p) < 1.0);  // of 100 MPa that E alpha T is
}

TEST_CASE("AThinRingInAThickOneTakesItsGrowth") {
  // t/R of 1e-4: what is left of the difference is its share of the stiffness.
  const JoinedRings joined =
      joined_rings(0.025, {{kBronze, 0.025 * (1.0 + 1e-4), 80.0}, {kAluminium, 0.2, 80.0}});
  CHECK(joined.opening == Approx(0.025 * 23e-6 * 80.0).epsilon(1e-3));
  // It is held wider by alpha T E t/R of the difference: the joint pulls.
  CHECK(joined.pressures[0] == Approx(-110e9 * 5e-6 * 80.0 * 1e-4).epsilon(2e-3));
}

TEST_CASE("AShrinkFitHasThePressureOfTheTextbook") {
  // Inner ring warmer by 40 K, the same material, radii 20, 30, 45 mm: p = E delta/b x
  // (c2 - b2)(b2 - a2)/(2 b2 (c2 - a2)), delta = b alpha 40 K.
  const double a = 0.02, b = 0.03, c = 0.045;
  const JoinedRings joined = joined_rings(a, {{kAluminium, b, 40.0}, {kAluminium, c, 0.0}});
  const double expected =
      70e9 * 23e-6 * 40.0 * (c * c - b * b) * (b * b - a * a) / (2.0 * b * b * (c * c - a * a));
  CHECK(joined.pressures[0] == Approx(expected).epsilon(1e-10));
}
