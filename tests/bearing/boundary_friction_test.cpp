// A friction law of the contact in a bearing: parts, torque, heat and starts.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/steady/audit.hpp"
#include "bearing/steady/solve.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// The rig in mixed friction, slowly turned.
Case mixed(Tier tier) {
  Case c = rig_case();
  c.model.tier = tier;
  c.model.grid = {60, 7};
  c.operation.omega = 300.0 * kPi / 30.0;
  return c;
}

Case with_law(Case c) {
  solid::GenericFriction f;
  f.abrasive = 0.005;
  f.adhesive = 0.05;
  f.a = 10.0;
  f.b = 300.0;
  f.c = 3000.0;
  f.summit_radius = 10e-6;
  c.surfaces.contact->friction = 0.0;
  c.surfaces.contact->friction_law = f;
  return c;
}

Solution good(const Case& c) {
  Solution s = solve_tier(c, c.model.tier);
  INFO(app::reason_of(s.verdict));
  REQUIRE(s.verdict.good());
  return s;
}

}  // namespace

TEST_CASE("PartsOfBoundaryFrictionAddUpToTheAsperityTorque", "[boundary_friction]") {
  const Result r = summarize(good(with_law(mixed(Tier::isothermal))), Tier::isothermal);
  const Quantities q = r.values();
  REQUIRE(q.friction_torque_asperity > 0.01);
  const double parts = q.friction_torque_abrasive + q.friction_torque_adhesive +
                       q.friction_torque_micro_hydrodynamic;
  CHECK(parts == Approx(q.friction_torque_asperity).epsilon(1e-12));  // round-off
  for (const double part : {q.friction_torque_abrasive, q.friction_torque_adhesive,
                            q.friction_torque_micro_hydrodynamic}) {
    CHECK(part > 0.0);
  }
  CHECK(q.mu_abrasive == Approx(0.005).epsilon(1e-9));
  CHECK(q.mu_adhesive < 0.05);  // less than at rest
  CHECK(q.mu_abrasive / q.friction_torque_abrasive ==
        Approx(q.mu_adhesive / q.friction_torque_adhesive).epsilon(1e-12));
  CHECK(r.fields.tau_adhesive.size() == r.fields.p.size());
}

TEST_CASE("CoefficientsOfBoundaryFrictionDoNotKnowTheSenseOfRotation", "[boundary_friction]") {
  Case c = with_law(mixed(Tier::isothermal));
  const Quantities one = summarize(good(c), Tier::isothermal).values();
  c.operation.omega *= -1.0;
  const Quantities two = summarize(good(c), Tier::isothermal).values();
  CHECK(two.friction_torque_abrasive == Approx(-one.friction_torque_abrasive).epsilon(1e-6));
  CHECK(two.mu_abrasive == Approx(one.mu_abrasive).epsilon(1e-6));
  CHECK(two.mu_adhesive == Approx(one.mu_adhesive).epsilon(1e-6));
  CHECK(one.mu_adhesive > 0.0);
}

TEST_CASE("WithoutALawThePartsAreNotTold", "[boundary_friction]") {
  const Result r = summarize(good(mixed(Tier::isothermal)), Tier::isothermal);
  CHECK_FALSE(r.has("mu_adhesive"));
  CHECK(r.fields.tau_adhesive.empty());
}

TEST_CASE("AConstantIsTheLawOfAbrasionAloneInAWarmBearing", "[boundary_friction]") {
  const Case constant = mixed(Tier::tehd);
  Case law = constant;
  solid::GenericFriction alone;
  alone.abrasive = constant.surfaces.contact->friction;
  alone.summit_radius = 10e-6;
  law.surfaces.contact->friction_law = alone;
  CHECK(torque_of(good(law)) == torque_of(good(constant)));  // the same arithmetic
}

TEST_CASE("EnergyClosesWithALawInTehd", "[boundary_friction]") {
  const Solution s = good(with_law(mixed(Tier::tehd)));
  const Friction f = friction_of(s.model, s.point, s.film);
  REQUIRE(f.asperity > 0.1 * f.torque());
  CHECK(audit_of(s, f).energy < 1e-6);  // as of other bearings with constant friction
  const double heat = f.asperity * s.model.input.operation.omega;
  CHECK(s.heat.contact_heat == Approx(heat).epsilon(1e-6));  // the film's tolerance
}

TEST_CASE("TheViscosityOfTheLawIsThatOfItsPlace", "[boundary_friction]") {
  const Solution s = good(with_law(mixed(Tier::tehd)));
  const AsperityStress tau = asperity_stress(s.model, s.point, s.film);
  const auto& law = *s.model.input.surfaces.contact->friction_law;
  const solid::BoundaryFriction& f = s.model.contact->friction();
  int pressed = 0;
  for (std::size_t c = 0; c < s.film.p_contact.size(); ++c) {
    const double p = s.film.p_contact[c];
    if (p < 1e5) continue;
    ++pressed;
    const double L_N = s.point.scene.speed / (s.film.columns.g0[c] * p * f.L_s());
    const double adhesive = law.adhesive * std::pow(law.a, -std::sqrt(law.b * L_N));
    CHECK(tau.adhesive[c] == Approx(p * adhesive).epsilon(1e-12));
  }
  CHECK(pressed > 5);
}

TEST_CASE("ABearingAtRestBreaksAwayWithAbrasionAndAdhesion", "[boundary_friction]") {
  Case c = with_law(rig_case());
  c.model.grid = {60, 7};
  LoadCycle event;
  event.t = {0.0, 0.2, 0.3};
  event.x.assign(3, 0.0);
  event.y.assign(3, -2.5e3);
  event.omega = {0.0, 0.0, 0.2};
  event.journal_mass = 5.0;
  c.cycle = event;
  c.operation.position = LoadGiven{2.5e3, 270.0 * kDegree};
  const CycleResult r = solve_cycle(c, Tier::isothermal);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  const CycleInstant& first = r.instants.front();
  const double arm = c.bearing.radius;
  CHECK(first.breakaway > 0.055 * 2.5e3 * arm);
  CHECK(first.breakaway < 4.0 / kPi * 0.055 * 2.5e3 * arm);  // as in start_stop_test.cpp
  const CycleInstant& last = r.instants.back();
  CHECK(last.torque_abrasive + last.torque_adhesive + last.torque_micro_hydrodynamic ==
        Approx(last.torque_asperity).epsilon(1e-12));
  CHECK(value_of(r, "friction_torque_adhesive") > 0.0);
}
