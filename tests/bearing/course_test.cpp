// A course of speeds: bodies carried over, films begun anew.
#include "bearing/over_time/course.hpp"

#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/cycle.hpp"
#include "bearing/steady/solve.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Case coarse_course() {
  Case c = warm_case();
  c.model.tier = Tier::thd;
  c.model.grid = {48, 6};
  return c;
}

Case at_speed(Case c, double part) {
  c.operation.omega *= part;
  return c;
}

/// The steady load of the case as a cycle that does not swing.
Case as_cycle(Case c) {
  const auto load = std::get<LoadGiven>(c.operation.position);
  LoadCycle cycle;
  cycle.period = 4.0 * kPi / std::abs(c.operation.omega);
  cycle.t = {0.0, 0.5 * cycle.period};
  cycle.x.assign(2, load.force * std::cos(load.angle));
  cycle.y.assign(2, load.force * std::sin(load.angle));
  cycle.journal_mass = 0.5;
  c.cycle = cycle;
  return c;
}

CourseRun passed(const std::vector<Stretch>& stretches) {
  WarmUpOptions o;
  o.T_start = 313.15;
  const CourseRun run = run_course(stretches, Tier::thd, o);
  INFO(app::reason_of(run.end.verdict));
  REQUIRE(run.end.verdict.good());
  REQUIRE(run.ends.size() == stretches.size());
  return run;
}

}  // namespace

TEST_CASE("AStretchThatIsCutInTwoEndsTheSame", "[course]") {
  const Case c = coarse_course();
  const CourseRun whole = passed({{c, 120.0}});
  const CourseRun halves = passed({{c, 60.0}, {c, 60.0}});
  CHECK(halves.instants.back().t == Approx(120.0));
  // each march allows itself 0.2 K a step
  CHECK(halves.instants.back().T_shaft == Approx(whole.instants.back().T_shaft).margin(0.5));
  CHECK(halves.instants.back().torque == Approx(whole.instants.back().torque).epsilon(5e-3));
}

TEST_CASE("ARunDownIsWarmerThanTheRunUpUnlessItIsSlow", "[course]") {
  const Case slow = at_speed(coarse_course(), 0.5);
  const Case fast = coarse_course();
  const auto warmer = [&](double hold) {
    const CourseRun run = passed({{slow, hold}, {fast, hold}, {slow, hold}});
    const auto shaft = [&](std::size_t k) { return run.instants[run.ends[k]].T_shaft; };
    CHECK(shaft(1) > shaft(0));
    return shaft(2) - shaft(0);
  };
  CHECK(warmer(30.0) > 0.5);  // [K]; the bodies take minutes
  // after hours nothing is left of the past but what a march leaves at rest
  CHECK(std::abs(warmer(1e5)) < 0.02);
}

TEST_CASE("ACourseOverCyclesThatDoNotSwingIsTheSteadyOne", "[course]") {
  const Case slow = at_speed(coarse_course(), 0.5);
  const Case fast = coarse_course();
  constexpr double kHold = 200.0;
  const CourseRun steady = passed({{slow, kHold}, {fast, kHold}});
  const CourseRun cycles = passed({{as_cycle(slow), kHold}, {as_cycle(fast), kHold}});
  CHECK(cycles.imbalance_at_ends() < 0.02);  // the film changes while the walls move
  for (std::size_t k = 0; k < 2; ++k) {
    const Instant& a = steady.instants[steady.ends[k]];
    const Instant& b = cycles.instants[cycles.ends[k]];
    // a sixteenth of a stretch a step, of first order: some per cent of the change within it
    CHECK(b.t == Approx((static_cast<double>(k) + 1.0) * kHold));
    CHECK(b.T_shaft == Approx(a.T_shaft).margin(1.0));
    CHECK(b.torque == Approx(a.torque).epsilon(0.02));
  }
}

TEST_CASE("AWarmUpOverACycleThatStandsStillIsThatOfItsLoad", "[course]") {
  // Bodies that see the heat of a film which still warms with its walls get too little: friction
  // would be 1.5 % high then, and the heat told as stored a third more than they take. Steps of 2 K
  // leave the rest.
  WarmUpOptions o;
  o.T_start = 293.15;
  o.end = 150.0;
  const WarmUp steady = warm_up(coarse_course(), Tier::thd, o);
  const WarmUp cycles = warm_up(as_cycle(coarse_course()), Tier::thd, o);
  REQUIRE(steady.end.verdict.good());
  REQUIRE(cycles.end.verdict.good());
  const auto stored = [](const WarmUp& run) {
    double sum = 0.0;
    for (const Instant& i : run.instants) sum += i.dt * i.stored;
    return sum;
  };
  const Instant& a = steady.instants.back();
  const Instant& b = cycles.instants.back();
  CHECK(b.t == Approx(a.t));
  CHECK(b.T_shaft == Approx(a.T_shaft).margin(0.3));
  CHECK(b.torque == Approx(a.torque).epsilon(0.01));  // 0.3 K of 3.5 % per kelvin
  CHECK(stored(cycles) == Approx(stored(steady)).epsilon(0.01));
  // Bodies that took what each step foresaw held 2 % of the heat made too much.
  CHECK(cycles.imbalance() < 5e-3);
}

TEST_CASE("AWarmUpOverCyclesRestsWhereItsLoadLeads", "[course]") {
  // Thin film under the load, thick film beside it: a step that took the answer of the thinnest for
  // all cells moved those of thick film by some per cent of what they lacked, and hours later the
  // walls stood 1 K colder than where they go.
  Case c = rig_case();
  c.bearing = {0.033, 0.024, 33e-6, 373.15, {}};
  c.supplies[0].diameter = 6e-3;
  c.supplies[0].pressure = 3e5;
  c.operation.omega = 2000.0 * kPi / 30.0;
  set_load(c, 20e3);
  c.shell->housing->outer_radius = 0.05;
  c.shaft->overhang = 0.01;
  c.shaft->heat_transfer = 100.0;
  c.model.tier = Tier::thd;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {24, 5};
  const CycleResult periodic = solve_cycle(as_cycle(c), Tier::thd);
  REQUIRE(periodic.verdict.good());
  WarmUpOptions o;
  o.T_start = 353.15;
  const WarmUp run = warm_up(as_cycle(c), Tier::thd, o);
  INFO(app::reason_of(run.end.verdict));
  REQUIRE(run.end.verdict.good());
  CHECK(run.end.at_rest);
  CHECK(run.instants.back().t < 1e4);  // the bodies take minutes
  // what walls at rest may still move by, thrice
  CHECK(run.instants.back().T_shell_max == Approx(value_of(periodic, "T_shell_max")).margin(0.15));
  CHECK(run.instants.back().torque == Approx(value_of(periodic, "friction_torque")).epsilon(3e-3));
}

TEST_CASE("HeatThatDiesAwayIsTakenAtItsMean") {
  // (1) of march_over_cycles.hpp: the exact mean of what backward Euler halves in one step,
  // exp(-x) with 1/(1 + x) = 1/2
  CHECK(mean_that_dies_away(1.0, 0.5) == Approx(1.0 - std::exp(-1.0)));
  CHECK(mean_that_dies_away(-1.0, -0.5) == Approx(std::exp(-1.0) - 1.0));
  // short steps: the trapezoid, to second order in what is left; long ones: the end
  CHECK(mean_that_dies_away(1.0, 0.99) == Approx(0.995).epsilon(1e-4));
  CHECK(mean_that_dies_away(1.0, 1e-6) == Approx(1e-6).epsilon(1e-4));
  // it grows: the trapezoid; another sign: the end
  CHECK(mean_that_dies_away(1.0, 10.0) == Approx(5.5));
  CHECK(mean_that_dies_away(1.0, 1.0) == 1.0);
  CHECK(mean_that_dies_away(1.0, -0.1) == -0.1);
}

TEST_CASE("AnInstantOverCyclesIsThatOfTheWallsOfThen", "[course]") {
  const CourseRun steady = passed({{coarse_course(), 200.0}});
  const CourseRun cycles = passed({{as_cycle(coarse_course()), 200.0}});
  // Torque against the shaft's temperature, straight between the instants of the steady run.
  const auto torque_at = [&](double T) {
    for (std::size_t k = 1; k < steady.instants.size(); ++k) {
      const Instant& a = steady.instants[k - 1];
      const Instant& b = steady.instants[k];
      if (a.T_shaft <= T && T <= b.T_shaft) {
        return a.torque + (T - a.T_shaft) / (b.T_shaft - a.T_shaft) * (b.torque - a.torque);
      }
    }
    return double{NAN};
  };
  int compared = 0;
  for (const Instant& i : cycles.instants) {
    const double torque = torque_at(i.T_shaft);
    if (!(i.t > 10.0) || std::isnan(torque)) continue;  // shell and shaft warm in another ratio
    INFO(i.t << " s");
    CHECK(i.torque == Approx(torque).epsilon(5e-3));
    CHECK(std::abs(i.heat_in - i.heat_out - i.stored) < 0.02 * i.heat_in);
    ++compared;
  }
  CHECK(compared > 5);
}

TEST_CASE("ACourseIsOfOneBearing", "[course]") {
  const Case c = coarse_course();
  const auto refused = [](const std::vector<Stretch>& stretches, Tier tier = Tier::thd) {
    CHECK_THROWS_AS(run_course(stretches, tier, {}), InputError);
  };
  refused({});
  refused({{c, 0.0}});
  refused({{c, std::numeric_limits<double>::infinity()}});
  refused({{c, 1.0}}, Tier::isothermal);
  Case wider = c;
  wider.bearing.width *= 1.1;
  refused({{c, 1.0}, {wider, 1.0}});
  Case finer = c;
  finer.model.grid = {60, 6};
  refused({{c, 1.0}, {finer, 1.0}});
  Case event = as_cycle(c);
  event.cycle->period = std::numeric_limits<double>::infinity();
  refused({{event, 1.0}});
}
