/// Journal and film in balance: isothermal, rigid.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/steady/solve.hpp"
#include "fluid/empty_rings.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Solution isothermal(const Case& c) {
  Solution s = solve_tier(c, Tier::isothermal);
  INFO(app::reason_of(s.verdict));
  REQUIRE(s.verdict.good());
  return s;
}

/// Load control on what a given position carries; the distance between the two positions over c.
double round_trip(Case c, double ratio, double attitude) {
  place_journal(c, ratio, attitude);
  const Solution there = isothermal(c);
  const auto& F = there.film.force;
  c.operation.position = LoadGiven{std::hypot(F[0], F[1]), std::atan2(-F[1], -F[0])};
  const Solution back = isothermal(c);
  return std::hypot(back.film.position.ex() - there.film.position.ex(),
                    back.film.position.ey() - there.film.position.ey()) /
         c.bearing.radial_clearance;
}

/// Everything turned about the bearing axis.
Case turned(Case c, double angle) {
  for (Supply& s : c.supplies) s.angle += angle;
  std::get<LoadGiven>(c.operation.position).angle += angle;
  return c;
}

/// Seen in a mirror on the Y axis.
Case mirrored(Case c) {
  c.operation.omega = -c.operation.omega;
  for (Supply& s : c.supplies) s.angle = kPi - s.angle;
  auto& load = std::get<LoadGiven>(c.operation.position);
  load.angle = kPi - load.angle;
  return c;
}

}  // namespace

TEST_CASE("TheAttitudeAngleThatIsToldIsTheOneThatACaseTakes") {
  for (const double turn : {1.0, -1.0}) {
    Case c = plain_case();
    c.operation.omega *= turn;
    const Solution loaded = isothermal(c);
    const Result told = summarize(loaded, Tier::isothermal);
    CHECK(told.value("attitude_angle") > 0.0);  // with the speed, whichever way
    const double load_line = std::get<LoadGiven>(c.operation.position).angle;
    c.operation.position = EccentricityGiven{told.value("eccentricity_ratio"),
                                             told.value("attitude_angle") * kDegree, load_line};
    const auto& F = isothermal(c).film.force;
    // The load is met to the solver's tolerance, and stiffness over load is of order ten.
    CHECK(std::hypot(F[0], F[1]) == Approx(2e3).epsilon(1e-4));
    CHECK(std::remainder(std::atan2(-F[1], -F[0]) - load_line, 2.0 * kPi) ==
          Approx(0.0).margin(1e-4));
  }
}

TEST_CASE("TheFilmAtMidWidthDoesNotKnowWhetherACellStandsThere") {
  // Rigid surfaces, the journal's place given: c (1 - eps) on the line of centres, on cells within
  // 3 degrees of it; even and odd cells along, straight, tilted by half the clearance, graded.
  for (const double tilt : {0.0, 2e-4}) {
    for (const AxialSpacing axial : {AxialSpacing::even, AxialSpacing::graded}) {
      for (const int nz : {8, 9}) {
        Case c = plain_case();
        c.model.grid = {60, nz};
        c.model.axial_spacing = axial;
        c.operation.position = EccentricityGiven{0.5, 0.0, 0.0};
        if (tilt > 0.0) c.operation.alignment = TiltGiven{tilt, 0.0};
        const Result r = solve(c);
        REQUIRE(r.verdict.good());
        const double middle = 0.5 * c.bearing.radial_clearance;
        INFO(nz << " cells, tilt " << tilt);
        CHECK(r.value("h_min_mid") >= middle * (1.0 - 1e-12));
        // On a face or in the middle of a cell, within 1.5 degrees.
        CHECK(r.value("h_min_mid") <= middle + 0.5 * c.bearing.radial_clearance * 3.5e-4);
        if (tilt == 0.0) CHECK(r.value("h_min_mid") == Approx(r.value("h_min")).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("FilmForceBalancesTheLoad", "[equilibrium]") {
  for (const double load : {5.0, 200.0, 2e3, 2e4, 1e5}) {
    for (const double angle : {270.0, 200.0, 20.0}) {
      INFO("load " << load << " N at " << angle << " deg");
      Case c = plain_case();
      c.supplies[0].pressure = 1e5;  // a line without pressure starves a film that narrows there
      c.operation.position = LoadGiven{load, angle * kDegree};
      const Solution s = isothermal(c);
      CHECK(std::abs(s.film.force[0] + load * std::cos(angle * kDegree)) < 1e-9 * load);
      CHECK(std::abs(s.film.force[1] + load * std::sin(angle * kDegree)) < 1e-9 * load);
      CHECK(summarize(s, Tier::isothermal).audit.mass < 1e-10);
    }
  }
}

TEST_CASE("LoadControlReturnsToTheGivenPosition", "[equilibrium]") {
  for (const double eps : {0.05, 0.2, 0.5, 0.8, 0.95, 0.99}) {
    INFO("eccentricity ratio " << eps);
    const double attitude = std::atan2(kPi * std::sqrt(1.0 - eps * eps), 4.0 * eps);  // Ocvirk
    // load to 1e-9, stiffness of at least one load per clearance
    CHECK(round_trip(plain_case(), eps, attitude) < 1e-8);
  }
}

TEST_CASE("RoughJournalInContactReturnsToTheGivenPosition", "[equilibrium]") {
  Case c = rig_case();
  c.model.switches.pressure_dependence = false;  // a rigid Barus film ends long before contact
  for (const double eps : {0.6, 0.9, 0.97, 0.99, 1.01}) {
    INFO("eccentricity ratio " << eps);
    CHECK(round_trip(c, eps, 20.0 * kDegree) < 1e-8);
  }
  place_journal(c, 0.99, 10.0 * kDegree);
  CHECK(largest(isothermal(c).film.p_contact) > 1e5);  // there it is in contact
}

TEST_CASE("ReversedJournalIsTheMirrorImage", "[equilibrium]") {
  for (const Case& c : {plain_case(), rig_case()}) {
    const Solution a = isothermal(c);
    const Solution b = isothermal(mirrored(c));
    const double clearance = c.bearing.radial_clearance;
    CHECK(std::abs(a.film.position.ex() + b.film.position.ex()) < 1e-8 * clearance);
    CHECK(std::abs(a.film.position.ey() - b.film.position.ey()) < 1e-8 * clearance);
    CHECK(std::abs(torque_of(a) / torque_of(b) + 1.0) < 1e-8);  // load tolerance 1e-9
    const Result ra = summarize(a, Tier::isothermal);
    const Result rb = summarize(b, Tier::isothermal);
    CHECK(ra.value("power_loss") == Approx(rb.value("power_loss")).epsilon(1e-8));
    CHECK(ra.value("attitude_angle") == Approx(rb.value("attitude_angle")).epsilon(1e-7));
  }
}

TEST_CASE("AnElasticBearingFedAsideHasAMirrorImage", "[equilibrium]") {
  // Supplies aside leave an odd number of cells no face at mid-width and unlike ends.
  for (const auto& grid : {std::array{48, 7}, std::array{48, 8}}) {
    Case c = warm_case();
    c.model.grid = grid;
    c.model.switches.elastic_deformation = true;
    c.operation.position = LoadGiven{15e3, 270.0 * kDegree};
    c.supplies[0].length = 6e-3;
    Case other = c;
    c.supplies[0].z = 3e-3;
    other.supplies[0].z = -3e-3;
    const Solution a = isothermal(c), b = isothermal(other);
    CHECK(torque_of(b) == Approx(torque_of(a)).epsilon(1e-8));  // load tolerance 1e-9
    CHECK(b.film.least.h == Approx(a.film.least.h).epsilon(1e-7));
    CHECK(b.film.least.z == Approx(-a.film.least.z).margin(1e-9));
  }
}

TEST_CASE("TurningBearingAndLoadChangesNothing", "[equilibrium]") {
  for (const Case& c : {plain_case(), rig_case()}) {
    const Solution a = isothermal(c);
    for (const double angle : {7.5, 90.0, 31.4, -100.3}) {  // faces follow the supply
      INFO("turned by " << angle << " deg");
      const Solution b = isothermal(turned(c, angle * kDegree));
      CHECK(torque_of(b) == Approx(torque_of(a)).epsilon(1e-8));  // load tolerance 1e-9
      CHECK(b.film.least.h == Approx(a.film.least.h).epsilon(1e-7));
    }
  }
}

TEST_CASE("TurningTheLoadOverTheGridCostsOnlyTheGridError", "[equilibrium]") {
  Case c = plain_case();
  c.supplies[0].arc = 2.0 * kPi;  // a groove all round: no angle is singled out
  c.supplies[0].length = 2e-3;
  c.supplies[0].pressure = 2e5;
  c.model.grid = {96, 18};
  const Solution a = isothermal(c);
  for (const double part : {1.0, 0.3, 0.5}) {  // of a cell
    const Solution b = isothermal([&] {
      Case d = c;
      d.operation.position = LoadGiven{2e3, 270.0 * kDegree + part * 2.0 * kPi / 96};
      return d;
    }());
    const double slack = part == 1.0 ? 1e-7 : 2e-3;  // round-off; (2 pi/96)^2/2
    CHECK(torque_of(b) == Approx(torque_of(a)).epsilon(slack));
    CHECK(b.film.least.h == Approx(a.film.least.h).epsilon(slack));
  }
}

TEST_CASE("HalfBearingIsTheWholeOne", "[equilibrium]") {
  for (const int nz : {9, 10}) {
    Case c = plain_case();
    c.model.grid = {48, nz};
    const Solution half = isothermal(c);
    REQUIRE(half.model.domain.grid.half);
    c.operation.alignment = MomentGiven{};  // free to tilt: solved over the whole width
    const Solution whole = isothermal(c);
    REQUIRE(!whole.model.domain.grid.half);
    CHECK(std::abs(whole.film.position.psi_x()) * c.bearing.width <
          1e-8 * c.bearing.radial_clearance);
    CHECK(torque_of(half) == Approx(torque_of(whole)).epsilon(1e-8));  // load tolerance 1e-9
    CHECK(half.film.least.h == Approx(whole.film.least.h).epsilon(1e-8));
    CHECK(fluid::oil_flows(half.point.scene, half.film.flow).side ==
          Approx(fluid::oil_flows(whole.point.scene, whole.film.flow).side).epsilon(1e-8));
  }
}

TEST_CASE("FreeJournalTiltsUntilNoMomentIsLeft", "[equilibrium]") {
  Case c = plain_case();
  c.supplies[0].arc = 30.0 * kDegree;
  c.supplies[0].length = 8e-3;
  c.supplies[0].z = 5e-3;
  c.supplies[0].pressure = 5e5;
  c.operation.alignment = MomentGiven{};
  const Solution s = isothermal(c);
  const double unit = 2e3 * 0.5 * c.bearing.width;
  CHECK(std::abs(s.film.force[2]) < 1e-9 * unit);
  CHECK(std::abs(s.film.force[3]) < 1e-9 * unit);
  const double tilt = std::hypot(s.film.position.psi_x(), s.film.position.psi_y());
  CHECK(tilt * c.bearing.width > 1e-3 * c.bearing.radial_clearance);
  c.operation.alignment = TiltGiven{s.film.position.psi_x(), s.film.position.psi_y()};
  const Solution again = isothermal(c);
  CHECK(std::abs(again.film.force[2]) < 1e-7 * unit);
  CHECK(std::abs(again.film.force[3]) < 1e-7 * unit);
  c.operation.alignment = MomentGiven{0.5, -0.3};
  const Solution pushed = isothermal(c);
  CHECK(std::abs(pushed.film.force[2] + 0.5) < 1e-9 * unit);
  CHECK(std::abs(pushed.film.force[3] - 0.3) < 1e-9 * unit);
  const Result told = summarize(pushed, Tier::isothermal);
  CHECK(told.value("moment_x") == Approx(-0.5).margin(1e-9 * unit));
  CHECK(told.value("moment_y") == Approx(0.3).margin(1e-9 * unit));
}

TEST_CASE("FilmResistsTilting", "[equilibrium]") {
  Case c = plain_case();
  const double psi = 0.2 * c.bearing.radial_clearance / c.bearing.width;
  c.operation.alignment = TiltGiven{psi, 0.0};
  const Solution a = isothermal(c);
  CHECK(a.film.position.psi_x() == psi);
  CHECK(a.film.force[2] < 0.0);
  c.operation.alignment = TiltGiven{-psi, 0.0};  // the other end of the bearing
  const Solution b = isothermal(c);
  CHECK(a.film.force[2] == Approx(-b.film.force[2]).epsilon(1e-7));
  CHECK(torque_of(a) == Approx(torque_of(b)).epsilon(1e-8));
}

TEST_CASE("TorqueOnTheJournalIsThatOnTheShellAndOfThePressure", "[equilibrium]") {
  for (Case c : {plain_case(), rig_case()}) {
    double before = INFINITY;
    for (const int nt : {50, 100, 200}) {
      c.model.grid = {nt, 13};
      const double moment = summarize(isothermal(c), Tier::isothermal).audit.moment;
      INFO(c.title << " " << nt << " cells: " << moment);
      CHECK(moment < 0.6 * before);
      before = moment;
    }
    CHECK(before < 1e-3);
  }
}

TEST_CASE("AFilmThatBeginsWithAnEmptyRingIsTheOneThatDoesNot", "[equilibrium]") {
  // In a ring that is cavitated all round and fed by nothing any fill ratio is a balance.
  Case c = plain_case();
  c.supplies[0].arc = 20.0 * kDegree;
  c.supplies[0].length = 0.25 * c.bearing.width;
  const Solution whole = solve_tier(c, Tier::isothermal);
  REQUIRE(whole.verdict.good());
  Solution near = whole;
  const FilmGrid& g = near.model.domain.grid;
  for (int i = 0; i < g.nt; ++i) {
    const int k = g.index(i, g.nz - 1);
    near.film.film.full[k] = 0;
    near.film.film.p[k] = 0.0;
    near.film.film.theta[k] = 0.5;
  }
  REQUIRE(fluid::steady_ring_is_empty(near.point.scene, near.film.film));
  const Solution s = solve_tier_from(c, Tier::isothermal, near, {}, Otherwise::failure);
  REQUIRE(s.verdict.good());
  CHECK(s.film.least.h == Approx(whole.film.least.h).epsilon(1e-6));  // Newton's tolerance
}

TEST_CASE("ASupplyIsPassedOverWhereTheOilsTemperatureIsGivenAsAnother") {
  Case c = plain_case();
  c.oil_temperature = 363.15;
  c.supplies[0].temperature = 333.15;
  CHECK(passes_over_supply(c, Tier::isothermal));
  CHECK_FALSE(passes_over_supply(c, Tier::lumped));
  c.measured.shell_back_temperature = 370.0;  // the equivalent temperature begins at the supply's
  CHECK_FALSE(passes_over_supply(c, Tier::isothermal));
  c.measured.shell_back_temperature.reset();
  c.supplies[0].temperature = 363.15;
  CHECK_FALSE(passes_over_supply(c, Tier::isothermal));
}

TEST_CASE("OilThatThinsSteeplyIsFoundInFewIterations", "[equilibrium]") {
  // ln f falls by up to 0.63 of ln rate: what pressure makes of the Couette share counts as much as
  // the flow that it drives itself. Without it in Newton's step no load of these is found in 80.
  Case c = rig_case();
  c.bearing = {0.025, 0.025, 30e-6, 293.15, {}};
  c.supplies[0].pressure = 2e5;
  c.supplies[0].temperature = 333.15;
  c.oil_temperature = 333.15;
  c.surfaces.shell.orientation = c.surfaces.shaft.orientation = 1.0;
  c.oil.shear = rheology::Cross{0.05, 1e-6, 1.0};
  c.operation.omega = 6000.0 * kRpm;
  c.model.grid = {60, 9};
  c.model.tier = Tier::isothermal;
  double before = 0.0;
  for (const double load : {5e3, 8e3, 12e3}) {
    set_load(c, load);
    const Solution s = solve_tier(c, Tier::isothermal);
    INFO(load << ": " << app::reason_of(s.verdict));
    REQUIRE(s.verdict.good());
    CHECK(s.cost.newton_iterations < 60);
    const double e = std::hypot(s.film.position.q[0], s.film.position.q[1]);
    CHECK(e > before);
    before = e;
  }
}
