/// Rigid films that the joint Newton iteration does not find, or that do not exist.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/film/follow.hpp"
#include "bearing/film/newton.hpp"
#include "bearing/film/pseudo_time.hpp"
#include "bearing/film/solve_equilibrium.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/steady/audit.hpp"
#include "solid/asperity_contact.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Case barus_case(double force) {
  Case c = plain_case();
  c.oil.pressure = rheology::Barus{1.8e-8};
  c.operation.position = LoadGiven{force, 270.0 * kDegree};
  return c;
}

/// The force at which the refusal of a too large load says that the film ends [N].
double limit_told(double force) {
  const Solution s = solve_tier(barus_case(force), Tier::isothermal);
  INFO(app::reason_of(s.verdict));
  CHECK(s.verdict.status == Status::no_steady_state);
  return std::hypot(s.film.force[0], s.film.force[1]);
}

}  // namespace

TEST_CASE("ALimitLoadDoesNotDependOnTheLoadAskedFor", "[refusal]") {
  const double limit = limit_told(80e3);
  // the path's smallest step, and where on the way the film was looked for: some per cent
  CHECK(limit_told(200e3) == Approx(limit).epsilon(0.05));
  CHECK(limit_told(500e3) == Approx(limit).epsilon(0.05));
  // and half of it is carried
  CHECK(solve_tier(barus_case(0.5 * limit), Tier::isothermal).verdict.good());
}

namespace {

/// A slow journal above a hole of 10 bar that lifts light loads to the middle of the clearance.
Case jacked_case(double force) {
  Case c = plain_case();
  c.bearing.radius = 0.05;
  c.bearing.width = 0.05;
  c.bearing.radial_clearance = 271.2e-6;
  Supply groove;
  groove.kind = SupplyKind::axial_groove;
  groove.angle = 18.14 * kDegree;
  groove.arc = 18.79 * kDegree;
  groove.length = 18.47e-3;
  groove.temperature = 313.15;
  Supply fed = groove;
  fed.angle = 143.4 * kDegree;
  fed.arc = 10.68 * kDegree;
  fed.pressure = 3e5;
  Supply hole = hole_case().supplies[0];
  hole.angle = 272.34 * kDegree;
  hole.z = 5e-3;
  hole.diameter = 6.222e-3;
  hole.pressure = 10e5;
  c.supplies = {groove, fed, hole};
  c.operation.omega = -6.0;
  c.operation.position = LoadGiven{force, 250.0 * kDegree};
  c.oil.temperature = rheology::ConstantViscosity{4.45e-3};
  c.model.edges = Edges::dry;
  c.model.grid = {100, 13};
  return c;
}

}  // namespace

TEST_CASE("AFilmThatNoLightLoadLeadsToIsFoundFromAHeavierOne") {
  // The film of the journal's own motion, a micrometre thick, beside the branch of the lifted
  // journal, which carries less than 600 N: cold, and from the film of a heavier load.
  for (const double force : {750.0, 800.0, 850.0}) {
    CAPTURE(force);
    const Case c = jacked_case(force);
    const Solution cold = solve_tier(c, Tier::isothermal);
    REQUIRE(cold.verdict.good());
    CHECK(audit_of(cold, friction_of(cold.model, cold.point, cold.film)).load < 1e-6);
  }
}

TEST_CASE("ALightlyLoadedFilmIsFoundHoweverThickTheOil") {
  for (const double eta : {0.1, 1.0, 10.0}) {
    Case c = warm_case();
    c.oil.temperature = rheology::ConstantViscosity{eta};
    c.model.tier = Tier::isothermal;
    const Solution s = solve_tier(c, Tier::isothermal);
    INFO(eta << ": " << app::reason_of(s.verdict));
    CHECK(s.verdict.good());
  }
}

TEST_CASE("ThePathEndsInTheEquilibriumThatNewtonFinds") {
  const Case c = plain_case();
  const Solution usual = solve_tier(c, Tier::isothermal);
  REQUIRE(usual.verdict.good());
  Solution s = usual;
  Part part(s, Raised::load);
  part.take(0.05);
  s.film = cold_start(s.model, s.point, 313.15);
  REQUIRE(solve_equilibrium({s.model, s.point, {}}, s.film, s.cost).good());
  part.take(1.0);
  const Corrector correct = [](Solution& at, Accuracy) {
    return newton({at.model, at.point, {}}, at.film, at.cost);
  };
  const Branch branch = follow_load(s, 0.05, correct, {});
  REQUIRE(branch.end == BranchEnd::reached);
  for (int k = 0; k < 2; ++k) {
    CHECK(s.film.position.q[k] ==
          Approx(usual.film.position.q[k]).margin(1e-7 * usual.model.clearance));
  }
}

TEST_CASE("ThroughTimeThereIsTheEquilibriumThatNewtonFinds") {
  for (const bool elastic : {false, true}) {
    Case c = rig_case();
    c.model.switches.elastic_deformation = elastic;
    const Solution usual = solve_tier(c, Tier::isothermal);
    REQUIRE(usual.verdict.good());
    FilmEquilibrium s = cold_start(usual.model, usual.point, usual.T_film);
    s.position.q = {};
    EquilibriumCost cost;
    REQUIRE(march_to_steady({usual.model, usual.point, {}}, s, cost).good());
    for (int k = 0; k < 2; ++k) {
      CHECK(s.position.q[k] ==
            Approx(usual.film.position.q[k]).margin(1e-7 * usual.model.clearance));
    }
  }
}

TEST_CASE("AnInterruptedBranchIsNoSolution", "[refusal]") {
  Solution s = solve_tier(plain_case(), Tier::isothermal);
  REQUIRE(s.verdict.good());
  std::atomic<bool> stop{false};
  SolveControl control;
  control.stop = &stop;
  for (const Raised raised : {Raised::load, Raised::speed}) {
    Part part(s, raised);
    part.take(0.05);
    REQUIRE(solve_equilibrium({s.model, s.point, {}}, s.film, s.cost).good());
    part.take(1.0);
    stop = false;
    const Corrector correct = [&](Solution& at, Accuracy) {
      stop = true;  // during the first step, which arrives
      return newton({at.model, at.point, {}}, at.film, at.cost);
    };
    const Branch branch = raised == Raised::load
                              ? follow_load(s, 0.05, correct, control)
                              : follow_parts(s, Raised::speed, 0.05, correct, control);
    CHECK(branch.end == BranchEnd::interrupted);
    CHECK(branch.last.status == Status::interrupted);
  }
}

TEST_CASE("SurfacesInEachOtherArePassedByTheirOverlap") {
  // Soft summits that overlap by micrometres: from half the load to the whole in few states. By
  // what is left between the summits, a hundredth of the overlap, each brought half a per cent.
  Case c = rig_case();
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {48, 9};
  c.operation.omega = 1e-5;
  c.surfaces.contact->elastic_factor = 1e-6;
  set_load(c, 20e3);
  const Solution half = solve_tier(c, Tier::isothermal);
  REQUIRE(half.verdict.good());
  REQUIRE(half.film.least.h < -10.0 * half.model.domain.rough.sigma);
  Solution s = half;
  for (double& f : s.point.load.force) f *= 2.0;
  int states = 0;
  const Corrector correct = [&](Solution& at, Accuracy) {
    ++states;
    return newton({at.model, at.point, {}}, at.film, at.cost);
  };
  const Branch branch = follow_load(s, 0.5, correct, {});
  CHECK(branch.end == BranchEnd::reached);
  CHECK(states < 20);
}

TEST_CASE("ALimitIsConfirmedOnCellsThatCanBeSolved") {
  // A tilted bearing of 100 cells along is solved on 128 at most: 1.5 times as many were wrong
  // input.
  Case c = plain_case();
  c.oil.pressure = rheology::Barus{2e-8};
  c.operation.alignment = TiltGiven{2e-5, 0.0};
  c.model.axial_spacing = AxialSpacing::even;
  c.model.grid = {20, 100};
  set_load(c, 60e3);
  const Solution s = solve_tier(c, Tier::isothermal);
  INFO(app::reason_of(s.verdict));
  REQUIRE(s.limits.size() == 2);
  CHECK(s.limits[0].grid == std::array{30, 128});
  CHECK(s.limits[1].grid == c.model.grid);
  CHECK(s.verdict.status == Status::no_steady_state);
}

TEST_CASE("ABranchBeginsWhereSummitsCarryTheJournalAtRest") {
  // A clamped housing of half the clearance: at 3000 rpm the walls meet, at a crawl the summits
  // carry the load. That first state takes more iterations than those which follow it.
  Case c = rig_case();
  c.model.grid = {72, 12};
  c.model.switches.elastic_deformation = true;
  c.model.switches.thermal_deformation = true;
  c.bearing.radial_clearance = 12e-6;
  c.shell->housing->support = HousingSupport::clamped;
  set_load(c, 8e3);
  const Solution s = solve_tier(c, Tier::tehd);
  REQUIRE_FALSE(s.verdict.good());
  REQUIRE_FALSE(s.limits.empty());
  CHECK(s.limits.front().raised == Raised::speed);
  CHECK(s.limits.front().part > 0.3);  // of the speed
}

TEST_CASE("AJournalWithMassFollowsNewtonsLaw") {
  // m (q - q_free)/dt^2 = F + W at the end of a step, whatever the mass; the film yields to a light
  // journal and holds a heavy one nowhere but where it flies to.
  const Case c = plain_case();
  const Solution steady = solve_tier(c, Tier::isothermal);
  REQUIRE(steady.verdict.good());
  const double dt = 1e-4;                             // [s]
  const std::array<double, 2> velocity{0.02, -0.03};  // [m/s]: 2 and 3 um in a step
  double farther = INFINITY;
  for (const double mass : {1e-3, 1.0, 1e3, 1e6}) {
    const BearingModel& model = steady.model;
    OperatingPoint point = steady.point;
    FilmEquilibrium s = steady.film;
    REQUIRE(evaluate(model, point, {}, 1e-12, s));
    point.scene.storage = {dt, fluid::oil_content(point.scene, s.gap, s.oil, s.film)};
    point.load.inertial_stiffness = mass / (dt * dt);
    std::array<double, 2> free{};  // flight
    for (int k = 0; k < 2; ++k) {
      free[k] = s.position.q[k] + dt * velocity[k];
      s.flight[k] = s.position.q[k] - free[k];
    }
    EquilibriumCost cost;
    const Verdict v = newton({model, point, {}}, s, cost);
    INFO(mass << " kg: " << app::reason_of(v));
    REQUIRE(v.good());
    CHECK(cost.newton_iterations < 15);  // quadratic: a wrong sign of the mass in the border is not
    double off = 0.0;
    for (int k = 0; k < 2; ++k) {
      const double load = -steady.point.load.force[k];
      const double acceleration = (s.position.q[k] - free[k]) / (dt * dt);
      CHECK(std::abs(mass * acceleration - (s.force[k] + load)) < 1e-8 * steady.point.load.scale());
      // What the state carries as its flight is the same, beyond the round-off of the place.
      CHECK(std::abs(mass / (dt * dt) * s.flight[k] - (s.force[k] + load)) <
            1e-8 * steady.point.load.scale());
      CHECK(std::abs(s.flight[k] - (s.position.q[k] - free[k])) < 1e-15 * std::abs(free[k]));
      off = std::max(off, std::abs(s.position.q[k] - free[k]));
    }
    CHECK(off < farther);
    farther = off;
  }
  CHECK(farther < 1e-8);  // of 3 um: squeezed at 0.03 m/s the film pushes with some 1e5 N
}

TEST_CASE("SurfacesThatTouchAtTheStartAreNamedNotSummedUp", "[refusal]") {
  Case c = plain_case();
  c.operation.position = EccentricityGiven{0.9, 20.0 * kDegree, 270.0 * kDegree};
  c.operation.alignment = TiltGiven{1e-3, 0.0};  // 12.5 um at the edge, 3 um are left
  const Result r = solve(c);
  CHECK(r.verdict.status == Status::no_steady_state);
  CHECK(r.quantities.empty());
}

TEST_CASE("ContactOfAGapThatIsNoNumberIsNoNumber") {
  const solid::RoughSurface shell{0.34e-6, 12, 0.28e-6, 0.39e-6};
  const solid::AsperityContact contact(shell, shell, {0.001, 53.3e9, 0.02});
  const double none = std::nan("");
  CHECK(std::isnan(contact.at(none).p));
}
