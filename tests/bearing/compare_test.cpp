/// Isothermal film at an equivalent temperature against the full solution.
#include "bearing/steady/compare.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "bearing/friction_split.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

double sum_of_steps(const FrictionSplit& split) {
  double sum = 0.0;
  for (const FrictionStep& step : split.steps) sum += step.change;
  return sum;
}

}  // namespace

TEST_CASE("EquivalentTemperatureFollowsItsRule", "[compare]") {
  Case c = warm_case();
  CHECK(equivalent_temperature(c) == 313.15);  // that of the oil
  c.oil_temperature.reset();
  CHECK(equivalent_temperature(c) == c.supplies[0].temperature);
  c.supplies[0].temperature = 320.0;
  c.shell->back = PrescribedBack{350.0};
  CHECK(equivalent_temperature(c) == Approx(350.0).epsilon(1e-15));  // kappa = 1: the shell back
  c.measured.shell_back_temperature = 360.0;                         // measured goes before imposed
  for (const double kappa : {0.0, 0.4, 1.0, 1.3}) {
    c.model.kappa = kappa;
    CHECK(equivalent_temperature(c) == Approx(320.0 + kappa * 40.0).epsilon(1e-15));
  }
  c.oil_temperature = 300.0;  // the measured shell back decides
  CHECK(equivalent_temperature(c) == Approx(320.0 + 1.3 * 40.0).epsilon(1e-15));
  CHECK(solve_tier(c, Tier::isothermal).T_film == equivalent_temperature(c));
}

TEST_CASE("FrictionStepsAddUpToTheDifference", "[compare]") {
  for (const Case& c : {warm_case(), rig_case(), grooved_case()}) {
    for (const Tier tier : {Tier::thd, Tier::tehd}) {
      INFO(c.title << ' ' << to_string(tier));
      const Comparison both = compare(c, {Tier::isothermal, tier});
      REQUIRE(both.results.size() == 2);
      REQUIRE(both.split.steps.size() == 5);
      const double difference = both.split.to - both.split.from;
      CHECK(std::abs(sum_of_steps(both.split) - difference) < 1e-14 * both.split.to);
      CHECK(both.split.from == both.results[0].value("friction_torque"));
      CHECK(both.split.to == both.results[1].value("friction_torque"));
    }
  }
}

TEST_CASE("RigidColdComparisonBlamesTemperatureAlone", "[compare]") {
  Case c = grooved_case();
  for (const AcrossFilm across : {AcrossFilm::lobatto, AcrossFilm::layers, AcrossFilm::mean}) {
    c.model.methods.across = across;
    const Comparison both = compare(c, {Tier::isothermal, Tier::thd});
    REQUIRE(both.split.steps.size() == 5);
    CHECK(both.split.steps[2].change == 0.0);  // clearance: tier thd has no thermal deformation
    // elasticity: only what is left of the fixed point, 1e-3 K at beta = 0.034 1/K
    CHECK(std::abs(both.split.steps[3].change) < 1e-4 * both.split.to);
    CHECK(both.split.steps[4].change == 0.0);  // no asperities
  }
}

TEST_CASE("CalibratedTemperatureReproducesTheFullTorque", "[compare]") {
  for (const Case& c : {warm_case(), rig_case(), grooved_case()}) {
    const Comparison both = compare(c, {Tier::isothermal, Tier::tehd});
    INFO(c.title << " at " << both.calibration.T << " K");
    REQUIRE(std::isfinite(both.calibration.T));
    const double torque = torque_of(solve_isothermal_at(c, both.calibration.T));
    CHECK(torque == Approx(both.split.to).epsilon(1e-4));
  }
}

TEST_CASE("AnEquivalentTemperatureIsFoundWhicheverWayFrictionGoes", "[compare]") {
  const auto found = [](const std::function<double(double)>& excess) {
    return calibrate(excess, 0.0, 353.15, {0.0, 1e-6}).T;
  };
  // A full film rubs less in warmer oil, summits more.
  for (const double slope : {-1.0, 1.0}) {
    for (const double root : {330.15, 350.15, 353.15, 380.15}) {
      CHECK(found([=](double T) { return slope * (T - root); }) == Approx(root).epsilon(1e-8));
    }
    CHECK(std::isnan(found([=](double T) { return slope * (T - 400.0); })));  // out of reach
  }
  // Between both, at the least friction of all, none may be small enough.
  CHECK(std::isnan(found([](double T) { return 1.0 + std::pow(T - 360.0, 2); })));
}

TEST_CASE("AnEquivalentTemperatureDoesNotHangOnTheSenseOfRotation", "[compare]") {
  // Least friction at 360 K, the same on either side of it: the root is that of the guess's side,
  // the film's from the cold, in the mirror, too.
  const auto torque = [](double T) { return 1.0 + std::pow((T - 360.0) / 20.0, 2); };
  for (const double guess : {330.0, 350.0, 358.0, 362.0, 390.0}) {
    const double forth = calibrate(torque, 1.5, guess, {0.0, 1e-9}).T;
    const double back = calibrate([&](double T) { return -torque(T); }, -1.5, guess, {0.0, 1e-9}).T;
    INFO(guess);
    REQUIRE(std::isfinite(forth));
    CHECK(back == forth);
  }
}

TEST_CASE("WhereNoTemperatureHasTheFrictionWhatWasSeenIsKept", "[compare]") {
  const double guess = 353.15, reach = kCalibrationReach;
  const auto falling = [=](double T) { return 1.0 - 0.01 * (T - guess); };
  const Calibration out_of_reach = calibrate(falling, 2.0, guess, {0.0, 1e-6});
  CHECK_FALSE(out_of_reach.found());
  CHECK(out_of_reach.coldest == Approx(guess - reach));
  CHECK(out_of_reach.warmest == Approx(guess + reach));
  CHECK(out_of_reach.most_torque == Approx(falling(guess - reach)));
  CHECK(out_of_reach.least_torque == Approx(falling(guess + reach)));
  // No film below 340 K: nothing is told of what lies there.
  const auto ends = [=](double T) { return T < 340.0 ? double{NAN} : falling(T); };
  const Calibration cut = calibrate(ends, 2.0, guess, {0.0, 1e-6});
  CHECK_FALSE(cut.found());
  CHECK(cut.coldest >= 340.0);
  CHECK(cut.most_torque == Approx(falling(cut.coldest)));
  CHECK_FALSE(calibrate([](double) { return double{NAN}; }, 2.0, guess, {0.0, 1e-6}).looked());
}

TEST_CASE("OneTierAloneIsNotSplit", "[compare]") {
  const Comparison one = compare(warm_case(), {Tier::thd, Tier::lumped});
  CHECK(one.results.size() == 2);
  CHECK(one.split.steps.empty());
  CHECK_FALSE(one.calibration.looked());
}
