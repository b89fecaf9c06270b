/// A sweep gives what single runs give, whatever the number of threads and the direction.
#include <atomic>
#include <catch2/catch.hpp>

#include "core/contract.hpp"
#include "tests/study/sweeps.hpp"

using namespace shellback;
using namespace shellback::study;
using namespace shellback::study::tests;

namespace {

/// Film and heat stop at a change of 1e-3 K per turn; what is left of the way there is a few times
/// that, so torque (3 % per K) and film agree to this.
constexpr double kThermalTolerance = 1e-3;

}  // namespace

TEST_CASE("EveryPointOfASweepIsThatOfASingleRun") {
  const std::vector<Axis> axes{
      spaced_axis("operation.speed", 4000.0, 500.0, 6, Spacing::logarithmic, "rpm"),
      listed_axis("operation.load", {1.0, 3.0}, "kN")};
  const CaseAt source = plain_source(axes);
  const Sweep sweep = run_sweep(axes, source, {.threads = 2});
  REQUIRE(sweep.points.size() == 12);
  CHECK(sweep.count_good() == 12);
  for (int k = 0; k < 6; ++k) {
    for (int c = 0; c < 2; ++c) {
      const bearing::Result single = bearing::solve(source({static_cast<double>(k), {c}}));
      REQUIRE(single.verdict.good());
      const SweepPoint& point = sweep.at(k, c);
      // Newton's tolerance of 1e-9 on the load, times the condition of the film.
      CHECK(torque(point) == Approx(single.value("friction_torque")).epsilon(1e-7));
      CHECK(point.result.value("h_min") == Approx(single.value("h_min")).epsilon(1e-7));
      CHECK(point.start == (k == 0 ? Start::cold : Start::neighbour));
    }
  }
}

TEST_CASE("AThermalSweepIsThatOfSingleRunsAndCostsLess") {
  const std::vector<Axis> axes{
      spaced_axis("operation.speed", 3000.0, 1000.0, 6, Spacing::logarithmic, "rpm")};
  const CaseAt source = rig_source(axes);
  const Sweep sweep = run_sweep(axes, source);
  REQUIRE(sweep.count_good() == 6);
  int warm = 0;
  int cold = 0;
  for (int k = 0; k < 6; ++k) {
    const bearing::Result single = bearing::solve(source({static_cast<double>(k), {}}));
    REQUIRE(single.verdict.good());
    const SweepPoint& point = sweep.at(k, 0);
    INFO(axes[0].words[k]);
    CHECK(torque(point) == Approx(single.value("friction_torque")).epsilon(kThermalTolerance));
    CHECK(point.result.value("h_min") == Approx(single.value("h_min")).epsilon(kThermalTolerance));
    CHECK(point.result.audit.energy < 1e-4);
    warm += point.result.cost.newton_iterations;
    cold += single.cost.newton_iterations;
  }
  CHECK(warm < cold);
}

TEST_CASE("TheNumberOfThreadsDoesNotMoveTheResultsBeyondTheTolerance") {
  const std::vector<Axis> axes{
      spaced_axis("operation.speed", 3000.0, 600.0, 13, Spacing::logarithmic, "rpm")};
  const CaseAt source = rig_source(axes);
  const Sweep one = run_sweep(axes, source, {.threads = 1});
  const Sweep two = run_sweep(axes, source, {.threads = 2});
  REQUIRE(one.count_good() == 13);
  REQUIRE(two.count_good() == 13);
  int cold = 0;
  for (int k = 0; k < 13; ++k) {
    CHECK(torque(two.at(k, 0)) == Approx(torque(one.at(k, 0))).epsilon(kThermalTolerance));
    if (two.at(k, 0).start == Start::cold) ++cold;
  }
  CHECK(cold == 2);  // the curve was cut, so the comparison is one of different starts
}

TEST_CASE("TheDirectionOfASweepDoesNotMoveItsResultsBeyondTheTolerance") {
  const auto curve = [](double from, double to) {
    return run_sweep(
        {spaced_axis("operation.speed", from, to, 5, Spacing::linear, "rpm")},
        plain_source({spaced_axis("operation.speed", from, to, 5, Spacing::linear, "rpm")}));
  };
  const Sweep down = curve(3000.0, 1000.0);
  const Sweep up = curve(1000.0, 3000.0);
  for (int k = 0; k < 5; ++k) {
    CHECK(torque(down.at(k, 0)) == Approx(torque(up.at(4 - k, 0))).epsilon(1e-7));
  }
}

TEST_CASE("TiersFollowOneAnother") {
  const std::vector<Axis> axes{word_axis("model.tier", {"isothermal", "lumped", "thd", "tehd"})};
  const bearing::Tier tiers[]{bearing::Tier::isothermal, bearing::Tier::lumped, bearing::Tier::thd,
                              bearing::Tier::tehd};
  const CaseAt source = [&](const Position& at) {
    Case c = bearing::tests::rig_case();
    c.model.grid = {60, 9};
    c.model.tier = tiers[static_cast<int>(at.along)];
    return c;
  };
  const Sweep sweep = run_sweep(axes, source);
  REQUIRE(sweep.count_good() == 4);
  for (int k = 0; k < 4; ++k) {
    const bearing::Result single = bearing::solve(source({static_cast<double>(k), {}}));
    CHECK(sweep.at(k, 0).result.tier == tiers[k]);
    CHECK(torque(sweep.at(k, 0)) ==
          Approx(single.value("friction_torque")).epsilon(kThermalTolerance));
  }
}

TEST_CASE("CurvesAreCutOnlyWhereThreadsWouldBeIdle") {
  CHECK(pieces_per_curve(1, 30, 1) == 1);
  CHECK(pieces_per_curve(2, 30, 2) == 1);
  CHECK(pieces_per_curve(1, 30, 2) == 2);
  CHECK(pieces_per_curve(3, 30, 2) == 2);
  CHECK(pieces_per_curve(1, 30, 64) == 5);  // no piece shorter than six points
  CHECK(pieces_per_curve(1, 5, 8) == 1);
  CHECK(pieces_per_curve(100, 30, 8) == 1);
}

TEST_CASE("PointsLieInTheOrderOfTheAxes") {
  const std::vector<Axis> axes{word_axis("a", {"0", "1"}), word_axis("b", {"0", "1", "2"}),
                               word_axis("c", {"0", "1"})};
  int curve = 0;
  for (int b = 0; b < 3; ++b) {
    for (int c = 0; c < 2; ++c) CHECK(across(axes, curve++) == std::vector<int>{b, c});
  }
}
