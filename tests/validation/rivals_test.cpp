// Methods that others use, on whole bearings: the same answer where the equations are the same,
// the loss where they are not, and a name for each failure.
#include "validation/rivals/rivals.hpp"

#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/steady/audit.hpp"
#include "core/contract.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;
using Catch::Matchers::Contains;

namespace {

Solution solved(Case c, const Methods& methods) {
  c.model.methods = methods;
  return solve_tier(validation::with_rivals(c), c.model.tier);
}

Case coarse(Case c) {
  c.model.grid = {60, 9};
  return c;
}

/// Both torques and smallest films agree to `tolerance`.
void check_same(const Solution& a, const Solution& b, double tolerance) {
  INFO(app::reason_of(a.verdict) << " | " << app::reason_of(b.verdict));
  REQUIRE(a.verdict.good());
  REQUIRE(b.verdict.good());
  CHECK(torque_of(b) == Approx(torque_of(a)).epsilon(tolerance));
  CHECK(b.film.least.h == Approx(a.film.least.h).epsilon(tolerance));
}

Methods cavitation(CavitationMethod m) {
  Methods methods;
  methods.cavitation = m;
  return methods;
}

Methods fixed_point(double relaxation = 0.0) {
  Methods methods;
  methods.elastic = ElasticMethod::fixed_point;
  methods.relaxation = relaxation;
  return methods;
}

/// A film of constant viscosity at 97 % of the clearance, load line downwards: speed [rpm],
/// attitude [deg].
Case in_a_given_gap(const Bearing& bearing, const Supply& supply, double rpm, double attitude,
                    double viscosity, std::array<int, 2> grid) {
  Case c = plain_case();
  c.bearing = bearing;
  c.supplies = {supply};
  c.operation.omega = rpm * kPi / 30.0;
  c.operation.position = EccentricityGiven{0.97, attitude * kDegree, 270.0 * kDegree};
  c.oil.temperature = rheology::ConstantViscosity{viscosity};
  c.model.tier = Tier::isothermal;
  c.model.grid = grid;
  return c;
}

}  // namespace

TEST_CASE("TheMethodAskedForIsTheOneThatRuns") {
  // On every grid of the sequence and under heat, not on the first grid alone.
  for (const Tier tier : {Tier::isothermal, Tier::thd}) {
    Case c = warm_case();
    c.model.tier = tier;
    c.model.grid = {100, 13};
    const Solution relaxed = solved(c, cavitation(CavitationMethod::p_theta));
    Case small = c;
    small.model.grid = {50, 7};
    const Solution first = solved(small, cavitation(CavitationMethod::p_theta));
    INFO(to_string(tier) << ": " << app::reason_of(relaxed.verdict));
    CHECK(relaxed.cost.sweeps > first.cost.sweeps);
    CHECK(relaxed.cost.factorizations == 0);
    CHECK(solved(c, {}).cost.sweeps == 0);
  }
  Case elastic = warm_case();
  elastic.model.tier = Tier::tehd;
  elastic.model.grid = {50, 7};
  CHECK(solved(elastic, fixed_point()).cost.elastic_rounds > 10);
  CHECK(solved(elastic, {}).cost.elastic_rounds == 0);
}

TEST_CASE("MassConservingMethodsCarryTheLoadInTheSameFilm") {
  for (const Case& c : {coarse(plain_case()), coarse(grooved_case())}) {
    Case isothermal = c;
    isothermal.model.tier = Tier::isothermal;
    const Solution usual = solved(isothermal, {});
    // load to 1e-9, film to 1e-11 of the flow: torque and gap to a few times that
    check_same(usual, solved(isothermal, cavitation(CavitationMethod::fischer_burmeister)), 1e-7);
    check_same(usual, solved(isothermal, cavitation(CavitationMethod::p_theta)), 1e-7);
  }
}

TEST_CASE("AFilmWhoseOnlySupplyNearlyChokesIsFound") {
  // A hole of 6 mm where the gap is a thirtieth of the clearance: on the way through time what it
  // feeds is a ten-thousandth of the flows.
  Supply hole;
  hole.angle = 270.0 * kDegree;
  hole.diameter = 6e-3;
  hole.pressure = 15e5;
  hole.temperature = 313.15;
  const Case c =
      in_a_given_gap({0.05, 0.06, 80e-6, 293.15, {}}, hole, 1500.0, 1.283, 0.0222, {100, 16});
  check_same(solved(c, {}), solved(c, cavitation(CavitationMethod::p_theta)), 1e-6);
}

TEST_CASE("AFilmWhoseCellsFillLineByLineIsFoundThoughItsResidualRises") {
  // A groove over the narrowest gap: the widest gap fills against the rotation, a line an
  // iteration, and its residual stands a hundred times higher until the last line is full.
  Supply groove;
  groove.kind = SupplyKind::axial_groove;
  groove.angle = 345.46 * kDegree;
  groove.arc = 20.0 * kDegree;
  groove.length = 0.056;
  groove.pressure = 3e5;
  groove.temperature = 313.15;
  const Case c =
      in_a_given_gap({0.04, 0.08, 80e-6, 293.15, {}}, groove, 4000.0, 83.88, 0.010, {120, 12});
  check_same(solved(c, {}), solved(c, cavitation(CavitationMethod::p_theta)), 1e-6);
}

TEST_CASE("RoughPiezoviscousThinningFilmIsTheSameByEveryMassConservingMethod") {
  Case c = coarse(rig_case());
  c.model.tier = Tier::isothermal;
  const Solution usual = solved(c, {});
  check_same(usual, solved(c, cavitation(CavitationMethod::fischer_burmeister)), 1e-7);
  check_same(usual, solved(c, cavitation(CavitationMethod::p_theta)), 1e-7);
}

TEST_CASE("TiltedJournalFindsItsMomentByEveryMethod") {
  Case c = coarse(plain_case());
  c.operation.alignment = MomentGiven{3.0, -2.0};
  const Solution usual = solved(c, {});
  for (const auto m : {CavitationMethod::fischer_burmeister, CavitationMethod::p_theta}) {
    const Solution other = solved(c, cavitation(m));
    check_same(usual, other, 1e-6);
    CHECK(other.film.position.psi_x() == Approx(usual.film.position.psi_x()).epsilon(1e-5));
  }
}

TEST_CASE("EveryMethodSeesTheSmoothBore") {
  // Edge relief and table of the bore were left out of the others' gap: 3.7 kN for 2.4.
  Case c = coarse(plain_case());
  c.bearing.edge_relief = EdgeOpening{0.3 * c.bearing.radial_clearance, 0.3 * c.bearing.width};
  const Solution usual = solved(c, {});
  for (const auto m : {CavitationMethod::fischer_burmeister, CavitationMethod::p_theta}) {
    check_same(usual, solved(c, cavitation(m)), 1e-6);
  }
  CHECK(torque_of(usual) != Approx(torque_of(solved(coarse(plain_case()), {}))).epsilon(0.01));
}

TEST_CASE("SwiftStieberCarriesTheLoadButItsMassAuditShowsTheOilMade") {
  Case c = coarse(grooved_case());
  c.model.tier = Tier::isothermal;
  const Solution s = solved(c, cavitation(CavitationMethod::swift_stieber));
  REQUIRE(s.verdict.good());
  const Audit audit = audit_of(s, friction_of(s.model, s.point, s.film));
  CHECK(audit.load < 1e-8);
  CHECK(audit.mass > 0.05);
  CHECK(audit_of(solved(c, {}), {}).mass < 1e-10);
}

TEST_CASE("SwiftStieberIsRefusedWhereHeatMustBeBalanced") {
  Case c = coarse(grooved_case());
  CHECK_THROWS_WITH(solved(c, cavitation(CavitationMethod::swift_stieber)),
                    Contains("does not conserve oil"));
}

TEST_CASE("ElasticNewtonIsRefusedToMethodsThatHaveNone") {
  Case c = coarse(rig_case());
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  CHECK_THROWS_WITH(solved(c, cavitation(CavitationMethod::p_theta)),
                    Contains("no Newton step for elastic bearings"));
}

TEST_CASE("HeatIsTheSameByEveryMassConservingMethod") {
  const Case c = coarse(grooved_case());
  const Solution usual = solved(c, {});
  for (const auto m : {CavitationMethod::fischer_burmeister, CavitationMethod::p_theta}) {
    check_same(usual, solved(c, cavitation(m)), 3e-5);  // the turns stop at 1e-4 of 10 K
  }
}

TEST_CASE("FixedPointAgreesWithNewtonForAStiffBearing") {
  Case c = coarse(rig_case());
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  const Solution newton = solved(c, {});
  check_same(newton, solved(c, fixed_point()), 1e-7);
  check_same(newton, solved(c, fixed_point(0.1)), 1e-6);
  Methods both = fixed_point();
  both.cavitation = CavitationMethod::fischer_burmeister;
  check_same(newton, solved(c, both), 1e-7);
}

TEST_CASE("FixedPointRefusesASoftBearingByNameWhereNewtonSolvesIt") {
  Case c = coarse(rig_case());
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  set_load(c, 80e3);
  CHECK(solved(c, {}).verdict.good());
  const Solution s = solved(c, fixed_point(0.5));
  CHECK(s.verdict.status == Status::iteration_limit);
  CHECK(
      (s.verdict.as<ending::FixedPointDiverged>() || s.verdict.as<ending::FixedPointUnsettled>()));
}

TEST_CASE("NothingStandsInWhereNewtonsMethodIsAskedFor") {
  Methods across;
  across.across = AcrossFilm::layers;
  CHECK(validation::rival_for({}) == nullptr);
  CHECK(validation::rival_for(across) == nullptr);
  CHECK(validation::rival_for(fixed_point()) != nullptr);
  CHECK(validation::rival_for(cavitation(CavitationMethod::p_theta)) != nullptr);
}

TEST_CASE("ARivalIsRefusedByNameWhereNothingStandsInForNewton") {
  Case c = coarse(plain_case());
  c.model.tier = Tier::isothermal;
  for (const Methods& m : {cavitation(CavitationMethod::fischer_burmeister), fixed_point()}) {
    c.model.methods = m;
    CHECK_THROWS_AS(solve_tier(c, c.model.tier), InputError);
    CHECK_THROWS_WITH(solve_tier(c, c.model.tier), Contains("the library has not"));
  }
}
