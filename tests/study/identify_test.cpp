// Keys of bearings from computed measurements with noise.
#include "app/study/identify.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <random>

#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::study;
using bearing::Case;

namespace {

using Values = std::vector<double>;

/// Mixed friction of the rig, isothermal and rigid, with a law of (mu_abrasive, mu_adhesive, b).
Case rubbing(double rpm, double load, const Values& x) {
  Case c = bearing::tests::rig_case();
  c.model.tier = bearing::Tier::isothermal;
  c.model.grid = {60, 7};
  c.operation.omega = rpm * kPi / 30.0;
  bearing::tests::set_load(c, load);
  solid::GenericFriction f;
  f.abrasive = x[0];
  f.adhesive = x[1];
  f.a = 10.0;
  f.b = x[2];
  f.summit_radius = 10e-6;
  c.surfaces.contact->friction = 0.0;
  c.surfaces.contact->friction_law = f;
  return c;
}

struct Place {
  double rpm;
  double load;
};

/// Torques at the places, computed with `truth` and falsified by the deviation [N m].
std::vector<MeasuredPoint> measured(const std::vector<Place>& places, const Values& truth,
                                    double deviation, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, deviation);
  std::vector<MeasuredPoint> all;
  for (const Place& p : places) {
    const Case c = rubbing(p.rpm, p.load, truth);
    const bearing::Result r = bearing::solve(c);
    REQUIRE(r.verdict.good());
    const double torque = r.value("friction_torque") + noise(random);
    all.push_back({"point", std::to_string(p.load), {{"friction_torque", torque, deviation}}});
  }
  return all;
}

MeasuredCase source(const std::vector<Place>& places) {
  return [places](double at, const Values& x) {
    const auto k = static_cast<std::size_t>(at);
    const double part = at - static_cast<double>(k);
    const std::size_t next = std::min(k + 1, places.size() - 1);
    return rubbing(places[k].rpm + part * (places[next].rpm - places[k].rpm), places[k].load, x);
  };
}

const std::vector<FitParameter> kKeys{{0.02, 0.0005, 0.1}, {0.03, 0.005, 0.5}, {100.0, 1.0, 1e4}};
const Values kTruth{0.008, 0.06, 400.0};

}  // namespace

TEST_CASE("ConstantsOfBoundaryFrictionComeBackFromNoisyTorques", "[identify]") {
  std::vector<Place> places;
  for (const double load : {4e3, 8e3}) {
    for (const double rpm : {10.0, 30.0, 80.0, 200.0, 400.0, 800.0}) places.push_back({rpm, load});
  }
  const auto points = measured(places, kTruth, 0.01, 4);
  const Identification end = identify(points, kKeys, source(places));
  REQUIRE(end.fit.status == FitStatus::settled);
  CHECK(end.lost() == 0);
  CHECK(end.fit.determined());
  for (std::size_t k = 0; k < kTruth.size(); ++k) {
    INFO(k << ": " << end.fit.x[k] << " +- " << end.fit.deviation[k]);
    // three deviations: 0.3 % by chance for each
    CHECK(std::abs(end.fit.x[k] - kTruth[k]) < 3.0 * end.fit.deviation[k]);
    CHECK(end.fit.deviation[k] < 0.5 * kTruth[k]);
  }
  // 9 degrees of freedom: 99.9 % below 27.9
  CHECK(end.fit.chi2 < 28.0);
}

TEST_CASE("ATorqueIsFittedWithTheSignOfItsSpeed", "[identify]") {
  const std::vector<Place> places{{-10.0, 4e3}, {40.0, 4e3}, {-150.0, 4e3}};
  const auto points = measured(places, kTruth, 1e-3, 6);
  REQUIRE(points[0].values[0].value < 0.0);
  const MeasuredCase all = source(places);
  const MeasuredCase adhesion = [&](double at, const Values& x) {
    return all(at, {kTruth[0], x[0], kTruth[2]});
  };
  const Identification end = identify(points, {kKeys[1]}, adhesion);
  REQUIRE(end.fit.status == FitStatus::settled);
  CHECK(std::abs(end.fit.x[0] - kTruth[1]) < 3.0 * end.fit.deviation[0]);  // 0.3 % by chance
  CHECK(end.fit.chi2 < 13.8);                                              // 99.9 % of two
}

TEST_CASE("OneSpeedCannotTellDecayFromAdhesion", "[identify]") {
  const std::vector<Place> places{{80.0, 8e3}, {80.0, 8e3}, {80.0, 8e3}, {80.0, 8e3}};
  auto points = measured(places, kTruth, 1e-3, 5);
  const Identification end = identify(points, kKeys, source(places));
  CHECK_FALSE(end.fit.determined());
  int loose = 0;
  for (const FitDirection& d : end.fit.directions) loose += d.determined ? 0 : 1;
  CHECK(loose == 2);  // one torque: one combination of three
}

TEST_CASE("TheFactorOfTheEquivalentTemperatureComesBack", "[identify]") {
  const Values back{360.0, 372.0, 381.0, 394.0};
  const auto warm = [&](double at, const Values& x) {
    Case c = bearing::tests::rig_case();
    c.model.tier = bearing::Tier::isothermal;
    c.model.grid = {60, 7};
    c.supplies[0].temperature = 350.0;
    const auto k = static_cast<std::size_t>(at);
    c.operation.omega = (2000.0 + 800.0 * at) * kPi / 30.0;
    c.measured.shell_back_temperature =
        back[k] + (at - static_cast<double>(k)) * (back[std::min<std::size_t>(k + 1, 3)] - back[k]);
    c.model.kappa = x[0];
    return c;
  };
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 1e-3);
  std::vector<MeasuredPoint> points;
  for (int k = 0; k < 4; ++k) {
    const double torque = bearing::solve(warm(k, {0.8})).value("friction_torque");
    points.push_back({"point", "", {{"friction_torque", torque + noise(random), 1e-3}}});
  }
  const Identification end = identify(points, {{1.0, 0.1, 2.0}}, warm);
  REQUIRE(end.fit.status == FitStatus::settled);
  CHECK(end.fit.determined());
  CHECK(std::abs(end.fit.x[0] - 0.8) < 3.0 * end.fit.deviation[0]);
  CHECK(end.fit.deviation[0] < 0.1);
}

TEST_CASE("APointThatIsNotFoundIsLeftOutAndKept", "[identify]") {
  std::vector<Place> places{{100.0, 8e3}, {200.0, 8e3}, {400.0, 8e3}, {800.0, 8e3}};
  auto points = measured(places, kTruth, 0.01, 6);
  const auto with_a_hopeless_one = [&](double at, const Values& x) {
    Case c = source(places)(at, x);
    if (at == 2.0) {  // smooth rigid surfaces cannot carry 10 MN
      c.surfaces = {};
      bearing::tests::set_load(c, 1e7);
    }
    return c;
  };
  const Identification end =
      identify(points, {{0.02, 0.0005, 0.1}}, [&](double at, const Values& x) {
        return with_a_hopeless_one(at, {x[0], 0.06, 400.0});
      });
  CHECK(end.lost() == 1);
  REQUIRE_FALSE(end.points[2].used());
  CHECK_FALSE(end.points[2].verdict.good());
  CHECK_FALSE(end.points[2].verdict.is(ending::Plain::none));
  CHECK(end.values_used(points) == 3);
  CHECK(end.fit.status == FitStatus::settled);
  CHECK(std::abs(end.fit.x[0] - kTruth[0]) < 3.0 * end.fit.deviation[0]);
}

TEST_CASE("AnInterruptedIdentificationShowsTheBestKeysWithTheirTorques", "[identify]") {
  const std::vector<Place> places{{30.0, 8e3}, {80.0, 8e3}, {200.0, 8e3}, {400.0, 8e3}};
  const auto points = measured(places, kTruth, 0.01, 7);
  std::atomic<bool> stop{false};
  IdentifyOptions options;
  options.stop = &stop;
  options.progress = [&](const IdentifyProgress& now) { stop = now.evaluation >= 8; };
  const Identification end = identify(points, kKeys, source(places), options);
  CHECK(end.fit.status == FitStatus::interrupted);
  REQUIRE(end.fit.computed());
  CHECK(end.fit.chi2 <= end.fit.chi2_start);
  CHECK(end.fit.freedom == 1);
  CHECK(end.fit.refused_steps == 0);
  double chi2 = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    REQUIRE(end.points[i].fitted.size() == 1);
    const auto& m = points[i].values[0];
    chi2 += std::pow((end.points[i].fitted[0] - m.value) / m.deviation, 2);
    // The torque of a new solution with these keys: solver tolerance (accuracy_of) of the torque.
    const Case again = rubbing(places[i].rpm, places[i].load, end.fit.x);
    CHECK(bearing::solve(again).value("friction_torque") ==
          Approx(end.points[i].fitted[0]).epsilon(1e-7));
  }
  CHECK(chi2 == Approx(end.fit.chi2).epsilon(1e-12));
}
