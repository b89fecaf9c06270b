#include "fidelity/estimate.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "fidelity/indicators.hpp"
#include "tests/bearing/sample_bearing.hpp"

namespace shellback::fidelity {
namespace {

using namespace bearing;
using namespace bearing::tests;

}  // namespace

TEST_CASE("EstimateOfAnIsoviscousBearingIsItsSolution") {
  // The bearing of the table itself: what remains is interpolation and the solver's grid.
  Case c = plain_case();
  c.model.grid = {200, 25};
  for (const double load : {200.0, 2e3, 15e3}) {
    c.operation.position = LoadGiven{load, 270.0 * kDegree};
    const Estimate e = estimate(c);
    // Line of supply at the widest gap of the solution.
    c.supplies[0].angle = 270.0 * kDegree + e.attitude + kPi;
    const Solution s = solve_tier(c, Tier::isothermal);
    const Result r = summarize(s, Tier::isothermal);
    REQUIRE(r.verdict.good());
    CHECK(e.h_min == Approx(r.value("h_min")).epsilon(0.02));
    CHECK(e.torque == Approx(r.value("friction_torque")).epsilon(0.01));
    CHECK(e.side_flow == Approx(r.value("side_flow")).epsilon(0.01));
    CHECK(e.p_max == Approx(r.value("p_max")).epsilon(0.02));
    CHECK(e.attitude / kDegree == Approx(r.value("attitude_angle")).epsilon(0.01));
  }
}

TEST_CASE("EstimatedHeatIsBalanced") {
  Case c = warm_case();
  c.shell.reset();
  c.shaft.reset();
  const Estimate e = estimate(c);
  const double power = e.torque * c.operation.omega;
  CHECK(e.rise > 0.0);
  CHECK(860.0 * 2000.0 * e.side_flow * e.rise == Approx(power).epsilon(1e-3));
  // Cooled walls take heat away: the film is colder, its friction higher.
  const Estimate cooled = estimate(warm_case());
  CHECK(cooled.T < e.T);
  CHECK(cooled.torque > e.torque);
}

TEST_CASE("EstimateKnowsTheRegime") {
  Case c = rig_case();
  CHECK(estimate(c).regime != Regime::boundary);
  c.operation.omega *= 10.0;
  c.operation.position = LoadGiven{500.0, 270.0 * kDegree};
  CHECK(estimate(c).regime == Regime::hydrodynamic);
  c.operation.omega *= 1e-4;  // 7 mm/s: summits slide
  c.operation.position = LoadGiven{8e3, 270.0 * kDegree};
  const Estimate resting = estimate(c);
  CHECK(resting.regime == Regime::boundary);
  // Friction of a journal that rests on asperities and slides: mu F R to the roundness of its
  // contact arc.
  CHECK(resting.torque == Approx(0.02 * 8e3 * c.bearing.radius).epsilon(0.2));
}

TEST_CASE("EstimateMirrorsWithTheSenseOfRotation") {
  Case c = warm_case();
  const Result forward = estimate_result(c);
  c.operation.omega = -c.operation.omega;
  const Result backward = estimate_result(c);
  CHECK(backward.value("friction_torque") == Approx(-forward.value("friction_torque")));
  CHECK(backward.value("power_loss") == Approx(forward.value("power_loss")));
  CHECK(std::isnan(forward.audit.mass));
  CHECK(forward.fields.p.empty());
  for (const Quantity& q : forward.quantities) {
    INFO(q.name);
    CHECK(std::isfinite(q.error()));
  }
}

TEST_CASE("TheBarsOfTheEstimateHoldSuppliesThatPressAndThatStarve") {
  // The bearing of decision 050: supplies whose pressure is not small against the load's, and holes
  // that feed less than the film takes; 20 % of the film's values for the table's own bar.
  const auto check = [](Supply supply, double load, double pressure) {
    Case c = plain_case();
    c.bearing.radius = 0.05;
    c.bearing.width = 0.08;
    c.bearing.radial_clearance = 1e-4;
    c.oil.temperature = rheology::ConstantViscosity{0.02};
    supply.pressure = pressure;
    supply.angle = 150.0 * kDegree;
    c.supplies = {supply};
    c.operation.position = LoadGiven{load, 270.0 * kDegree};
    c.model.grid = {100, 24};
    const Result estimated = estimate_result(c);
    const Result solved = summarize(solve_tier(c, Tier::isothermal), Tier::isothermal);
    REQUIRE(solved.verdict.good());
    for (const char* name : {"friction_torque", "h_min", "p_max"}) {
      const Quantity& q = *quantity_in(estimated.quantities, name);
      INFO(name << " " << q.value << " +- " << q.error() << ", solved " << solved.value(name));
      CHECK(std::abs(q.value - solved.value(name)) <= q.error());
    }
  };
  Supply groove = warm_case().supplies[0];
  groove.length = 0.04;
  Supply hole = hole_case().supplies[0];
  for (const double load : {500.0, 2e3, 8e3, 40e3}) {
    for (const double pressure : {1e5, 5e5, 20e5}) {
      INFO("load " << load << " N, supply " << pressure << " Pa");
      check(groove, load, pressure);
    }
    for (const double pressure : {0.2e5, 1e5, 10e5}) {
      INFO("load " << load << " N, hole " << pressure << " Pa");
      check(hole, load, pressure);
    }
  }
}

TEST_CASE("ARingFeedsTheLandsByItsPressureAlone") {
  // Between a ring at p and edges at none the flow around an aligned land does not hang on z:
  // pi D c^3 p (1 + 1.5 eps^2)/(12 eta L) out of each, whatever the film presses out at the ring.
  Case c = plain_case();
  c.oil.temperature = rheology::ConstantViscosity{0.02};
  Supply ring = warm_case().supplies[0];
  ring.kind = SupplyKind::circumferential_groove;
  ring.arc = 2.0 * kPi;
  ring.length = 0.1 * c.bearing.width;
  ring.z = 0.0;
  c.supplies = {ring};
  c.model.grid = {120, 30};
  for (const double pressure : {0.5e5, 3e5}) {
    c.supplies[0].pressure = pressure;
    const Result estimated = estimate_result(c);
    const double land = 0.5 * (c.bearing.width - ring.length),
                 eps = estimated.value("eccentricity_ratio");
    const double closed = 2.0 * kPi * 2.0 * c.bearing.radius *
                          std::pow(c.bearing.radial_clearance, 3) * pressure *
                          (1.0 + 1.5 * eps * eps) / (12.0 * 0.02 * land);
    CHECK(estimated.value("side_flow") == Approx(closed).epsilon(1e-6));
    const Result solved = summarize(solve_tier(c, Tier::isothermal), Tier::isothermal);
    for (const char* name : {"side_flow", "h_min", "attitude_angle", "friction_torque"}) {
      const Quantity& q = *quantity_in(estimated.quantities, name);
      INFO(name << " " << q.value << " +- " << q.error() << ", solved " << solved.value(name));
      CHECK(std::abs(q.value - solved.value(name)) <= q.error());
    }
  }
}

TEST_CASE("TheLoadOfAGivenPlaceActsWhereTheFilmHoldsIt") {
  Case c = plain_case();
  c.model.grid = {100, 24};
  for (const double direction : {200.0, 320.0}) {
    EccentricityGiven given;
    given.ratio = 0.6;
    given.load_angle = 270.0 * kDegree;
    given.attitude = (direction - 270.0) * kDegree;
    c.operation.position = given;
    c.supplies[0].angle = given.direction(c.operation.omega) + kPi;
    const Result estimated = estimate_result(c);
    const Result solved = summarize(solve_tier(c, Tier::isothermal), Tier::isothermal);
    for (const char* name : {"load_x", "load_y"}) {
      const Quantity& q = *quantity_in(estimated.quantities, name);
      INFO(direction << " " << name << " " << q.value << " +- " << q.error() << ", solved "
                     << solved.value(name));
      CHECK(std::abs(q.value - solved.value(name)) <= q.error());
      CHECK(q.value ==
            Approx(solved.value(name))
                .margin(0.03 * std::hypot(solved.value("load_x"), solved.value("load_y"))));
    }
  }
}

}  // namespace shellback::fidelity

TEST_CASE("TheShaftSagsAsTheBeamOfItsFilmsPressure") {
  // Moment F/2 (L/2 - z) - q (B/2 - z)^2/2 and shear q z, integrated twice from mid-width to the
  // edge. The curvature of mid-width for all of the half: 6 % too much at a span of three widths.
  Case c = tests::rig_case();
  CHECK(fidelity::shaft_sag(c) == 0.0);
  const double B = c.bearing.width, R = c.bearing.radius, span = 3.0 * B;
  c.shaft->span = span;
  const double E = c.shaft->material.youngs_modulus;
  const double G = 0.5 * E / (1.0 + c.shaft->material.poisson_ratio);
  const double q = 2.0 * R, I = 0.25 * kPi * std::pow(R, 4), A = kPi * R * R;
  double slope = 0.0, sag = 0.0;
  constexpr int kParts = 2000;
  const double dz = 0.5 * B / kParts;
  for (int k = 0; k < kParts; ++k) {
    const double z = (k + 0.5) * dz;
    const double moment = 0.5 * q * B * (0.5 * span - z) - 0.5 * q * std::pow(0.5 * B - z, 2);
    sag += (slope + 0.5 * dz * moment / (E * I) + q * z / (0.9 * G * A)) * dz;
    slope += dz * moment / (E * I);
  }
  CHECK(fidelity::shaft_sag(c) > sag);
  CHECK(fidelity::shaft_sag(c) == Approx(sag).epsilon(0.1));
}

TEST_CASE("TheOpeningOfTheBoreIsThatOfItsLayersAndItsHousing") {
  Case c = rig_case();
  const double stiff = fidelity::bore_compliance(c);
  // A thin compressible layer: p t (1 + nu)(1 - 2 nu)/(E (1 - nu)).
  const solid::Material soft{"soft", 0.2, 1200.0, 1500.0, 5e7, 0.3, 1e-4};
  c.shell->layers.insert(c.shell->layers.begin(), {soft, 20e-6});
  const double thin = 20e-6 * 1.3 * 0.4 / (5e7 * 0.7);
  CHECK(fidelity::bore_compliance(c) - stiff == Approx(thin).epsilon(0.01));
  // An incompressible one gives way by being pushed aside, with the third power of its thickness.
  const auto opening = [&](double t) {
    c.shell->layers.front().material.poisson_ratio = 0.4999;
    c.shell->layers.front().thickness = t;
    return fidelity::bore_compliance(c) - stiff;
  };
  CHECK(opening(4e-3) == Approx(8.0 * opening(2e-3)).epsilon(0.1));
}
