/// Heat between the oil of supplies and the walls of a bearing: balance, limits, cycles.
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/heat/film_heat.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/heat_in_time.hpp"
#include "bearing/over_time/warm_up.hpp"
#include "bearing/steady/audit.hpp"
#include "bearing/steady/solve.hpp"
#include "tests/bearing/solved.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// A bearing with a deep groove in hot walls.
Case groove_with(std::variant<double, ChannelHeat> heat) {
  Case c = grooved_case();
  c.model.grid = {60, 9};
  c.supplies[0].heat_transfer = heat;
  return c;
}

/// Heat from the groove's oil into shell and shaft [W], whole bearing.
double into_walls(const Solution& s) {
  const FilmGrid& g = s.model.domain.grid;
  double sum = 0.0;
  for (int c = 0; c < g.cells(); ++c) {
    const int patch = s.point.scene.supply.cell[c];
    if (patch < 0) continue;
    const double hA = supply_heat_transfer(s.model, patch) * g.area(c);
    sum += hA * (2.0 * s.heat.T_mix[patch] - s.heat.T_shell[c] - s.heat.T_shaft[c % g.nz]);
  }
  return g.multiplicity() * sum;
}

/// 1.5 kN downwards for two turns, as a cycle.
LoadCycle standing(const Case& c) {
  LoadCycle cycle;
  cycle.crank_speed = std::abs(c.operation.omega);
  cycle.period = 4.0 * kPi / cycle.crank_speed;
  for (int k = 0; k < 4; ++k) {
    cycle.t.push_back(cycle.period * k / 4);
    cycle.x.push_back(0.0);
    cycle.y.push_back(-1.5e3);
  }
  cycle.interpolation = LoadInterpolation::periodic_spline;
  cycle.journal_mass = 0.5;
  return cycle;
}

}  // namespace

TEST_CASE("EverySupplyTellsItsFlowAndItsTemperature", "[groove_heat]") {
  // Two grooves, one of them where the loaded film runs into it: what both feed is the whole flow,
  // the mean of their oil by it the whole temperature; the one behind the load is the hotter one.
  Case c = groove_with(ChannelHeat{});
  c.supplies[0].arc = 0.3;
  Supply other = c.supplies[0];
  other.angle += kPi;
  c.supplies.push_back(other);
  const Solution s = solve_tier(c, Tier::thd);
  REQUIRE(s.verdict.good());
  const Result r = summarize(s, Tier::thd);
  REQUIRE(r.supplies.size() == 2);
  double flow = 0.0, by_flow = 0.0, fed = 0.0;
  for (const SupplyState& supply : r.supplies) {
    flow += supply.flow;
    by_flow += std::max(supply.flow, 0.0) * supply.T_mixed;
    fed += std::max(supply.flow, 0.0);
    CHECK(supply.T_mixed > c.supplies[0].temperature);
  }
  CHECK(flow == Approx(r.values().supply_flow).epsilon(1e-9));
  CHECK(by_flow / fed == Approx(r.values().T_supply_mixed).epsilon(1e-12));
  CHECK(std::abs(r.supplies[0].T_mixed - r.supplies[1].T_mixed) > 0.1);
  const Result cool = summarize(solve_tier(c, Tier::isothermal), Tier::isothermal);
  CHECK(std::isnan(cool.supplies[0].T_mixed));
}

TEST_CASE("HeatOfAGrooveWithItsWallsIsConserved", "[groove_heat]") {
  double before = 0.0;
  for (const double h : {0.0, 500.0, 5000.0}) {
    for (const Tier tier : {Tier::thd, Tier::tehd}) {
      const Solution s = solved(groove_with(h), tier);
      CHECK(audit_of(s, friction_of(s.model, s.point, s.film)).energy < 1e-8);
    }
    const Solution s = solved(groove_with(h), Tier::thd);
    if (h == 0.0) {
      CHECK(into_walls(s) == 0.0);
      before = s.heat.T_mix[0];
      continue;
    }
    // shell and shaft are hotter than the oil that enters: they warm it
    CHECK(into_walls(s) < 0.0);
    CHECK(s.heat.T_mix[0] > before);
  }
}

TEST_CASE("TwoGroovesThatTouchAreOne", "[groove_heat]") {
  // The same cells at the same pressure: one pocket, whoever calls it two.
  Case one = groove_with(0.0);
  one.supplies[0].arc = 24.0 * kDegree;
  Case two = one;
  two.supplies[0].arc = 12.0 * kDegree;
  two.supplies.push_back(two.supplies[0]);
  two.supplies[0].angle -= 6.0 * kDegree;
  two.supplies[1].angle += 6.0 * kDegree;
  for (const Tier tier : {Tier::lumped, Tier::thd, Tier::tehd}) {
    const Solution a = solved(one, tier), b = solved(two, tier);
    CHECK(torque_of(b) == Approx(torque_of(a)).epsilon(1e-6));
    if (tier == Tier::lumped) continue;
    CHECK(b.heat.T_mix[0] == Approx(a.heat.T_mix[0]).margin(1e-4));
    CHECK(b.heat.T_mix[1] == b.heat.T_mix[0]);
    CHECK(audit_of(b, friction_of(b.model, b.point, b.film)).energy < 1e-8);
  }
  // What they exchange and carry over is of the whole, whichever comes first.
  two.supplies[0].heat_transfer = 2000.0;
  two.supplies[0].carry_over = 0.5;
  Case turned = two;
  std::swap(turned.supplies[0], turned.supplies[1]);
  const Solution a = solved(two, Tier::thd), b = solved(turned, Tier::thd);
  CHECK(torque_of(b) == Approx(torque_of(a)).epsilon(1e-9));
  CHECK(b.heat.T_mix[0] == Approx(a.heat.T_mix[0]).epsilon(1e-9));
  CHECK(audit_of(a, friction_of(a.model, a.point, a.film)).energy < 1e-8);
  // Under different pressures the higher one feeds.
  two.supplies[0].pressure *= 2.0;
  two.supplies[0].temperature += 20.0;
  const std::vector<double> T = fed_temperatures(two, {0, 0});
  CHECK(T[0] == two.supplies[0].temperature);
  CHECK(T[1] == T[0]);
  CHECK(fed_temperatures(two, {0, 1})[1] == two.supplies[1].temperature);
}

TEST_CASE("OilThatLeavesAGrooveOverASideEdgeTakesItsHeatAlong", "[groove_heat]") {
  // Where no cell lies in the land, the cells being too few, oil is throttled from the groove
  // straight to the edge: half of the pump's power, which was in no balance.
  for (const double pressure : {1e5, 5e5, 20e5}) {
    Case c = groove_with(0.0);
    c.model.grid = {60, 5};
    for (const double length : {0.3, 0.6}) {
      c.supplies.push_back(c.supplies[0]);
      c.supplies.back().length = length * c.bearing.width;
      c.supplies.back().angle += 4.0 * length * kPi / 1.8;
    }
    c.supplies[0].length = 0.995 * c.bearing.width;
    c.supplies[0].pressure = pressure;
    for (const Tier tier : {Tier::thd, Tier::tehd}) {
      const Solution s = solved(c, tier);
      CHECK(audit_of(s, friction_of(s.model, s.point, s.film)).energy < 1e-8);
      const Result r = summarize(s, tier);
      const bool told = std::any_of(r.warnings.begin(), r.warnings.end(), [](const Note& n) {
        return std::holds_alternative<note::LandUnseen>(n);
      });
      CHECK(told);
    }
  }
}

TEST_CASE("AGrooveOfStrongExchangeIsAsWarmAsItsWalls", "[groove_heat]") {
  const Solution s = solved(groove_with(1e6), Tier::thd);
  const FilmGrid& g = s.model.domain.grid;
  double walls = 0.0, area = 0.0;
  for (int c = 0; c < g.cells(); ++c) {
    if (s.point.scene.supply.cell[c] < 0) continue;
    const double A = g.area(c);
    walls += 0.5 * A * (s.heat.T_shell[c] + s.heat.T_shaft[c % g.nz]);
    area += A;
  }
  // flow 0.1 kg/s of 2 kJ/(kg K) over 1e6 W/(m2 K) on twice 1e-3 m2: a tenth of the difference
  CHECK(s.heat.T_mix[0] == Approx(walls / area).margin(1.0));
}

TEST_CASE("HardlyAnyExchangeOfAGrooveIsNone", "[groove_heat]") {
  const Solution none = solved(groove_with(0.0), Tier::thd);
  const Solution hardly = solved(groove_with(1e-9), Tier::thd);
  // the same equations but for 1e-9 of what 1 W/(m2 K) does: as near as iterations settle
  CHECK(hardly.heat.T_mix[0] == Approx(none.heat.T_mix[0]).margin(1e-3));
  CHECK(hardly.film.position.ex() == Approx(none.film.position.ex()).epsilon(1e-5));
  CHECK(hardly.film.position.ey() == Approx(none.film.position.ey()).epsilon(1e-5));
  const int c = [&] {
    const auto& cells = none.point.scene.supply.cell;
    return static_cast<int>(std::find_if(cells.begin(), cells.end(), [](int p) { return p >= 0; }) -
                            cells.begin());
  }();
  CHECK(hardly.film.columns.T_mean[c] == Approx(hardly.heat.T_mix[0]).margin(1e-3));
}

TEST_CASE("TheMixedSupplyDoesNotDependOnTheOrderOfTheSupplies", "[groove_heat]") {
  Case c = groove_with(0.0);
  Supply other = c.supplies[0];
  other.angle += kPi;
  other.temperature += 10.0;
  c.supplies.push_back(other);
  const double one = summarize(solved(c, Tier::thd), Tier::thd).values().T_supply_mixed;
  std::swap(c.supplies[0], c.supplies[1]);
  const double two = summarize(solved(c, Tier::thd), Tier::thd).values().T_supply_mixed;
  CHECK(two == Approx(one).margin(3e-3));  // what the outer iteration leaves
}

TEST_CASE("FlowsByVolumeDoNotDependOnTheOrderOfTheSupplies", "[groove_heat]") {
  // Counted with the density of one temperature: 40 K between the supplies are 3 % of it.
  Case c = groove_with(0.0);
  c.oil.density = rheology::DowsonHigginson{860.0, 313.15, 7e-4};
  Supply other = c.supplies[0];
  other.angle += kPi;
  other.temperature += 40.0;
  c.supplies.push_back(other);
  Case swapped = c;
  std::swap(swapped.supplies[0], swapped.supplies[1]);
  for (const Tier tier : {Tier::isothermal, Tier::thd}) {
    const Result one = summarize(solved(c, tier), tier),
                 two = summarize(solved(swapped, tier), tier);
    for (const char* name : {"side_flow", "supply_flow", "pump_power", "friction_torque"}) {
      INFO(to_string(tier) << ' ' << name);
      CHECK(two.value(name) == Approx(one.value(name)).epsilon(2e-4));
    }
  }
}

TEST_CASE("TheOilAtTheEdgesDoesNotDependOnTheOrderOfTheSupplies", "[groove_heat]") {
  // Below ambient the film draws oil in at its sides: as warm as what the two grooves feed.
  Case c = warm_case();
  c.model.cavitation_pressure = -9e4;
  set_load(c, 300.0);
  c.supplies.push_back(c.supplies[0]);
  c.supplies[1].angle += kPi;
  c.supplies[1].temperature += 30.0;
  Case other = c;
  std::swap(other.supplies[0], other.supplies[1]);
  const Solution a = solved(c, Tier::thd), b = solved(other, Tier::thd);
  REQUIRE(fluid::oil_flows(a.point.scene, a.film.flow).side_inflow > 0.0);
  const Result first = summarize(a, Tier::thd), second = summarize(b, Tier::thd);
  for (const char* name : {"friction_torque", "T_film_max", "T_film_mean", "heat_to_shell"}) {
    INFO(name);
    // what the outer iteration leaves; the edges' oil was 30 K warmer in one of the orders
    CHECK(second.value(name) == Approx(first.value(name)).epsilon(2e-4));
  }
}

TEST_CASE("AChannelsHeatTransferIsThatOfPlates", "[groove_heat]") {
  const Solution s = solved(groove_with(ChannelHeat{}), Tier::thd);
  const double h = 7.54 * 0.13 / (2.0 * 1e-3);  // Nu k / (2 d), oil of 0.13 W/(m K), 1 mm deep
  CHECK(supply_heat_transfer(s.model, 0) == Approx(h).epsilon(1e-12));
  const Solution same = solved(groove_with(h), Tier::thd);
  CHECK(s.heat.T_mix[0] == Approx(same.heat.T_mix[0]).epsilon(1e-12));
  CHECK(supply_heat_transfer(s.model, -1) == 0.0);
}

TEST_CASE("AWarmUpWithGroovesLosesNoHeat", "[groove_heat]") {
  const Case c = groove_with(2000.0);
  const WarmUp run = warm_up(c, Tier::thd, {});
  INFO(app::reason_of(run.end.verdict));
  REQUIRE(run.end.verdict.good());
  CHECK(run.imbalance() < 1e-8);
  const Solution steady = solved(c, Tier::thd);
  CHECK(run.instants.back().T_film_max ==
        Approx(largest(steady.film.columns.T)).margin(0.02));  // each a fixed point to 3 mK
}

TEST_CASE("GroovesExchangeHeatOverACycleToo", "[groove_heat]") {
  Case c = warm_case();
  c.model.grid = {48, 6};
  set_load(c, 1.5e3);
  c.supplies[0].heat_transfer = 2e4;
  const Solution steady = solved(c, Tier::thd);
  CHECK(std::abs(into_walls(steady)) > 1.0);  // [W]: it matters here
  c.cycle = standing(c);
  const CycleResult r = solve_cycle(c, Tier::thd);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  CHECK(r.audit.energy < 1e-9);
  CHECK(r.audit.walls < 0.1);  // [K]
  for (const CycleQuantity& q : r.quantities) {
    // under a steady load the cycle is the steady bearing, to what its walls are found (30 mK)
    if (q.quantity.name == "T_shell_max") {
      CHECK(q.quantity.value == Approx(largest(steady.heat.T_shell)).margin(0.06));
    }
    if (q.quantity.name == "heat_to_shell") {
      CHECK(q.quantity.value == Approx(steady.heat.solids.shell.heat_in).epsilon(0.01));
    }
  }
}

TEST_CASE("TheShaftPaysForTheOilOfAGrooveAsItIs", "[groove_heat]") {
  // A steady film whose groove is expected 10 K colder than it is: what is sheared there follows
  // the mixed oil, and the power of shaft and supply is the heat, as it is where all is as
  // expected.
  for (const double z : {0.0, 2e-3}) {  // half and whole bearing
    Case c = warm_case();
    c.model.grid = {36, 5};
    set_load(c, 1.5e3);
    c.supplies[0].z = z;
    c.supplies[0].depth = 50e-6;  // sheared hard
    const Solution s = solved(c, Tier::thd);
    const FilmGrid& g = s.model.domain.grid;
    HeatSteps steps(s.model, 0.01, 1e-5);
    steps.walls = {s.heat.T_shell, s.heat.T_shaft, Field(g.cells(), 0.0), {}};
    std::vector<double> torque;
    for (const double colder : {0.0, 10.0}) {
      FilmEquilibrium film = s.film;
      for (int k = 0; k < g.cells() * s.model.gl.n; ++k) {
        if (s.model.supply.cell[k / s.model.gl.n] >= 0) film.columns.T[k] -= colder;
      }
      REQUIRE(evaluate(s.model, s.point, s.heat.thermal_deformation, 1e-12, film));
      Field mass = fluid::oil_content(s.point.scene, film.gap, film.oil, film.film);
      for (int k = 0; k < g.cells(); ++k) mass[k] *= g.area(k);
      const HeatInTime now = steps.begin(s.model, film.columns.T, mass);
      const HeatStage found =
          steps.stage(s.model, s.point, film, 1e-3, mass, mass, now.held, now.skin);
      REQUIRE(found.settled);
      // The film beside colder oil is not quite in balance any more: 1e-5 to 4e-5.
      CHECK(found.flows.work == Approx(g.multiplicity() * found.flows.balance.heat).epsilon(2e-4));
      torque.push_back(friction_of(s.model, s.point, film).torque());
    }
    CHECK(torque[1] > 1.005 * torque[0]);  // else this test tells nothing
  }
}

TEST_CASE("AColdEngineWarmsWhereverItsPeriodBegins", "[cycle_heat]") {
  // Oil of -10 degC in a ring groove, half a pascal second: as cold as it is expected it would heat
  // itself in one step beyond what oil can be.
  Case c = rig_case();
  c.bearing = {0.0285, 0.055, 30e-6, 373.15, {}};
  c.supplies[0].kind = SupplyKind::circumferential_groove;
  c.supplies[0].arc = 2.0 * kPi;
  c.supplies[0].length = 6e-3;
  c.supplies[0].diameter = 0.0;
  c.supplies[0].depth = 1e-3;
  c.supplies[0].heat_transfer = ChannelHeat{};
  c.supplies[0].pressure = 4e5;
  c.supplies[0].temperature = 353.15;
  c.shell->housing = Housing{steel(), 0.0515, HousingSupport::held};
  c.shaft = Shaft{steel(), 0.02, 100.0, 333.15};
  c.surfaces.shell.orientation = c.surfaces.shaft.orientation = 1.0;
  c.operation.omega = 2500.0 * kRpm;
  c.model.grid = {36, 5};
  c.model.tier = Tier::thd;
  std::vector<double> torque;
  for (const double begun : {0.0, 1.0 / 3.0, 2.0 / 3.0}) {
    LoadCycle cycle;
    cycle.period = 0.04;
    cycle.journal_mass = 50.0;
    for (int k = 0; k < 80; ++k) {
      const double t = k / 80.0 + begun;
      const double off = (t - std::floor(t) - 0.4) / 0.06;
      cycle.t.push_back(0.04 * k / 80.0);
      cycle.x.push_back(0.0);
      cycle.y.push_back(-1567.5 - 102e3 * std::exp(-off * off));
    }
    c.cycle = cycle;
    WarmUpOptions o;
    o.T_start = 263.15;
    o.end = 0.05;
    const WarmUp run = warm_up(c, Tier::thd, o);
    INFO(app::reason_of(run.end.verdict));
    REQUIRE(run.end.verdict.good());
    torque.push_back(run.instants.back().torque);
  }
  CHECK(torque[1] == Approx(torque[0]).epsilon(5e-3));  // steps of an error of 1e-3
  CHECK(torque[2] == Approx(torque[0]).epsilon(5e-3));
}

TEST_CASE("AGrooveThatExchangesNoHeatTakesNoneFromCellsBesideItOnCoarserGrids", "[groove_heat]") {
  // The cycle on these cells begins with the heat of coarser ones, whose cells reach over its
  // edges.
  Case c = warm_case();
  c.model.grid = {96, 12};
  set_load(c, 1.5e3);
  c.supplies[0].heat_transfer = 0.0;
  c.cycle = standing(c);
  const CycleResult r = solve_cycle(c, Tier::thd);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  const BearingModel m = make_bearing(c, {}, c.model.grid);
  const FilmGrid& g = m.domain.grid;
  Field fed(g.cells());
  for (int k = 0; k < g.cells(); ++k) fed[k] = m.supply.cell[k] >= 0 ? 1.0 : 0.0;
  const Field full = mirror_to_full(g, fed);
  REQUIRE(full.size() == r.fields.heat_to_shell.size());
  int inside = 0;
  for (std::size_t k = 0; k < full.size(); ++k) {
    if (full[k] == 0.0) continue;
    ++inside;
    CHECK(r.fields.heat_to_shell[k] == 0.0);
  }
  CHECK(inside > 0);
}

namespace {

/// The journal in the middle of a bearing with a ring groove; one temperature, no heat.
Case ring_groove(double width, double pressure) {
  Case c = grooved_case();
  c.model.tier = Tier::isothermal;
  c.operation.position = EccentricityGiven{0.0, 0.0};
  c.supplies[0].kind = SupplyKind::circumferential_groove;
  c.supplies[0].angle = 0.0;
  c.supplies[0].arc = 2.0 * kPi;
  c.supplies[0].length = width;
  c.supplies[0].pressure = pressure;
  c.oil.temperature = rheology::ConstantViscosity{0.02};
  c.model.grid = {60, 13};
  return c;
}

}  // namespace

TEST_CASE("AGrooveShearsItsOilOverItsOwnDepth", "[groove]") {
  // Plain shear everywhere: T = R A eta f(rate) rate, rate = U/(c + depth) in the groove.
  for (const double depth : {40e-6, 1e-4, 1e-3}) {
    Case c = ring_groove(0.04, 0.0);
    c.supplies[0].depth = depth;
    c.oil.shear = rheology::Cross{0.3, 4.5e-7, 0.6};
    const double U = c.operation.omega * c.bearing.radius;
    const auto stress = [&](double h) {
      const double rate = U / h;
      const double f = 0.3 + 0.7 / (1.0 + std::pow(4.5e-7 * rate, 0.6));
      return 0.02 * f * rate;
    };
    const double around = 2.0 * kPi * c.bearing.radius * c.bearing.radius;
    const double gap = c.bearing.radial_clearance;
    const double expected =
        around * ((c.bearing.width - 0.04) * stress(gap) + 0.04 * stress(gap + depth));
    const Result r = solve(c);
    REQUIRE(r.verdict.good());
    CHECK(r.value("friction_torque") == Approx(expected).epsilon(1e-8));  // of the substitution
  }
}

TEST_CASE("OilLeavesOverALandNarrowerThanACell", "[groove]") {
  // Q = pi R c^3 p/(6 eta) (1/L1 + 1/L2), exact on any cells that have the groove's edges.
  for (const double land : {2e-3, 5e-4, 1e-4, 1e-5}) {
    for (const int along : {7, 13, 24}) {
      Case c = ring_groove(0.01, 1e5);
      c.model.grid = {24, along};
      c.supplies[0].z = 0.5 * c.bearing.width - land - 0.005;
      const double other = c.bearing.width - 0.01 - land;
      const double expected = kPi * c.bearing.radius * std::pow(c.bearing.radial_clearance, 3) *
                              1e5 / (6.0 * 0.02) * (1.0 / land + 1.0 / other);
      const Solution s = solved(c, Tier::isothermal);
      CHECK(summarize(s, Tier::isothermal).value("side_flow") == Approx(expected).epsilon(1e-9));
    }
  }
}
