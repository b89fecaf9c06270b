/// Heat balances of the whole bearing: every root is found, the lowest stable one is the solution.
#include "bearing/steady/lumped.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "rheology/heat.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// Temperature that the heat of the isothermal film at T would give the oil, minus T [K].
double residual_at(const Case& c, double T) {
  const Solution s = solve_isothermal_at(c, T);
  INFO(app::reason_of(s.verdict));
  REQUIRE(s.verdict.good());
  const double T_supply = c.supplies[0].temperature;
  const double power =
      std::abs(torque_of(s) * c.operation.omega) + pump_power(s.model, s.point, s.film);
  const double flow = fluid::oil_flows(s.point.scene, s.film.flow).side;
  return T_supply + power / (flow * rheology::heat_capacity(c.oil, 0.5 * (T + T_supply)).cp) - T;
}

/// A bearing whose cold oil would heat itself by more than 400 K, as thick oil at speed does.
Case thick_case(double eta) {
  Case c = warm_case();
  c.oil.temperature = rheology::ReynoldsSlope{eta, 313.15, 0.05};
  return c;
}

}  // namespace

TEST_CASE("OilThatWouldBoilWhileColdThinsUntilItsHeatLeaves", "[lumped]") {
  // The first step of a secant from the supply's temperature leads 400 K and more beyond it here.
  double before = 0.0;
  for (const double eta : {0.3, 1.0, 3.0, 10.0}) {
    const Case c = thick_case(eta);
    INFO("eta " << eta);
    CHECK(residual_at(c, c.supplies[0].temperature) > 400.0);
    const Solution s = solve_tier(c, Tier::lumped);
    INFO(app::reason_of(s.verdict));
    REQUIRE(s.verdict.good());
    REQUIRE(s.heat_roots.size() == 1);
    CHECK(s.heat_roots.front().stable());
    CHECK(s.heat_roots.front().T == s.T_film);
    // The isothermal film there is solved to 1e-9 of its load.
    CHECK(std::abs(residual_at(c, s.T_film)) < 1e-5);
    CHECK(s.T_film > before);  // thicker oil ends hotter
    before = s.T_film;
  }
}

TEST_CASE("ARingThatFeedsNothingIsNamed", "[lumped]") {
  // At ambient pressure all round no oil is driven to the sides but by the film itself.
  Case c = warm_case();
  c.supplies.resize(1);
  c.supplies[0].kind = SupplyKind::circumferential_groove;
  c.supplies[0].angle = 0.0;
  c.supplies[0].z = 0.0;
  c.supplies[0].arc = 2.0 * kPi;
  c.supplies[0].length = 0.2 * c.bearing.width;
  c.supplies[0].pressure = 0.0;
  for (const double ratio : {0.1, 0.5, 0.8}) {
    place_journal(c, ratio, 1.0);
    const Solution s = solve_tier(c, Tier::lumped);
    INFO(ratio << ": " << app::reason_of(s.verdict));
    if (s.verdict.good()) continue;  // some oil is drawn in
    CHECK(app::reason_of(s.verdict).find("nan") == std::string::npos);
    CHECK(s.verdict.as<ending::Plain>() != nullptr);
  }
}

TEST_CASE("OilOfEverySupplyIsAsWarmAsItComes", "[lumped]") {
  // Two grooves, of 30 and 90 degrees: P = sum cp Q_i (T - T_i), whichever stands first.
  Case c = warm_case();
  c.supplies[0].angle = 0.0;
  c.supplies[0].temperature = 303.15;
  c.supplies.push_back(c.supplies[0]);
  c.supplies[1].angle = 180.0 * kDegree;
  c.supplies[1].temperature = 363.15;
  c.model.tier = Tier::lumped;
  const Solution s = solve_tier(c, Tier::lumped);
  INFO(app::reason_of(s.verdict));
  REQUIRE(s.verdict.good());
  const double power =
      std::abs(torque_of(s) * c.operation.omega) + pump_power(s.model, s.point, s.film);
  const auto flows = fluid::oil_flows(s.point.scene, s.film.flow).patch;
  REQUIRE(std::min(flows[0], flows[1]) > 0.0);
  double heat = 0.0;
  for (int k = 0; k < 2; ++k) {
    const double cp = rheology::heat_capacity(c.oil, s.T_film).cp;  // the same at all temperatures
    heat += flows[k] * cp * (s.T_film - c.supplies[k].temperature);
  }
  CHECK(heat == Approx(power).epsilon(1e-6));  // 1e-7 K of the balance
  std::swap(c.supplies[0], c.supplies[1]);
  CHECK(solve_tier(c, Tier::lumped).T_film == Approx(s.T_film).epsilon(1e-9));
}

TEST_CASE("TheResidualOfARigidFilmFallsWithTemperature", "[lumped]") {
  // At a given position pressure and friction go with the viscosity; flow by rotation does not
  // depend on it and flow by supply pressure rises as it falls.
  Case c = warm_case();
  place_journal(c, 0.7, 0.6);
  double before = INFINITY;
  for (const double T : {313.15, 333.15, 363.15, 403.15, 453.15}) {
    const double r = residual_at(c, T);
    CHECK(r < before);
    before = r;
  }
  CHECK(before < 0.0);
  const Solution s = solve_tier(c, Tier::lumped);
  REQUIRE(s.verdict.good());
  CHECK(s.heat_roots.size() == 1);
}

TEST_CASE("ABalanceWithoutARootIsRefusedWithBothEnds", "[lumped]") {
  Case c = plain_case();  // no heat capacity to speak of, and a viscosity that heat does not change
  c.oil.heat_capacity = rheology::ConstantHeatCapacity{2.0};
  const Solution s = solve_tier(c, Tier::lumped);
  INFO(app::reason_of(s.verdict));
  CHECK(s.verdict.status == Status::no_steady_state);
  const auto* e = s.verdict.as<ending::NoHeatBalance>();
  REQUIRE(e != nullptr);
  CHECK(e->T_low == Approx(313.15));
  CHECK(e->T_high == Approx(313.15 + 400.0));
  CHECK(e->surplus_low > 0.0);  // more heat than leaves, at both ends
  CHECK(e->surplus_high > 0.0);
  CHECK(std::isinf(e->T_none));  // a film at every temperature
  CHECK(s.heat_roots.empty());
  CHECK(s.T_film <= 313.15 + 400.0);
}

TEST_CASE("OilSuckedThroughTheBearingIsNoRunaway", "[lumped]") {
  // A groove below ambient takes the oil that comes in at the sides: heat leaves there, which the
  // balance of one temperature does not know. Slow: more is sucked than dragged.
  Case c = warm_case();
  c.supplies[0].pressure = -3e4;
  c.model.cavitation_pressure = -9e4;
  c.model.grid = {36, 6};
  for (const double rpm : {1.0, 10.0, 100.0}) {
    c.operation.omega = rpm * kPi / 30.0;
    place_journal(c, 0.5, 0.8);
    const Solution s = solve_tier(c, Tier::lumped);
    INFO(rpm << " rpm: " << app::reason_of(s.verdict));
    CHECK(s.verdict.status != Status::no_steady_state);
  }
}

TEST_CASE("EveryRootIsToldAndTheLowestStableOneTaken", "[lumped]") {
  Case c = warm_case();  // oil that thickens with heat: beyond a second, unstable root it runs away
  c.oil.temperature = rheology::ReynoldsSlope{0.003, 313.15, -0.03};
  place_journal(c, 0.6, 0.7);
  const Solution s = solve_tier(c, Tier::lumped);
  INFO(app::reason_of(s.verdict));
  REQUIRE(s.verdict.good());
  REQUIRE(s.heat_roots.size() == 2);
  CHECK(s.heat_roots[0].stable());
  CHECK_FALSE(s.heat_roots[1].stable());
  CHECK(s.T_film == s.heat_roots[0].T);
  for (const HeatRoot& root : s.heat_roots) CHECK(std::abs(residual_at(c, root.T)) < 1e-5);
  CHECK(residual_at(c, s.heat_roots[1].T + 5.0) > 0.0);
  const Result r = summarize(s, Tier::lumped);
  CHECK(r.heat_roots.size() == 2);
  const auto told = std::find_if(r.warnings.begin(), r.warnings.end(), [](const Note& w) {
    return std::holds_alternative<note::OtherRoots>(w);
  });
  REQUIRE(told != r.warnings.end());
  const auto& roots = std::get<note::OtherRoots>(*told).roots;
  REQUIRE(roots.size() == 2);
  CHECK((roots[0].stable && roots[0].taken && !roots[1].stable && !roots[1].taken));
  CHECK(r.value("T_film_mean") == s.heat_roots[0].T);
}

TEST_CASE("AWarmStartFindsTheRootOfTheColdOne", "[lumped]") {
  // From a neighbour far hotter and far cooler: the root is where the balance is, not near them.
  const Solution cold = solve_tier(thick_case(1.0), Tier::lumped);
  REQUIRE(cold.verdict.good());
  for (const double eta : {0.01, 10.0}) {
    const Solution near = solve_tier(thick_case(eta), Tier::lumped);
    REQUIRE(near.verdict.good());
    const Solution s = solve_tier_from(thick_case(1.0), Tier::lumped, near);
    REQUIRE(s.verdict.good());
    CHECK(s.T_film == Approx(cold.T_film).margin(1e-5));  // both settled to 1e-7 K
  }
}

TEST_CASE("AWarmStartFollowsARootThatHardlyMoves", "[lumped]") {
  // So little that all films tried are within a thousandth of a kelvin: their slope is not to be
  // told from what each leaves open, and without one a root counted as unstable.
  Solution s = solve_tier(warm_case(), Tier::lumped);
  REQUIRE(s.verdict.good());
  REQUIRE(s.heat_roots.size() == 1);
  const double speed = s.model.input.operation.omega, T = s.T_film;
  for (const double change : {1e-7, 3e-7, 1e-6, 3e-6, 1e-5, 1e-4}) {
    s.model.input.operation.omega = speed * (1.0 + change);
    s.point = operating_point(s.model);
    const Verdict v = solve_lumped(s, true, {});
    INFO(change << ": " << app::reason_of(v));
    REQUIRE(v.good());
    CHECK(s.T_film == Approx(T).margin(1e-3 + 100.0 * change));
  }
}

TEST_CASE("ARootIsSettledThoughHotterFilmsCostMuch", "[lumped]") {
  // A jacked journal: films of hot oil, of micrometres and less, take more work than all before;
  // the grids agree on the root in 0.02 K.
  std::array<double, 2> T{};
  for (int k = 0; k < 2; ++k) {
    Case c = grooved_case();
    Supply jack = hole_case().supplies[0];
    jack.angle = 270.0 * kDegree;
    jack.diameter = 12e-3;
    jack.pressure = 10e5;
    c.supplies[0].length = 0.06;
    c.supplies.push_back(jack);
    c.operation.omega = 50.0 * kPi / 30.0;
    c.operation.position = LoadGiven{500.0, 270.0 * kDegree};
    c.model.tier = Tier::lumped;
    c.model.grid = k == 0 ? std::array{100, 13} : std::array{200, 25};
    const Solution s = solve_tier(c, Tier::lumped);
    CAPTURE(k);
    REQUIRE(s.verdict.good());
    T[k] = s.T_film;
  }
  CHECK(std::abs(T[0] - T[1]) < 0.02);
}
