// Load cycles with film temperatures: against the steady tiers, balances, order in time.
#include <catch2/catch.hpp>
#include <utility>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/compare_cycles.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/over_time/cycle_search.hpp"
#include "bearing/over_time/film_answer.hpp"
#include "bearing/over_time/heat_in_time.hpp"
#include "bearing/over_time/warm_up.hpp"
#include "bearing/steady/solve.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "tests/bearing/solved.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// A load of `mean` downwards that swings by `swing` of it once in two turns.
LoadCycle swinging(const Case& c, double mean, double swing) {
  constexpr int kRows = 72;
  LoadCycle cycle;
  cycle.crank_speed = std::abs(c.operation.omega);
  cycle.period = 4.0 * kPi / cycle.crank_speed;
  for (int k = 0; k < kRows; ++k) {
    cycle.t.push_back(cycle.period * k / kRows);
    cycle.x.push_back(0.0);
    cycle.y.push_back(-mean * (1.0 + swing * std::sin(2.0 * kPi * k / kRows)));
  }
  cycle.interpolation = LoadInterpolation::periodic_spline;
  cycle.journal_mass = 0.5;
  return cycle;
}

Case warm_cycle_case(double mean, double swing) {
  Case c = warm_case();
  c.model.grid = {48, 6};
  set_load(c, mean);
  c.cycle = swinging(c, mean, swing);
  return c;
}

/// Indicator numbers of two films that agree within a hundredth (side flow and mean temperature).
void check_alike(const std::vector<Effect>& a, const std::vector<Effect>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    INFO("effect " << k);
    CHECK(a[k].kind == b[k].kind);
    CHECK(a[k].included == b[k].included);
    CHECK(std::isfinite(a[k].indicator) == std::isfinite(b[k].indicator));
    if (!std::isfinite(b[k].indicator)) continue;
    CHECK(a[k].indicator == Approx(b[k].indicator).epsilon(0.02).margin(1e-3));
  }
}

}  // namespace

TEST_CASE("UnderASteadyLoadTheCycleIsTheSteadyResolvedTier", "[cycle_heat]") {
  const double load = 1.5e3;
  Case c = warm_cycle_case(load, 0.0);
  for (const Tier tier : {Tier::thd, Tier::tehd}) {
    const CycleResult r = converged(c, tier);
    Case still = c;
    still.cycle.reset();
    still.model.tier = tier;
    const Result at_rest = solve(still);
    const Quantities steady = at_rest.values();
    INFO(to_string(tier));
    // walls agree within 0.1 % of viscosity, 30 mK; the film follows by a half of that
    CHECK(value(r, "T_film_max") == Approx(steady.T_film_max).margin(0.06));
    CHECK(value(r, "T_shell_max") == Approx(steady.T_shell_max).margin(0.06));
    CHECK(value(r, "friction_torque") == Approx(steady.friction_torque).epsilon(2e-3));
    CHECK(value(r, "h_min") == Approx(steady.h_min).epsilon(2e-3));
    CHECK(value(r, "heat_to_shell") == Approx(steady.heat_to_shell).epsilon(0.01));
    CHECK(value(r, "heat_to_shaft") ==
          Approx(steady.heat_to_shaft).margin(0.01 * steady.heat_to_shell));
    CHECK(value(r, "heat_by_oil") == Approx(steady.heat_by_oil).epsilon(0.01));
    CHECK(r.audit.energy < 1e-9);
    CHECK(std::abs(r.audit.work) < 1e-6);  // nothing swings
    // Moments are those of one film; what is left between the two runs is heat, as above.
    CHECK(r.audit.moment == Approx(at_rest.audit.moment).epsilon(0.05));
    check_alike(r.effects, at_rest.effects);
  }
}

TEST_CASE("HeatOfACycleIsConserved", "[cycle_heat]") {
  Case c = warm_cycle_case(1.5e3, 0.6);
  const CycleResult r = converged(c, Tier::thd);
  CHECK(r.audit.mass < 1e-12);
  CHECK(r.audit.energy < 1e-9);
  // The work of shaft, load and supply is the heat of the film. Without elasticity nothing else
  // takes it; what is missing is Newton's tolerance, 1e-5 of the largest flow.
  CHECK(std::abs(r.audit.work) < 1e-4);
  const double heat =
      value(r, "heat_by_oil") + value(r, "heat_to_shell") + value(r, "heat_to_shaft");
  // ... but for what supply pressure adds, 0.1 MPa on some 0.1 l/min: below a thousandth
  CHECK(heat == Approx(value(r, "power_loss")).epsilon(0.01));
  CHECK(r.audit.walls < 0.1);  // [K]
}

TEST_CASE("HeatThatUnsettledWallsWouldStillTakeIsTold", "[cycle_heat]") {
  // The same steps in time between walls that were left early and late: what the audit tells of the
  // early ones leads to the late ones' heat. First order in what is missing, so a third of it may
  // be left, on either side of the film, through which walls that still change heat one another.
  for (const Tier tier : {Tier::thd, Tier::tehd}) {
    INFO(to_string(tier));
    Case c = warm_cycle_case(1.5e3, 0.6);
    c.cycle->step = c.cycle->period / 120.0;
    c.model.tolerance = 0.05;
    const CycleResult early = converged(c, tier);
    c.model.tolerance = 1e-4;
    const CycleResult late = converged(c, tier);
    REQUIRE(early.audit.walls > 10.0 * late.audit.walls);
    const auto by = [&](const char* name) { return value(late, name) - value(early, name); };
    const double most = std::max(std::abs(by("heat_to_shell")), std::abs(by("heat_to_shaft")));
    for (const auto& [name, missing] : {std::pair{"heat_to_shell", early.audit.to_shell},
                                        std::pair{"heat_to_shaft", early.audit.to_shaft}}) {
      const double off = by(name);
      INFO(name << ": " << value(early, name) << " W, off by " << off << " W, told " << missing);
      CHECK(std::abs(off - missing) <= most / 3.0 + 1e-4 * value(late, "power_loss"));
    }
    CHECK(std::abs(early.audit.to_shell) + std::abs(early.audit.to_shaft) >
          1e-4 * value(late, "power_loss"));
  }
}

TEST_CASE("WhatStepsLoseOfElasticWorkFallsWithTheirSquare", "[cycle_heat]") {
  // A saw tooth of load on a soft shell: second order comes from its corners. Over a smooth period
  // what is lost and won cancels but for 1e-8.
  Case c = warm_cycle_case(1.5e3, 0.0);
  c.model.grid = {24, 4};
  c.shell->layers[0].material.youngs_modulus = 10e9;
  const double T = c.cycle->period;
  c.cycle->t = {0.0, 0.25 * T, 0.5 * T};
  c.cycle->x = {0.0, 0.0, 0.0};
  c.cycle->y = {-1e3, -6e3, -1e3};
  c.cycle->interpolation = LoadInterpolation::linear;
  std::vector<double> lost;
  for (const double steps :
       {48.0, 192.0}) {  // fronts enter cells in some steps: over a factor of four
    c.cycle->step = T / steps;
    const CycleResult r = converged(c, Tier::tehd);
    CHECK(r.audit.mass < 1e-12);
    CHECK(r.audit.energy < 1e-9);  // of the heat: apart from what is lost of the work
    lost.push_back(r.audit.work);
  }
  const double order = 0.5 * std::log2(lost[0] / lost[1]);
  INFO(lost[0] << ", " << lost[1]);
  CHECK(lost[1] > 0.0);  // elastic work is damped, not made
  CHECK(order > 1.85);
  CHECK(order < 2.5);  // the third order still counts at 7.5 degrees a step
}

TEST_CASE("AnEventWithHeatBeginsInItsSteadyState", "[cycle_heat]") {
  Case c = warm_cycle_case(1.5e3, 0.0);
  c.cycle->period = std::numeric_limits<double>::infinity();
  const CycleResult r = converged(c, Tier::tehd);
  const CycleInstant& first = r.instants.front();
  const CycleInstant& last = r.instants.back();
  CHECK(first.T_film_max > 300.0);
  CHECK(last.T_film_max == Approx(first.T_film_max).margin(0.02));  // nothing happens [K]
  CHECK(last.T_shell_max == Approx(first.T_shell_max).margin(0.02));
  CHECK(last.torque == Approx(first.torque).epsilon(1e-3));
}

TEST_CASE("GrowthByContactHeatBelongsToTheWallsNotToAStep", "[cycle_heat]") {
  // A third of the torque is rubbed: contact heat makes the shell bulge where it rubs. The steady
  // search has that growth as the film's own, answering at once; in time it is the walls'. An event
  // that had both would leave its steady state.
  Case c = rig_case();
  soften_edges(c);
  c.model.grid = {48, 6};
  c.operation.omega = 1000.0 * kPi / 30.0;
  const double load = 18e3;
  set_load(c, load);
  const Solution steady = solve_tier(c, Tier::tehd);
  REQUIRE(steady.verdict.good());
  CHECK(steady.film.contact_widening == nullptr);
  LoadCycle event;
  event.t = {0.0, 0.01};
  event.x.assign(2, 0.0);
  event.y.assign(2, -load);
  event.journal_mass = 0.5;
  c.cycle = event;
  const CycleResult r = converged(c, Tier::tehd);
  const CycleInstant& first = r.instants.front();
  const CycleInstant& last = r.instants.back();
  CHECK(first.torque_asperity > 0.25 * first.torque);
  // 0.1 % of the viscosity, as well as walls are known, is 0.05 % of a mixed film's contact.
  CHECK(last.torque_asperity == Approx(first.torque_asperity).epsilon(2e-3));
  CHECK(last.h_min == Approx(first.h_min).epsilon(1e-3));
}

TEST_CASE("AnEventBeginsAnewAtEveryTemperature", "[cycle_heat]") {
  Case c = warm_cycle_case(1.5e3, 0.6);
  c.cycle->period = std::numeric_limits<double>::infinity();
  c.cycle->interpolation = LoadInterpolation::linear;
  const SolveControl control;
  CycleSearch search(c, Tier::isothermal, control);
  search.begin(313.15);
  REQUIRE(search.search(false).good());
  const double torque = search.told().means().torque;
  search.set_temperature(333.15);
  REQUIRE(search.search(false).good());
  CHECK(search.told().means().torque < 0.8 * torque);  // thinner oil
  search.set_temperature(313.15);
  REQUIRE(search.search(false).good());
  CHECK(search.told().means().torque == Approx(torque).epsilon(1e-3));  // other steps
}

TEST_CASE("OilThatIsLedOnTakesItsHeatAlong", "[cycle_heat]") {
  Case c = warm_cycle_case(1.5e3, 0.6);
  const LoadCourse course(*c.cycle, c.operation.omega);
  FilmSteps steps(make_bearing(c, physics_of(c, Tier::thd), c.model.grid), course, 0.5, {});
  FilmInTime now = steps.at_rest(333.15);
  const double period = c.cycle->period;
  REQUIRE(steps.set_walls(uniform_walls(steps.model(), 323.15), period, 1e-3 * period, now));
  EquilibriumCost cost;
  const auto go_on = [&] {
    FilmStep step = steps.take(period / 180.0, now, cost, nullptr);
    INFO(app::reason_of(step.verdict));
    REQUIRE(step.verdict.good());
    now = std::move(step.after);
  };
  for (int k = 0; k < 60; ++k) go_on();
  const FilmInTime before = now;
  std::vector<double> oil = steps.oil_of(now);
  for (double& m : oil) m *= 0.2;  // cells that are full keep theirs
  steps.put_oil(oil, now);
  const int nodes = steps.model().gl.n;
  int changed = 0;
  for (std::size_t k = 0; k < now.oil.size(); ++k) {
    if (now.oil[k] == before.oil[k]) continue;
    ++changed;
    for (int n = 0; n < nodes; ++n) {
      const std::size_t node = k * nodes + n;
      CHECK(now.heat.held[node] * before.oil[k] ==
            Approx(before.heat.held[node] * now.oil[k]).epsilon(1e-12));
    }
  }
  CHECK(changed > 20);  // the film is cavitated
  go_on();
}

TEST_CASE("AnEventThatDrivesOilBackIntoItsSupplyHasNoHeatBalance", "[cycle_heat]") {
  // The load leaps to twenty times its size, straight to the groove: within 0.2 ms oil leaves the
  // film by groove and sides, none comes in that could carry its heat.
  Case c = warm_cycle_case(1e3, 0.0);
  c.supplies[0].angle = 270.0 * kDegree;
  LoadCycle event;
  event.t = {0.0, 0.0, 2e-4};
  event.x.assign(3, 0.0);
  event.y = {-1e3, -2e4, -2e4};
  event.journal_mass = 0.5;
  c.cycle = event;
  const CycleResult r = solve_cycle(c, Tier::lumped);
  CHECK(r.verdict.status == Status::iteration_limit);  // walls may take it up: no proof
  CHECK_THAT(app::reason_of(r.verdict), Catch::Contains("no oil is fed"));
}

TEST_CASE("LumpedCyclesMeetTheHeatBalanceOfTheirMeans", "[cycle_heat]") {
  Case c = warm_cycle_case(1.5e3, 0.0);
  Case still = c;
  still.cycle.reset();
  still.model.tier = Tier::lumped;
  const Result steady = solve(still);
  const CycleResult r = converged(c, Tier::lumped);
  // 0.01 K of r, 1e-4 of the cycle's closure
  CHECK(value(r, "friction_torque") == Approx(steady.values().friction_torque).epsilon(2e-3));
  CHECK(value(r, "h_min") == Approx(steady.values().h_min).epsilon(2e-3));
  CHECK(value(r, "T_film_mean") == Approx(steady.values().T_film_mean).margin(0.02));
}

TEST_CASE("TheShellIsNotTheOilOfGroovesThatDoNotTouchIt", "[cycle_heat]") {
  // A thin shell whose back is held at the supply's temperature stays cold behind the groove, whose
  // oil, mixed with what comes round, does not.
  Case c = warm_cycle_case(1.5e3, 0.0);
  c.shell = Shell{{{steel(), 0.5e-3}}, {}, PrescribedBack{313.15}, 0.0};
  c.operation.omega = 6000.0 * kPi / 30.0;
  c.supplies[0].pressure = 1e3;
  c.cycle = swinging(c, 1.5e3, 0.0);
  Case still = c;
  still.cycle.reset();
  still.model.tier = Tier::thd;
  const Result steady = solve(still);
  REQUIRE(steady.verdict.good());
  const double shell = steady.value("T_shell_max");
  REQUIRE(steady.value("T_supply_mixed") > shell + 1.0);
  CHECK(value(converged(c, Tier::thd), "T_shell_max") == Approx(shell).margin(0.06));
}

TEST_CASE("CyclesSayHowWarmOilIsThatEdgesDrawIn", "[cycle_heat]") {
  // A film that cavitates half a bar below ambient draws oil in at the edges beside its void.
  const auto told = [](double p_cav, Tier tier) {
    Case c = warm_cycle_case(1.5e3, 0.3);
    c.model.grid = {32, 7};
    c.model.cavitation_pressure = p_cav;
    c.cycle->step = 10.0 * kDegree / c.cycle->crank_speed;
    const CycleResult r = converged(c, tier);
    for (const Note& n : r.assumptions) {
      const auto* plain = std::get_if<note::Plain>(&n);
      if (plain && *plain == note::Plain::edge_oil_as_supply) return Tier::thd;
      if (plain && *plain == note::Plain::edge_oil_as_film) return Tier::lumped;
    }
    return Tier::isothermal;  // nothing is told
  };
  for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd}) {
    CHECK(told(-5e4, tier) == tier);
    CHECK(told(0.0, tier) == Tier::isothermal);
  }
}

TEST_CASE("WallsAndOilComeToRestTogetherWhereverTheyBegin", "[cycle_heat]") {
  // A light load that turns with the journal, fed by a short line: the film gathers its oil over
  // more cycles than its walls need. Judge: the same search from a colder bearing.
  Case c = warm_cycle_case(300.0, 0.0);
  c.supplies[0].arc = 0.0;
  c.supplies[0].length = 0.004;
  c.supplies[0].pressure = 5e3;
  c.model.grid = {32, 7};
  LoadCycle& load = *c.cycle;
  for (std::size_t k = 0; k < load.t.size(); ++k) {
    const double angle = load.crank_speed * load.t[k];
    load.x[k] = 300.0 * std::cos(angle);
    load.y[k] = 300.0 * std::sin(angle);
  }
  load.step = 8.0 * kDegree / load.crank_speed;
  std::vector<CycleMeans> means;
  for (const double T : {333.15, 313.15}) {
    const SolveControl control;
    CycleSearch search(c, Tier::thd, control);
    search.begin(T);
    INFO(app::reason_of(search.search(false)));
    REQUIRE(search.verdict().good());
    CHECK(search.cycles() > 15);  // turns of the walls, after which the oil is given time
    CHECK(search.result().audit.walls <= 0.1);
    means.push_back(search.told().means());
  }
  // 0.1 K of the walls are 0.4 % of viscosity
  CHECK(means[1].torque == Approx(means[0].torque).epsilon(4e-3));
  CHECK(means[1].side_mass_flow == Approx(means[0].side_mass_flow).epsilon(4e-3));
}

TEST_CASE("TemperaturesOfACycleDoNotDependOnTheSteps", "[cycle_heat]") {
  Case c = warm_cycle_case(1.5e3, 0.6);
  std::vector<double> torque, swing;
  for (const double steps : {48.0, 96.0, 192.0}) {
    c.cycle->step = c.cycle->period / steps;
    c.model.tolerance = 1e-3;  // of the walls
    const CycleResult r = converged(c, Tier::thd);
    torque.push_back(value(r, "friction_torque"));
    double low = INFINITY, high = 0.0;
    for (const CycleInstant& i : r.instants) {
      low = std::min(low, i.heat_to_shell);
      high = std::max(high, i.heat_to_shell);
    }
    swing.push_back(high - low);
  }
  // of second order: a quarter from one to the next; a third leaves room for the walls' 1e-4
  CHECK(std::abs(torque[2] - torque[1]) < std::abs(torque[1] - torque[0]) / 3.0 + 2e-4 * torque[2]);
  CHECK(swing[2] == Approx(swing[1]).epsilon(0.02));
  CHECK(swing[2] > 2.0);  // [W]; there is something to follow
}

TEST_CASE("TheFrictionOfACycleIsSplitIntoItsCauses", "[cycle_heat]") {
  Case c = warm_cycle_case(1.5e3, 0.6);
  c.oil_temperature = 303.15;  // the isothermal film is far too cold
  const auto solve = [](const Case& one) { return solve_cycle(one, one.model.tier); };
  const CycleComparison all = compare_cycles(c, {Tier::isothermal, Tier::tehd}, {}, solve);
  REQUIRE(all.cycles.size() == 2);
  const FrictionSplit& split = all.sums.split;
  REQUIRE(split.steps.size() == 5);
  double sum = split.from;
  for (const FrictionStep& step : split.steps) sum += step.change;
  CHECK(sum == Approx(split.to).epsilon(1e-9));
  CHECK(split.from == Approx(value(all.cycles[0], "friction_torque")));
  CHECK(split.to == Approx(value(all.cycles[1], "friction_torque")));
  CHECK(split.steps.front().name == "viscosity level");
  CHECK(split.steps.front().change < 0.0);  // warmer oil
  // at the calibrated temperature isothermal cycles have the full friction, within their closure
  Case at = c;
  at.oil_temperature = all.sums.calibration.T;
  CHECK(value(converged(at, Tier::isothermal), "friction_torque") ==
        Approx(split.to).epsilon(5e-4));
}

TEST_CASE("AWarmUpOverCyclesEndsInThePeriodicState", "[cycle_heat]") {
  Case c = warm_cycle_case(1.5e3, 0.6);
  c.model.tier = Tier::thd;
  const CycleResult periodic = converged(c, Tier::thd);
  WarmUpOptions o;
  o.T_start = 293.15;
  const WarmUp run = warm_up(c, Tier::thd, o);
  INFO(app::reason_of(run.end.verdict));
  REQUIRE(run.end.verdict.good());
  CHECK(run.end.at_rest);
  const Instant& last = run.instants.back();
  // walls still move by 0.05 K over nearly half of all time
  CHECK(last.torque == Approx(value(periodic, "friction_torque")).epsilon(5e-3));
  CHECK(last.T_shell_max == Approx(value(periodic, "T_shell_max")).margin(0.2));
  CHECK(last.h_min == Approx(value(periodic, "h_min")).epsilon(5e-3));
  CHECK(std::abs(last.heat_in - last.heat_out - last.stored) < 0.01 * last.heat_in);
  double before = 0.0;
  for (const Instant& i : run.instants) {
    CHECK(i.T_shaft > before - 0.01);  // it only warms [K]
    before = i.T_shaft;
  }
  CHECK(run.instants.front().T_shaft < 294.0);
  Case event = c;
  event.cycle->period = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(warm_up(event, Tier::thd, o), InputError);
}

TEST_CASE("AWarmUpFromColdOilIsNotAtRestBeforeItsWallsAre", "[cycle_heat]") {
  // Walls 60 K below the oil in between: what that oil would lose by thinning is no measure of what
  // moves them.
  Case c = warm_case();
  c.model.tier = Tier::thd;
  c.model.grid = {24, 5};
  c.bearing = {0.02, 0.027, 20e-6, 313.15, {}};
  c.operation.omega = 3730.0 * kRpm;
  c.oil.temperature = rheology::ReynoldsSlope{0.027, 313.15, 0.035};
  c.shell->layers = {{steel(), 6.5e-3}};
  c.shell->back = ConvectiveBack{1000.0, 363.15};
  c.cycle = swinging(c, 3e3, 0.6);
  c.cycle->journal_mass = 12.0;
  const CycleResult periodic = converged(c, Tier::thd);
  WarmUpOptions o;
  o.T_start = 303.15;
  const WarmUp run = warm_up(c, Tier::thd, o);
  INFO(app::reason_of(run.end.verdict));
  REQUIRE(run.end.verdict.good());
  CHECK(run.end.at_rest);
  const Instant& last = run.instants.back();
  CHECK(last.torque == Approx(value(periodic, "friction_torque")).epsilon(5e-3));
  CHECK(last.T_shell_max == Approx(value(periodic, "T_shell_max")).margin(0.2));
  CHECK(run.instants.front().T_shell_max < 310.0);
}

TEST_CASE("WallsThatKeepTheHeatInFindTheirCycle", "[cycle_heat]") {
  // All that the cold oil makes would have to leave with the oil, 90 K above the supply and more
  // before it thins: walls that waited for it would boil it.
  Case c = warm_cycle_case(1.5e3, 0.0);
  c.bearing.radial_clearance = 15e-6;
  c.shell->back = ConvectiveBack{5.0, 303.15};
  c.shell->end_heat_transfer = 5.0;
  c.shaft->heat_transfer = 5.0;
  const CycleResult r = converged(c, Tier::thd);
  Case still = c;
  still.cycle.reset();
  still.model.tier = Tier::thd;
  const Quantities steady = solve(still).values();
  CHECK(value(r, "T_shell_max") == Approx(steady.T_shell_max).margin(0.1));
  CHECK(value(r, "friction_torque") == Approx(steady.friction_torque).epsilon(5e-3));
}

TEST_CASE("AHeldFilmAnswersItsWallsAsTheFilmWithItsHeatDoes", "[cycle_heat]") {
  // (1) of film_answer.hpp: what walls that are warmer change of the heat into each cell is, with
  // the flow held, the difference of two full solutions, the heat of the second as (2) has it. Of
  // two equal instants it is that of one.
  Case c = grooved_case();
  c.model.grid = {40, 7};
  const Solution s = solve_tier(c, Tier::thd);
  REQUIRE(s.verdict.good());
  const BearingModel& model = s.model;
  const FilmGrid& g = model.domain.grid;
  const int n = model.gl.n;
  Field shell(g.cells());
  std::vector<double> shaft(g.nz);
  for (int k = 0; k < g.cells(); ++k) shell[k] = 3.0 + 2.0 * std::sin(g.phi[k / g.nz]) + k % g.nz;
  for (int j = 0; j < g.nz; ++j) shaft[j] = 1.0 - 0.5 * j;
  const thermal::FilmEnergyProblem held = held_film(model, s.point, s.film);
  std::vector<double> T = s.film.columns.T, mixed;
  const auto heat = [&](double part) {
    thermal::FilmEnergyProblem p = lasting_film(model, s.point, s.film);
    if (part > 0.0) {  // between walls that were as they are, film and supplies had T and `mixed`
      p.thinning = held.thinning;
      for (std::size_t k = 0; k < T.size(); ++k) {
        p.heat[k] += p.thinning[k] * (T[k] - p.T_reference);
      }
      for (std::size_t v = 0; v < mixed.size(); ++v) {
        p.vessels[v].thinning = held.vessels[v].thinning;
        p.vessels[v].T_sheared = mixed[v];
      }
    }
    thermal::FilmEnergy film(std::move(p));
    for (int k = 0; k < g.cells(); ++k) {
      if (!meets_walls(model, k)) continue;
      T[static_cast<std::size_t>(k) * n] += part * shell[k];
      T[static_cast<std::size_t>(k) * n + n - 1] += part * shaft[k % g.nz];
    }
    for (int lap = 0; lap < 400; ++lap) film.sweep(T);
    mixed = film.mix_temperatures();
    return film.wall_heat(T);
  };
  const thermal::WallHeat cold = heat(0.0), warm = heat(1.0);
  FilmAnswer answer(model, {held, held});
  WallFlux q;
  for (int round = 0; round < 150; ++round) {
    q.shell.assign(g.cells(), 0.0);
    q.shaft.assign(g.nz, 0.0);
    answer.add_to(q, shell, shaft);
  }
  std::vector<double> ring(g.nz, 0.0);
  Field into(g.cells(), 0.0);
  for (int k = 0; k < g.cells(); ++k) {
    if (!meets_walls(model, k)) continue;
    into[k] = (warm.shell[k] - cold.shell[k]) / g.area(k);
    ring[k % g.nz] += (warm.shaft[k] - cold.shaft[k]) / (2.0 * kPi * g.radius * g.dz[k % g.nz]);
  }
  CHECK(largest_magnitude(into) > 100.0);  // [W/m2]
  CHECK(largest_difference(q.shell, into) < 1e-7 * largest_magnitude(into));
  CHECK(largest_difference(q.shaft, ring) < 1e-7 * largest_magnitude(ring));
}
