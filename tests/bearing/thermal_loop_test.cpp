/// Film, shell and shaft exchanging heat: tier thd and the lumped balance.
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/steady/audit.hpp"
#include "rheology/heat.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Result told(const Case& c, Tier tier) {
  Result r = summarize(solve_tier(c, tier), tier);
  INFO(c.title << ": " << app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  return r;
}

double heat_left(const Result& r) {
  return r.value("heat_by_oil") + r.value("heat_to_shell") + r.value("heat_to_shaft");
}

}  // namespace

TEST_CASE("HeatGivenOffIsFrictionAndPumpPower", "[thermal_loop]") {
  for (const Case& c : {warm_case(), rig_case(), grooved_case()}) {
    for (const Tier tier : {Tier::thd, Tier::tehd}) {
      const Result r = told(c, tier);
      INFO(c.title << ' ' << to_string(tier));
      // The solids' heat differs from the film's by the walls' last change, 1e-3 K at most, on
      // about 40 W/K: 5e-4 of 80 W.
      CHECK(heat_left(r) == Approx(r.value("power_loss") + r.value("pump_power")).epsilon(5e-4));
      CHECK(r.value("power_loss") ==
            Approx(r.value("friction_torque") * c.operation.omega).epsilon(1e-12));
    }
  }
}

TEST_CASE("AuditsCloseAndMomentFallsWithTheGrid", "[thermal_loop]") {
  for (Case c : {rig_case(), grooved_case()}) {
    for (const Tier tier : {Tier::thd, Tier::tehd}) {
      double moment = INFINITY;
      for (const auto& grid : {std::array<int, 2>{100, 13}, {200, 25}}) {
        c.model.grid = grid;
        const Audit a = told(c, tier).audit;
        INFO(c.title << ' ' << to_string(tier) << ' ' << grid[0] << ": moment " << a.moment);
        CHECK(a.mass <= 1e-10);
        CHECK(a.energy <= 1e-8);
        CHECK(a.load <= 1e-8);
        CHECK(a.moment <= 1e-3);
        CHECK(a.moment < moment);
        moment = a.moment;
      }
    }
  }
}

TEST_CASE("HotSupplyLowersFriction", "[thermal_loop]") {
  double before = INFINITY;
  for (const double T : {303.15, 323.15, 343.15}) {
    Case c = warm_case();
    c.supplies[0].temperature = T;
    const Result r = told(c, Tier::thd);
    CHECK(r.value("friction_torque") < before);
    before = r.value("friction_torque");
  }
}

TEST_CASE("InsulatedBearingGivesItsHeatToTheOil", "[thermal_loop]") {
  Case c = warm_case();
  c.shell->back =
      ConvectiveBack{1e-6, 303.15};  // none at all is refused: no temperature of its own
  c.shell->end_heat_transfer = 0.0;
  c.shaft->heat_transfer = 0.0;
  const Result r = told(c, Tier::thd);
  const double power = r.value("power_loss") + r.value("pump_power");
  // What the walls still take is their last change, 1e-3 K at most, on about 40 W/K.
  CHECK(r.value("heat_by_oil") == Approx(power).epsilon(5e-4));
  CHECK(std::abs(r.value("heat_to_shell")) < 1e-5 * power);
  CHECK(std::abs(r.value("heat_to_shaft")) < 1e-5 * power);
}

TEST_CASE("OilOfConstantViscosityDoesNotFeelItsHeat", "[thermal_loop]") {
  Case c = warm_case();
  c.oil.temperature = rheology::ConstantViscosity{0.03};
  const Solution hot = solve_tier(c, Tier::thd);
  const Solution cold = solve_tier(c, Tier::isothermal);
  REQUIRE(hot.verdict.good());
  CHECK(torque_of(hot) == Approx(torque_of(cold)).epsilon(1e-8));  // load tolerance 1e-9
  CHECK(summarize(hot, Tier::thd).value("T_film_max") > 314.0);
}

TEST_CASE("BearingAtRestInTemperatureIsIsothermal", "[thermal_loop]") {
  Case c = warm_case();  // hardly any heat: 1 rad/s, everything around at the supply's temperature
  c.operation.omega = 1.0;
  set_load(c, 20.0);
  c.supplies[0].temperature = 313.15;
  c.shell->back = ConvectiveBack{200.0, 313.15};
  c.shaft->ambient = 313.15;
  const Solution s = solve_tier(c, Tier::thd);
  REQUIRE(s.verdict.good());
  for (const double T : s.film.columns.T) CHECK(std::abs(T - 313.15) < 0.05);  // Nahme number 1e-5
  CHECK(torque_of(s) == Approx(torque_of(solve_tier(c, Tier::isothermal))).epsilon(1e-3));
}

TEST_CASE("LumpedTemperatureClosesTheHeatBalance", "[thermal_loop]") {
  for (const Case& c : {warm_case(), rig_case(), grooved_case()}) {
    const Result r = told(c, Tier::lumped);
    const double rho =
        reference_density(make_bearing(c, physics_of(c, Tier::lumped), c.model.grid));
    const double T_supply = c.supplies[0].temperature;
    const double cp = rheology::heat_capacity(c.oil, T_supply).cp;
    const double carried = rho * r.value("side_flow") * cp * (r.value("T_film_mean") - T_supply);
    // settled to 1e-7 K of some K
    CHECK(carried == Approx(r.value("power_loss") + r.value("pump_power")).epsilon(1e-6));
  }
}

TEST_CASE("ReversedWarmJournalIsTheMirrorImage", "[thermal_loop]") {
  Case c = warm_case();
  c.supplies[0].angle = 60.0 * kDegree;
  const Result a = told(c, Tier::thd);
  c.operation.omega = -c.operation.omega;
  c.supplies[0].angle = 120.0 * kDegree;
  const Result b = told(c, Tier::thd);
  for (const char* name : {"power_loss", "h_min", "T_film_max", "T_shaft", "side_flow"}) {
    INFO(name);
    CHECK(a.value(name) == Approx(b.value(name)).epsilon(1e-5));  // fixed point to 1e-3 K
  }
}

TEST_CASE("SolvingAgainGivesTheSameDigits", "[thermal_loop]") {
  for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd}) {
    Case c = rig_case();
    c.model.grid = {48, 9};
    const Result a = told(c, tier);
    const Result b = told(c, tier);
    REQUIRE(a.quantities.size() == b.quantities.size());
    for (std::size_t k = 0; k < a.quantities.size(); ++k) {
      CHECK(a.quantities[k].value == b.quantities[k].value);
    }
    CHECK(a.fields.p == b.fields.p);
    CHECK(a.fields.T == b.fields.T);
  }
}

TEST_CASE("MoreNodesAcrossTheFilmConvergeOnTheSameFriction", "[thermal_loop]") {
  Case c = grooved_case();
  std::vector<double> torque;
  for (const int n : {5, 7, 9}) {
    c.model.film_nodes = n;
    torque.push_back(told(c, Tier::thd).value("friction_torque"));
  }
  CHECK(std::abs(torque[1] - torque[2]) < std::abs(torque[0] - torque[2]));
  CHECK(torque[0] == Approx(torque[2]).epsilon(5e-3));  // methods 0: 5 nodes by default
}

TEST_CASE("FiveNodesAcrossTheFilmSufficeBesideASupply", "[thermal_loop]") {
  // Refilling columns beside the groove: five nodes were 16 K and 5 K too hot there, in one node.
  struct Point {
    double load;  ///< [N]
    double rpm;
  };
  for (const Point& at : {Point{10e3, 3000.0}, Point{8e3, 1500.0}}) {
    for (const std::array<int, 2>& grid : {std::array{100, 13}, std::array{200, 25}}) {
      Case c = grooved_case();
      set_load(c, at.load);
      c.operation.omega = at.rpm * kPi / 30.0;
      c.model.grid = grid;
      c.model.film_nodes = 9;
      const double nine = told(c, Tier::thd).value("T_film_max");
      c.model.film_nodes = 5;
      const Result five = told(c, Tier::thd);
      INFO(at.load << " N, " << at.rpm << " rpm, " << grid[0] << " cells around");
      CHECK(std::abs(five.value("T_film_max") - nine) < 0.2);  // [K], of a rise of 8 to 16 K
      CHECK(std::any_of(five.limiters.begin(), five.limiters.end(),
                        [](const LimiterCount& l) { return l.what == Limiter::upwind_columns; }));
    }
  }
}

TEST_CASE("NoFilmIsColderThanAllAroundIt", "[thermal_loop]") {
  Case free = rig_case();  // slow, smooth, free to tilt: a film of 0.3 um between the walls
  free.operation.omega = 23.2;
  set_load(free, 12e3);
  free.supplies[0].temperature = 355.15;
  free.surfaces = {};
  free.operation.alignment = MomentGiven{};
  free.model.switches.elastic_deformation = true;
  free.model.grid = {104, 8};
  Case cooled = free;
  cooled.shaft->overhang = 0.05;
  cooled.shaft->heat_transfer = 100.0;
  for (const Case& c : {warm_case(), grooved_case(), rig_case(), free, cooled}) {
    const double coldest =
        std::min({c.supplies[0].temperature, std::get<ConvectiveBack>(c.shell->back).ambient,
                  c.shaft->ambient});
    const Solution s = solve_tier(c, Tier::thd);
    INFO(c.title << ": " << app::reason_of(s.verdict));
    REQUIRE(s.verdict.good());
    const auto [low, high] = std::minmax_element(s.film.columns.T.begin(), s.film.columns.T.end());
    CHECK(*low > coldest - 2.0);  // 2 K: what a polynomial of five nodes may swing below
    CHECK(*high < coldest + 100.0);
  }
}
