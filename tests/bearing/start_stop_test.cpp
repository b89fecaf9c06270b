// From rest in contact to a full film and back, and through zero speed.
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/steady/audit.hpp"
#include "core/constants.hpp"
#include "solid/boundary_friction.hpp"
#include "tests/bearing/solved.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

constexpr double kLoad = 2.5e3;  ///< [N]
constexpr double kTop = 260.0 * kPi / 30.0;

/// At rest under the load for half a second, then to `top` within three seconds and back.
Case starting(double top) {
  Case c = rig_case();
  c.model.grid = {60, 7};
  soften_edges(c);
  c.model.switches.elastic_deformation = true;
  LoadCycle event;
  event.t = {0.0, 0.5, 3.5, 6.5, 7.0};
  event.x.assign(5, 0.0);
  event.y.assign(5, -kLoad);
  event.omega = {0.0, 0.0, top, 0.0, 0.0};
  event.journal_mass = 5.0;
  c.cycle = event;
  c.operation.position = LoadGiven{kLoad, 270.0 * kDegree};
  return c;
}

}  // namespace

TEST_CASE("BoundaryFrictionIsSmoothThroughZeroAndWholeWhereSurfacesSlide", "[start_stop]") {
  const Case c = rig_case();
  const solid::BoundaryFriction law(*c.surfaces.contact, 0.3e-6);
  const auto friction = [&](double du) { return law.per_pressure({1e6, 1e-3, 0.01, du}); };
  CHECK(friction(0.0) == 0.0);
  for (const double v : {1e-5, 1e-3, 0.05}) CHECK(friction(-v) == -friction(v));
  CHECK(friction(0.05) == Approx(law.at_rest()).epsilon(1e-12));
  const double slope = friction(1e-8) / 1e-8;
  CHECK(slope == Approx(law.at_rest() / solid::BoundaryFriction::kMicroSlip).epsilon(1e-6));
}

TEST_CASE("AtRestTheContactAloneCarriesTheLoad", "[start_stop]") {
  const double arm = rig_case().bearing.radius;
  std::vector<double> breakaway;
  for (const double sigma : {0.28e-6, 0.23e-6}) {  // new, worn
    Case c = starting(kTop);
    c.surfaces.shell.summit_roughness = sigma;
    c.surfaces.shell.summit_height = sigma > 0.25e-6 ? 0.39e-6 : 0.19e-6;
    const CycleResult r = converged(c);
    const CycleInstant& first = r.instants.front();
    CHECK(first.torque == Approx(0.0).margin(1e-9));
    CHECK(first.p_max <= c.supplies[0].pressure * (1.0 + 1e-9));  // the film carries nothing
    CHECK(first.p_asperity_max > 1e6);
    // mu F R, and more as pressures beside the load line do not point along it: 4/pi at most of a
    // cosine over half the shell
    CHECK(first.breakaway > 0.02 * kLoad * arm);
    CHECK(first.breakaway < 4.0 / kPi * 0.02 * kLoad * arm);
    breakaway.push_back(value_of(r, "breakaway_torque"));
    double start = 0.0;
    for (const CycleInstant& i : r.instants) {
      if (i.t > 0.5 && i.t < 0.6) start = std::max(start, i.torque);
    }
    CHECK(start == Approx(breakaway.back()).epsilon(0.05));
    CHECK(value_of(r, "lift_off_speed") < kTop);
  }
  // the sum of the contact is the load; how it is spread around moves it a little
  CHECK(breakaway[1] == Approx(breakaway[0]).epsilon(2e-3));
}

TEST_CASE("WhereHeatHasChangedTheGapAJournalAtRestStillRests", "[start_stop]") {
  // The walls are as warm as the supply: where the clearance is that of another temperature the gap
  // is not as given. Contact carries the load from the first instant on, and goes on to.
  for (const double reference : {293.15, 403.15}) {
    for (const Tier tier : {Tier::thd, Tier::tehd}) {
      Case c = starting(kTop);
      c.model.grid = {48, 7};
      c.model.tier = tier;
      c.model.switches.elastic_deformation = tier == Tier::tehd;
      c.model.switches.thermal_deformation = true;
      c.bearing.reference_temperature = reference;
      if (reference < 300.0) c.bearing.radial_clearance = 30e-6;  // of it 16 um close
      // Up to a sixth of the speed: rigid walls that rub and grow where they do end rubbing on.
      c.cycle->t = {0.0, 0.5, 1.0};
      c.cycle->omega = {0.0, 0.0, kTop / 6.0};
      for (auto* load : {&c.cycle->x, &c.cycle->y}) load->resize(3);
      const CycleResult r = converged(c, tier);
      const double whole = 0.02 * kLoad * c.bearing.radius;  // see above
      for (const CycleInstant& i : r.instants) {
        if (i.t > 0.5) break;
        CHECK(i.breakaway > whole);
        CHECK(i.breakaway < 4.0 / kPi * whole);
      }
    }
  }
}

TEST_CASE("TheBreakawayTorqueIsTheCoefficientTimesTheSumOfTheContact", "[start_stop]") {
  Case c = starting(kTop);
  // Without any pressure nothing flows in the end: the film is solved to the round-off of its oil.
  c.supplies[0].pressure = GENERATE(1e5, 0.0);
  LoadCycle rest = *c.cycle;
  rest.t = {0.0, 0.1};
  rest.x.assign(2, 0.0);
  rest.y.assign(2, -kLoad);
  rest.omega = {0.0, 0.0};
  const LoadCycle start = std::exchange(*c.cycle, rest);
  const CycleResult at_rest = converged(c);
  const FilmGrid& g = at_rest.fields.grid;
  double contact = 0.0;  // nothing moves: the largest pressures are those of every instant [N]
  double carried = 0.0;  // [N]
  for (int k = 0; k < g.cells(); ++k) {
    const double force = at_rest.fields.p_asperity_max[k] * g.area(k);
    contact += force;
    carried -= force * std::sin(g.phi[k / g.nz]);
  }
  // The film carries nothing but what the supply's pressure presses upon.
  CHECK(carried == Approx(kLoad).epsilon(0.01));
  const double wanted = c.surfaces.contact->friction * contact * c.bearing.radius;
  CHECK(value_of(at_rest, "breakaway_torque") == Approx(wanted).epsilon(1e-9));
  c.cycle = start;
  const CycleResult r = converged(c);
  const auto most = [&](double from, double to) {
    double torque = 0.0;
    for (const CycleInstant& i : r.instants) {
      if (i.t > from && i.t < to) torque = std::max(torque, i.torque);
    }
    return torque;
  };
  CHECK(most(0.5, 0.6) == Approx(wanted).epsilon(0.05));  // as it begins to turn
  // Run-down: asperities come back before the stop, while the surfaces still slide.
  const double slides = 6.5 - 3.0 * solid::BoundaryFriction::kSliding / (kTop * c.bearing.radius);
  double least = INFINITY;
  double at = 0.0;
  for (const CycleInstant& i : r.instants) {
    if (i.t > 3.5 && i.t < slides && i.torque < least) least = i.torque, at = i.t;
  }
  CHECK(at < 6.0);
  CHECK(most(at, slides) > 10.0 * least);
  CHECK(most(at, slides) < wanted);
}

TEST_CASE("StartingBackwardsIsTheMirrorImage", "[start_stop]") {
  const CycleResult forward = converged(starting(kTop));
  const CycleResult backward = converged(starting(-kTop));
  // the hole lies on the load line: the bearing is its own mirror image; both take their own steps
  CHECK(value_of(backward, "friction_torque") ==
        Approx(-value_of(forward, "friction_torque")).epsilon(1e-3));
  CHECK(value_of(backward, "h_min") == Approx(value_of(forward, "h_min")).epsilon(1e-3));
  CHECK(value_of(backward, "power_loss") == Approx(value_of(forward, "power_loss")).epsilon(1e-3));
}

TEST_CASE("AReversalTurnsTheFrictionWithoutAJump", "[start_stop]") {
  Case c = starting(kTop);
  c.cycle->t = {0.0, 1.0, 1.02};
  c.cycle->x.assign(3, 0.0);
  c.cycle->y.assign(3, -kLoad);
  c.cycle->omega = {1.0, 0.04, -0.04};  // 1 mm/s through zero in 20 ms
  const CycleResult r = converged(c);
  const double whole = 4.0 / kPi * 0.02 * kLoad * c.bearing.radius;
  double largest_jump = 0.0;
  for (std::size_t k = 1; k < r.instants.size(); ++k) {
    const auto& a = r.instants[k - 1];
    const auto& b = r.instants[k];
    CHECK(b.torque_asperity * b.omega >= 0.0);  // against the motion
    const double slip = std::abs(b.omega - a.omega) * c.bearing.radius;
    const double most = whole * slip / solid::BoundaryFriction::kMicroSlip;  // slope of tanh at 0
    largest_jump = std::max(largest_jump, std::abs(b.torque_asperity - a.torque_asperity) - most);
  }
  CHECK(largest_jump < 0.05 * whole);  // what else changes in a step: the contact itself
}

TEST_CASE("FrictionOfACreepingJournalIsThatOfItsSlip", "[start_stop]") {
  // All load is on the summits: T = T_slid tanh(U/v), whatever U below the speed at which they
  // slide (on the way iterates lie in each other, where oil that thins by shear has no stress).
  Case c = rig_case();
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {60, 9};
  set_load(c, 4e3);
  std::vector<double> slid;
  for (const double rpm : {0.02, 0.005, 1e-4}) {
    c.operation.omega = rpm * kPi / 30.0;
    const Solution s = solve_tier(c, Tier::isothermal);
    INFO(rpm << " rpm: " << app::reason_of(s.verdict));
    REQUIRE(s.verdict.good());
    const double U = c.operation.omega * c.bearing.radius;
    slid.push_back(friction_of(s.model, s.point, s.film).asperity /
                   std::tanh(U / solid::BoundaryFriction::kMicroSlip));
  }
  // the film of 0.02 rpm carries less than 1e-3 of the load
  for (const double T : slid) CHECK(T == Approx(slid.back()).epsilon(1e-3));
}

TEST_CASE("TheHeatOfACreepingJournalIsAuditedByWhatPasses", "[start_stop]") {
  // 5 W of supply and cooling pass, friction makes 3e-11 W: less than the round-off of what passes.
  Case c = rig_case();
  c.model.grid = {48, 9};
  set_load(c, 2e3);
  c.operation.omega = 1e-5 * kPi / 30.0;
  const Solution s = solve_tier(c, Tier::tehd);
  INFO(app::reason_of(s.verdict));
  REQUIRE(s.verdict.good());
  // sums of some 1e4 terms err by 1e-10 of what passes, and 1e-7 of it is the measure
  CHECK(audit_of(s, friction_of(s.model, s.point, s.film)).energy < 0.01);
}

TEST_CASE("ContactThatIsHeldAtTheHardnessIsToldOverACycle", "[start_stop]") {
  Case c = starting(kTop);
  const CycleResult elastic = converged(c);
  const double most = value_of(elastic, "p_asperity_max");
  const auto told = [](const CycleResult& r) {
    for (const Note& w : r.warnings) {
      if (std::holds_alternative<note::HeldAtHardness>(w)) return true;
    }
    return false;
  };
  CHECK_FALSE(told(elastic));
  c.surfaces.contact->hardness = 0.8 * most;
  const CycleResult flowing = converged(c);
  CHECK(value_of(flowing, "p_asperity_max") == Approx(0.8 * most).epsilon(1e-12));
  CHECK(told(flowing));
  REQUIRE(!flowing.limiters.empty());
  CHECK(flowing.limiters.back().count > 0);
  // the contact carries the load at rest, flowing or not: a wider patch under less pressure
  CHECK(value_of(flowing, "breakaway_torque") ==
        Approx(value_of(elastic, "breakaway_torque")).epsilon(0.02));
}

TEST_CASE("FrictionNearRestIsIntegratedAsItTurns", "[start_stop]") {
  // Nothing moves the film while friction turns from mu p tanh 0 to mu p tanh 3, so that steps were
  // long there and took half of it: the mean was 0.7 % off at every tolerance.
  Case c = starting(kTop);
  c.model.grid = {36, 5};
  c.model.tolerance = 0.01;
  const CycleResult chosen = converged(c);
  c.cycle->step = 4e-3;  // steps end in between where the speed is low
  const CycleResult fine = converged(c);
  CHECK(value(chosen, "friction_torque") ==
        Approx(value(fine, "friction_torque")).epsilon(2e-3));  // a fifth of the tolerance
}
