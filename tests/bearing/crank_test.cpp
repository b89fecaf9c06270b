/// Load of a big end against closed forms, one effect at a time.
#include "bearing/crank.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "core/constants.hpp"

using namespace shellback;
using namespace shellback::bearing;

namespace {

constexpr double kDeg = kPi / 180.0;
constexpr double kOmega = 200.0;     // rad/s
constexpr double kRound = 1e-12;     // some operations in double precision
constexpr double kEndlessRod = 1e7;  // over the stroke: beta and its rate vanish

/// A diesel's proportions; no masses, no gas.
Crank bare() {
  Crank c;
  c.stroke = 0.137;
  c.rod_length = 0.207;
  c.bore = 0.105;
  c.period = 4.0 * kPi;
  return c;
}

double radius(const Crank& c) { return 0.5 * c.stroke; }

}  // namespace

TEST_CASE("ARodWithoutMassOrGasLoadsNothing") {
  const LoadCycle cycle = crank_load(bare(), kOmega);
  REQUIRE(cycle.t.size() == 720);
  CHECK(cycle.period == Approx(4.0 * kPi / kOmega));
  CHECK(cycle.crank_speed == kOmega);
  for (std::size_t k = 0; k < cycle.t.size(); ++k) {
    CHECK(std::hypot(cycle.x[k], cycle.y[k]) == 0.0);
  }
}

TEST_CASE("TheRodSwingsByTheSineOfTheCrank") {
  const Crank c = bare();
  for (double theta = 0.0; theta < 12.0; theta += 0.37) {
    const CrankMotion m = crank_motion(c, theta, kOmega);
    CHECK(std::sin(m.rod_angle) ==
          Approx(radius(c) / c.rod_length * std::sin(theta)).margin(kRound));
    CHECK(m.piston == Approx(radius(c) * std::cos(theta) + c.rod_length * std::cos(m.rod_angle)));
  }
  CHECK(crank_motion(c, 0.0, kOmega).piston == Approx(radius(c) + c.rod_length));
  CHECK(crank_motion(c, kPi, kOmega).piston == Approx(c.rod_length - radius(c)));
  // At top dead centre s'' = -r omega^2 (1 + r/l).
  CHECK(crank_motion(c, 0.0, kOmega).piston_acceleration ==
        Approx(-radius(c) * kOmega * kOmega * (1.0 + radius(c) / c.rod_length)).epsilon(kRound));
}

TEST_CASE("VelocitiesAreTheSlopesOfPositions") {
  // Central differences of step 1e-5 rad: truncation 1e-10 of the value, rounding as much.
  const Crank c = bare();
  constexpr double d = 1e-5;
  const double dt = d / kOmega;
  for (double theta = 0.1; theta < 12.0; theta += 0.41) {
    const CrankMotion a = crank_motion(c, theta - d, kOmega);
    const CrankMotion b = crank_motion(c, theta + d, kOmega);
    const CrankMotion m = crank_motion(c, theta, kOmega);
    const double v = radius(c) * kOmega;
    CHECK((b.piston - a.piston) / (2.0 * dt) == Approx(m.piston_velocity).margin(1e-8 * v));
    CHECK((b.piston_velocity - a.piston_velocity) / (2.0 * dt) ==
          Approx(m.piston_acceleration).margin(1e-8 * v * kOmega));
    CHECK((b.rod_angle - a.rod_angle) / (2.0 * dt) == Approx(m.rod_rate).margin(1e-8 * kOmega));
  }
}

TEST_CASE("UnderAnEndlessRodThePistonsInertiaIsACosine") {
  Crank c = bare();
  c.rod_length = kEndlessRod * c.stroke;
  c.piston_mass = 2.5;
  const double most = c.piston_mass * radius(c) * kOmega * kOmega;
  for (double theta = 0.0; theta < 12.0; theta += 0.3) {
    const LoadNow load = crank_load_at(c, theta, kOmega);
    CHECK(load.x == 0.0);
    CHECK(load.y == Approx(-most * std::cos(theta)).margin(1e-6 * most));  // r/l is 5e-8
    CHECK(load.omega == Approx(kOmega).epsilon(1e-6));
  }
}

TEST_CASE("GasAtTopDeadCentrePressesTheRodsHalfOfTheShell") {
  Crank c = bare();
  c.angle = {0.0, 90.0 * kDeg, 700.0 * kDeg};
  c.pressure = {100e5, 10e5, 10e5};
  const double area = 0.25 * kPi * c.bore * c.bore;
  const LoadNow top = crank_load_at(c, 0.0, kOmega);
  CHECK(top.x == 0.0);
  CHECK(top.y == Approx(100e5 * area).epsilon(kRound));  // up: pin onto the small end's side
  // Elsewhere the thrust along the rod has the pressure's force as its part along the cylinder.
  const LoadNow later = crank_load_at(c, 90.0 * kDeg, kOmega);
  const double beta = crank_motion(c, 90.0 * kDeg, kOmega).rod_angle;
  CHECK(later.y * std::cos(beta) == Approx(10e5 * area).epsilon(kRound));
}

TEST_CASE("PressureIsReadAlongStraightLinesRoundThePeriod") {
  Crank c = bare();
  c.angle = {10.0 * kDeg, 90.0 * kDeg, 700.0 * kDeg};
  c.pressure = {100e5, 20e5, 70e5};
  CHECK(cylinder_pressure(c, 50.0 * kDeg) == Approx(60e5));
  CHECK(cylinder_pressure(c, 0.0) == Approx(90e5));  // 20 of the 30 deg from 700 to 730
  CHECK(cylinder_pressure(c, 710.0 * kDeg) == Approx(80e5));
  CHECK(cylinder_pressure(c, -10.0 * kDeg) == Approx(80e5));
  CHECK(cylinder_pressure(c, 730.0 * kDeg) == Approx(100e5));
  CHECK(cylinder_pressure(bare(), 1.0) == 0.0);
}

TEST_CASE("TheRotatingMassPullsInwardsWithConstantForce") {
  Crank c = bare();
  c.rod_mass = 1.6;
  const double force = c.rod_mass * radius(c) * kOmega * kOmega;
  for (double theta = 0.0; theta < 12.0; theta += 0.3) {
    const LoadNow load = crank_load_at(c, theta, kOmega);
    CHECK(std::hypot(load.x, load.y) == Approx(force).epsilon(kRound));
  }
  CHECK(crank_load_at(c, 0.0, kOmega).y == Approx(-force));  // outer dead centre: onto the cap
  CHECK(crank_load_at(c, kPi, kOmega).y == Approx(force));   // inner one: onto the rod's half
}

TEST_CASE("ForcesOfTheRodAddUpToThePinsInTheBlock") {
  // Turned back into the cylinder's frame: W = S a - m_r r omega^2 (pin over r), counter-clockwise.
  Crank c = bare();
  c.piston_mass = 2.5;
  c.rod_mass = 1.6;
  for (double theta = 0.05; theta < 12.0; theta += 0.3) {
    const CrankMotion m = crank_motion(c, theta, kOmega);
    const LoadNow load = crank_load_at(c, theta, kOmega);
    const double sine = std::sin(m.rod_angle);
    const double cosine = std::cos(m.rod_angle);
    // Rod's Y in the block (sin beta, cos beta), its X (cos beta, -sin beta).
    const double x = load.x * cosine + load.y * sine;
    const double y = -load.x * sine + load.y * cosine;
    const double pull = c.rod_mass * radius(c) * kOmega * kOmega;
    const double thrust = c.piston_mass * m.piston_acceleration;
    const double size = pull + std::abs(thrust);
    CHECK(x ==
          Approx(thrust * std::tan(m.rod_angle) + pull * std::sin(theta)).margin(1e-12 * size));
    CHECK(y == Approx(thrust - pull * std::cos(theta)).margin(1e-12 * size));
  }
}

TEST_CASE("ThePinTurnsInTheRodAsFastAsTheCrankOnTheMean") {
  const Crank c = bare();
  const LoadCycle cycle = crank_load(c, kOmega);
  const double sum = std::accumulate(cycle.omega.begin(), cycle.omega.end(), 0.0);
  CHECK(sum / static_cast<double>(cycle.omega.size()) == Approx(kOmega).epsilon(kRound));
  // At top dead centre rod and crank turn against one another.
  CHECK(cycle.omega[0] == Approx(kOmega * (1.0 + radius(c) / c.rod_length)).epsilon(kRound));
}

TEST_CASE("ACrankTurningClockwiseIsTheMirrorImage") {
  Crank c = bare();
  c.piston_mass = 2.5;
  c.rod_mass = 1.6;
  for (double theta = 0.0; theta < 12.0; theta += 0.7) {
    const LoadNow a = crank_load_at(c, theta, kOmega);
    const LoadNow b = crank_load_at(c, theta, -kOmega);
    CHECK(b.x == -a.x);
    CHECK(b.y == a.y);
    CHECK(b.omega == -a.omega);
  }
}

TEST_CASE("NoPointOfThePressureIsLost") {
  Crank c = bare();
  c.angle = {0.0, 7.4 * kDeg, 90.0 * kDeg};
  c.pressure = {100e5, 150e5, 10e5};
  const LoadCycle cycle = crank_load(c, kOmega);
  REQUIRE(cycle.t.size() == 721);
  const std::size_t k = 8;
  CHECK(cycle.t[k] * kOmega == Approx(7.4 * kDeg));
  CHECK(cycle.y[k] == Approx(crank_load_at(c, 7.4 * kDeg, kOmega).y));
  for (std::size_t i = 1; i < cycle.t.size(); ++i) CHECK(cycle.t[i] > cycle.t[i - 1]);
}

TEST_CASE("AFullCounterweightLeavesTheMainBearingThePistonAlone", "[crank]") {
  Crank c = bare();
  c.piston_mass = 2.5;
  c.rod_mass = 1.6;
  c.counterweight = c.rod_mass * radius(c);
  c.share = 0.3;
  for (double theta = 0.05; theta < 12.0; theta += 0.3) {
    const CrankMotion m = crank_motion(c, theta, kOmega);
    const LoadNow load = main_bearing_load_at(c, theta, kOmega);
    // The piston's inertia along the cylinder, and what leans on its wall across.
    const double along = -c.share * c.piston_mass * m.piston_acceleration;
    const double size = c.share * c.piston_mass * radius(c) * kOmega * kOmega;
    CHECK(load.y == Approx(along).margin(1e-12 * size));
    CHECK(load.x == Approx(along * std::tan(m.rod_angle)).margin(1e-12 * size));
    CHECK(load.omega == kOmega);
  }
}

TEST_CASE("GasTurnsTheCrankByTheLeverOfThePin", "[crank]") {
  // Work: what gas does on the piston is what the rod's force does on the pin: p A (-s') = M omega.
  Crank c = bare();
  c.angle = {0.0, 90.0 * kDeg, 700.0 * kDeg};
  c.pressure = {100e5, 10e5, 10e5};
  c.share = 1.0;
  const double area = 0.25 * kPi * c.bore * c.bore;
  for (double theta = 0.05; theta < 12.0; theta += 0.3) {
    const LoadNow at = main_bearing_load_at(c, theta, kOmega);
    const double moment = -radius(c) * (std::sin(theta) * at.y + std::cos(theta) * at.x);
    const double power =
        -cylinder_pressure(c, theta) * area * crank_motion(c, theta, kOmega).piston_velocity;
    CHECK(moment * kOmega == Approx(power).margin(1e-9 * 100e5 * area));
  }
  CHECK(main_bearing_load_at(c, 0.0, kOmega).y == Approx(-100e5 * area));  // onto the cap
}

TEST_CASE("AMainBearingTurningClockwiseIsTheMirrorImage", "[crank]") {
  Crank c = bare();
  c.piston_mass = 2.5;
  c.rod_mass = 1.6;
  c.counterweight = 0.05;
  for (double theta = 0.0; theta < 12.0; theta += 0.7) {
    const LoadNow a = main_bearing_load_at(c, theta, kOmega);
    const LoadNow b = main_bearing_load_at(c, theta, -kOmega);
    CHECK(b.x == -a.x);
    CHECK(b.y == a.y);
    CHECK(b.omega == -a.omega);
  }
}
