/// Points that cannot be solved, and what happens around them.
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "core/contract.hpp"
#include "tests/study/sweeps.hpp"

using namespace shellback;
using namespace shellback::study;
using namespace shellback::study::tests;

namespace {

/// The rigid smooth bearing with a fixed oil flow, whose lumped heat balance runs away at high
/// speed: no supply pressure and a narrow line, an oil whose heat capacity is small.
Case hot_case(double rpm) {
  Case c = bearing::tests::plain_case();
  c.model.tier = bearing::Tier::lumped;
  c.oil.heat_capacity = rheology::ConstantHeatCapacity{2.0};  // a thousandth of an oil's
  c.operation.omega = rpm * kPi / 30.0;
  return c;
}

}  // namespace

TEST_CASE("APointWithoutSolutionCarriesItsReasonAndTheOthersAreSolved") {
  // 10 rpm to 6000 rpm: the slow end is cool, the fast end has no steady state.
  const std::vector<Axis> axes{
      spaced_axis("operation.speed", 10.0, 6000.0, 7, Spacing::logarithmic, "rpm")};
  const CaseAt source = [&](const Position& at) {
    return hot_case(std::stod(word_at(axes[0], at.along)));
  };
  const bool slow = bearing::solve(hot_case(10.0)).verdict.good();
  const bool fast = bearing::solve(hot_case(6000.0)).verdict.good();
  REQUIRE(slow);
  REQUIRE_FALSE(fast);
  const Sweep sweep = run_sweep(axes, source);
  CHECK(sweep.at(0, 0).good());
  CHECK_FALSE(sweep.at(6, 0).good());
  CHECK(sweep.count_good() + sweep.count_failed() == 7);
  for (const SweepPoint& point : sweep.points) {
    CHECK(point.tried());
    if (point.good()) {
      CHECK(point.result.verdict.is(ending::Plain::none));
      CHECK_FALSE(point.result.quantities.empty());
    } else {
      CHECK_FALSE(point.result.verdict.is(ending::Plain::none));
      CHECK(point.result.quantities.empty());  // a failed state is no value
      CHECK(point.tries >= 2);                 // from the neighbour and from cold at least
    }
  }
}

TEST_CASE("BadInputAtAnyPointIsRefusedBeforeTheWork") {
  const std::vector<Axis> axes{listed_axis("operation.speed", {1000.0, 2000.0, 3000.0}, "rpm")};
  int solved = 0;
  SweepOptions options;
  options.progress = [&](const SweepProgress&) { ++solved; };
  const CaseAt source = [&](const Position& at) {
    if (at.along == 2.0) throw InputError("--vary operation.speed", "too fast");
    return plain_source(axes)(at);
  };
  CHECK_THROWS_AS(run_sweep(axes, source, options), InputError);
  CHECK(solved == 0);
}

TEST_CASE("AnInterruptKeepsWhatIsFinished") {
  const std::vector<Axis> axes{
      spaced_axis("operation.speed", 4000.0, 500.0, 8, Spacing::logarithmic, "rpm")};
  std::atomic<bool> stop{false};
  SweepOptions options;
  options.stop = &stop;
  options.progress = [&](const SweepProgress& now) {
    if (now.done == 3) stop = true;
  };
  const Sweep sweep = run_sweep(axes, plain_source(axes), options);
  CHECK(sweep.interrupted);
  CHECK(sweep.count_good() == 3);
  CHECK(sweep.count_failed() == 0);
  for (int k = 3; k < 8; ++k) CHECK_FALSE(sweep.at(k, 0).good());
}

TEST_CASE("AKeyOfWholeNumbersHasNoMiddleAndIsSweptAllTheSame") {
  const std::vector<Axis> axes{spaced_axis("model.film_nodes", 3.0, 7.0, 3, Spacing::linear, "")};
  const CaseAt source = [&](const Position& at) {
    const double nodes = std::stod(word_at(axes[0], at.along));
    if (nodes != std::floor(nodes)) throw InputError("model.film_nodes", "not a whole number");
    Case c = bearing::tests::warm_case();
    c.model.film_nodes = static_cast<int>(nodes);
    return c;
  };
  CHECK(run_sweep(axes, source).count_good() == 3);
}

TEST_CASE("ProgressCountsEveryPointOnce") {
  const std::vector<Axis> axes{
      spaced_axis("operation.speed", 4000.0, 500.0, 12, Spacing::logarithmic, "rpm"),
      listed_axis("operation.load", {1.0, 2.0}, "kN")};
  SweepProgress last;
  SweepOptions options;
  options.threads = 4;
  options.progress = [&](const SweepProgress& now) {
    CHECK(now.done >= last.done);
    last = now;
  };
  const Sweep sweep = run_sweep(axes, plain_source(axes), options);
  CHECK(last.total == 24);
  CHECK(last.done == sweep.count_good());
  CHECK(last.failed == sweep.count_failed());
}

TEST_CASE("PointsThatDoNotStartFromColdAreWonFromTheirNeighbours") {
  // Mixed friction at low speed with elastic walls: the slow end is the hard one, and the sweep
  // begins there.
  const std::vector<Axis> up{
      spaced_axis("operation.speed", 60.0, 800.0, 7, Spacing::logarithmic, "rpm")};
  const std::vector<Axis> down{
      spaced_axis("operation.speed", 800.0, 60.0, 7, Spacing::logarithmic, "rpm")};
  const Sweep rising = run_sweep(up, rig_source(up));
  const Sweep falling = run_sweep(down, rig_source(down));
  REQUIRE(rising.count_good() == 7);
  REQUIRE(falling.count_good() == 7);
  for (int k = 0; k < 7; ++k) {
    // The thermal tolerance, as in sweep_test.cpp.
    CHECK(torque(rising.at(k, 0)) == Approx(torque(falling.at(6 - k, 0))).epsilon(1e-3));
  }
}

TEST_CASE("AStepTooLongForOneSolveIsTakenInParts") {
  const std::vector<Axis> axes{listed_axis("operation.speed", {1500.0, 50.0}, "rpm")};
  const std::vector<Axis> fine{
      spaced_axis("operation.speed", 1500.0, 50.0, 16, Spacing::logarithmic, "rpm")};
  const Sweep sweep = run_sweep(axes, rig_source(axes));
  const Sweep steps = run_sweep(fine, rig_source(fine));
  REQUIRE(sweep.count_good() == 2);
  REQUIRE(steps.count_good() == 16);
  CHECK(torque(sweep.at(1, 0)) == Approx(torque(steps.at(15, 0))).epsilon(1e-3));
}

TEST_CASE("TiersWithoutAFilmAreSolvedAloneOrRefused") {
  const std::vector<Axis> axes{
      spaced_axis("operation.speed", 3000.0, 1000.0, 5, Spacing::linear, "rpm")};
  const CaseAt source = [&](const Position& at) {
    Case c = plain_source(axes)(at);
    if (at.along == 2.0) c.model.tier = bearing::Tier::estimate;
    return c;
  };
  CHECK_THROWS_AS(run_sweep(axes, source), InputError);
  SweepOptions options;
  options.solve_alone = [](int, const Case& c, const bearing::SolveControl& control) {
    Case same = c;
    same.model.tier = bearing::Tier::isothermal;
    return bearing::solve(same, control);
  };
  const Sweep sweep = run_sweep(axes, source, options);
  const Sweep usual = run_sweep(axes, plain_source(axes));
  REQUIRE(sweep.count_good() == 5);
  for (int k = 0; k < 5; ++k) {
    CHECK(torque(sweep.at(k, 0)) == Approx(torque(usual.at(k, 0))).epsilon(1e-7));
  }
}

TEST_CASE("PointsThatStandAloneAreSolvedOnAllThreads") {
  // Four points of one axis on two threads: each waits until another one has begun, or for long.
  const std::vector<Axis> axes{
      spaced_axis("operation.speed", 3000.0, 1000.0, 4, Spacing::linear, "rpm")};
  const CaseAt source = [&](const Position& at) {
    Case c = plain_source(axes)(at);
    c.model.tier = bearing::Tier::estimate;
    return c;
  };
  std::atomic<int> inside{0}, most{0};
  SweepOptions options;
  options.threads = 2;
  options.solve_alone = [&](int, const Case& c, const bearing::SolveControl& control) {
    most = std::max<int>(most, ++inside);
    for (int k = 0; k < 2000 && most < 2; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    Case same = c;
    same.model.tier = bearing::Tier::isothermal;
    auto result = bearing::solve(same, control);
    --inside;
    return result;
  };
  CHECK(run_sweep(axes, source, options).count_good() == 4);
  CHECK(most == 2);
}
