// Load cycles at their hardest: found and audited, or refused with when and where.
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "tests/bearing/rubbing_cases.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// A bearing with a groove; loads come over two turns.
Case cycled_case(double mass) {
  Case c = plain_case();
  c.supplies[0].pressure = 2e5;
  c.supplies[0].arc = 20.0 * kDegree;
  c.supplies[0].length = 0.02;
  c.cycle = LoadCycle{};
  c.cycle->crank_speed = c.operation.omega;
  c.cycle->period = 4.0 * kPi / c.operation.omega;
  c.cycle->journal_mass = mass;
  return c;
}

/// Rows of crank angle [deg], load along X and Y [N].
void set_rows(Case& c, const std::vector<std::array<double, 3>>& rows) {
  for (const auto& [angle, x, y] : rows) {
    c.cycle->t.push_back(angle * kDegree / c.operation.omega);
    c.cycle->x.push_back(x);
    c.cycle->y.push_back(y);
  }
}

/// From 500 N to `load` [N] within a degree, and down again over a quarter turn.
void set_impact(Case& c, double load) {
  set_rows(c,
           {{0.0, 0.0, -500.0}, {360.0, 0.0, -500.0}, {361.0, 0.0, -load}, {450.0, 0.0, -500.0}});
}

/// Oil, impulse and load are balanced, and the film is one.
void check_audits(const CycleResult& r) {
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  CHECK(r.audit.mass < 1e-10);    // carried as what flows
  CHECK(r.audit.content < 1e-4);  // the film's residual over a step
  CHECK(r.audit.impulse <
        1e-5);  // steps end on the corners of the load; a hundredth of their error
  CHECK(r.audit.load < 1e-4);
  CHECK(value_of(r, "h_min") > 0.0);
  CHECK(std::isfinite(value_of(r, "friction_torque")));
}

/// The rig's oil and surfaces in a slow bearing of 120 mm whose load and speed swing over eighteen
/// turns: 14 +- 6.7 kN, 669 +- 315 rpm.
Case wandering_case() {
  constexpr double kPeriod = 1.61956225;  // [s]
  Case c = rig_case();
  c.bearing = {0.06, 0.075, 40e-6, 333.15, {}};
  c.supplies[0].diameter = 9.6e-3;
  c.supplies[0].pressure = 2e5;
  c.supplies[0].temperature = 313.15;
  c.operation.omega = 668.83 * kPi / 30.0;
  c.shell->housing = Housing{steel(), 0.096, HousingSupport::held};
  c.shell->back = ConvectiveBack{100.0, 333.15};
  c.shaft = Shaft{steel(), 0.06, 100.0, 333.15};
  c.model.grid = {48, 7};
  c.cycle = LoadCycle{};
  c.cycle->period = kPeriod;
  for (int k = 0; k < 24; ++k) {
    const double angle = 2.0 * kPi * k / 24.0;
    c.cycle->t.push_back(kPeriod * k / 24.0);
    c.cycle->x.push_back(0.0);
    c.cycle->y.push_back(-13966.24 + 2032.45 * std::cos(angle) - 6362.37 * std::sin(angle));
    c.cycle->omega.push_back(c.operation.omega * (1.0 + 0.47066 * std::sin(angle)));
  }
  return c;
}

/// Not found between two crank angles [deg], for this reason; what came before is a film.
void check_refusal(const CycleResult& r, double from, double to, const std::string& why) {
  INFO(app::reason_of(r.verdict));
  CHECK_FALSE(r.verdict.good());
  const auto* at = r.verdict.as<ending::NoStep>();
  REQUIRE(at != nullptr);
  const double angle = at->t * at->crank_speed / kDegree;
  CHECK(angle >= from);
  CHECK(angle <= to);
  CHECK(app::reason_of(r.verdict).find(why) != std::string::npos);
  CHECK(std::isfinite(r.verdict.place.phi));
  REQUIRE(r.instants.size() > 2);
  for (const CycleInstant& i : r.instants) CHECK(i.h_min > 2e-9);
}

}  // namespace

TEST_CASE("AnImpactWithinADegreeIsCarriedByAnyJournal", "[cycle]") {
  std::vector<double> h_min;
  for (const double mass : {0.0, 0.01, 1000.0}) {  // [kg]
    Case c = cycled_case(mass);
    set_impact(c, 20e3);
    const CycleResult r = solve_cycle(c, Tier::isothermal);
    INFO(mass << " kg");
    check_audits(r);
    // Periodic: the film carries the mean load, the journal's momentum is what it was.
    const double gained = mass * std::hypot(r.instants.back().vx - r.instants.front().vx,
                                            r.instants.back().vy - r.instants.front().vy);
    CHECK(gained <= kClosed * cycle_numbers(*c.cycle, c.operation.omega).mean * r.period);
    h_min.push_back(value_of(r, "h_min"));
  }
  // 10 g that go the clearance within the degree: 40 N of 20 kN.
  CHECK(h_min[1] == Approx(h_min[0]).epsilon(2e-3));
}

TEST_CASE("AnImpactThatNoFilmCarriesIsRefusedWithWhenAndWhere", "[cycle]") {
  for (const double mass : {0.0, 0.01, 1000.0}) {  // [kg]
    INFO(mass << " kg");
    // Rigid surfaces and Barus oil: the reduced pressure is below 1/alpha on the bearing's half,
    // whatever squeezes the film; below 2 R B/alpha = 62.5 kN.
    Case c = cycled_case(mass);
    set_impact(c, 100e3);
    c.oil.pressure = rheology::Barus{2e-8};
    check_refusal(solve_cycle(c, Tier::isothermal), 360.0, 370.0, "reduced pressure");
    // Smooth surfaces and 2 MN, long enough to squeeze the film out.
    c = cycled_case(mass);
    set_impact(c, 2e6);
    check_refusal(solve_cycle(c, Tier::isothermal), 361.0, 450.0, "less than a molecule");
  }
}

TEST_CASE("ElasticSurfacesCarryAPeakOf160KiloNewtons", "[cycle]") {
  // 195 MPa on the projected area.
  Case c = rig_case();
  c.model.grid = {40, 5};
  c.model.tolerance = 0.03;
  c.model.switches.elastic_deformation = true;
  c.supplies[0].pressure = 2e5;
  c.cycle = LoadCycle{};
  c.cycle->crank_speed = c.operation.omega;
  c.cycle->period = 4.0 * kPi / c.operation.omega;
  c.cycle->journal_mass = 1.0;
  set_rows(c, {{0.0, 0.0, -4e3}, {340.0, 0.0, -4e3}, {370.0, 0.0, -160e3}, {430.0, 0.0, -4e3}});
  const CycleResult r = solve_cycle(c, Tier::isothermal);
  check_audits(r);
  CHECK(value_of(r, "p_max") > 160e3 / (2.0 * c.bearing.radius * c.bearing.width));
}

TEST_CASE("WhatCyclesLeadToIsLeftWhereNoFilmTakesAStepFromIt", "[hard_cycle]") {
  // The orbit of a journal that weighs next to nothing beside its load is that of one without mass.
  const CycleResult heavy = solve_cycle(to_and_fro_case(5.0), Tier::isothermal);
  const CycleResult light = solve_cycle(to_and_fro_case(0.0), Tier::isothermal);
  check_audits(heavy);
  check_audits(light);
  CHECK(value_of(heavy, "h_min") == Approx(value_of(light, "h_min")).epsilon(5e-3));
  CHECK(value_of(heavy, "power_loss") == Approx(value_of(light, "power_loss")).epsilon(5e-3));
  // Its mean torque is next to nothing, which is told; that of a journal that turns one way is not.
  const auto told = [](const CycleResult& r) {
    return std::count_if(r.assumptions.begin(), r.assumptions.end(), [](const Note& n) {
      const auto* plain = std::get_if<note::Plain>(&n);
      return plain != nullptr && *plain == note::Plain::torque_both_ways;
    });
  };
  CHECK(told(heavy) == 1);
  CHECK(told(solve_cycle(rubbing_case(false), Tier::isothermal)) == 0);
}

TEST_CASE("ACycleWithHeatMayBeginWhereSummitsRub", "[hard_cycle]") {
  const CycleResult peak = solve_cycle(rubbing_case(true), Tier::thd);
  const CycleResult lull = solve_cycle(rubbing_case(false), Tier::thd);
  for (const CycleResult* r : {&peak, &lull}) {
    INFO(app::reason_of(r->verdict));
    REQUIRE(r->verdict.good());
    CHECK(r->audit.mass < 1e-10);
    CHECK(r->audit.energy < 1e-8);
  }
  // Steps fall on other instants; walls are within a tenth of a kelvin.
  CHECK(value_of(peak, "friction_torque") ==
        Approx(value_of(lull, "friction_torque")).epsilon(0.01));
  CHECK(value_of(peak, "h_min") == Approx(value_of(lull, "h_min")).epsilon(0.01));
  CHECK(value_of(peak, "T_film_max") == Approx(value_of(lull, "T_film_max")).margin(0.3));
}

TEST_CASE("CyclesThatDoNotRepeatWithinTheirBarsAreTold", "[hard_cycle]") {
  // Its fronts of oil come back a little otherwise each time: two cycles differ by 3e-4 for ever.
  // Less than a step may err, and they go no farther apart.
  const Case c = wandering_case();
  const CycleResult r = solve_cycle(c, Tier::tehd);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  CHECK(r.cycles < kMostCycles / 2);
  CHECK(r.closure < 0.1 * c.model.tolerance);
  const bool told = std::any_of(r.warnings.begin(), r.warnings.end(), [](const Note& n) {
    return std::holds_alternative<note::CyclesWander>(n);
  });
  CHECK(told == (r.closure > kClosed));
  CHECK(r.audit.mass < 1e-10);
  CHECK(r.audit.walls < 0.1);
}
