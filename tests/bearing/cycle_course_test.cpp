// Load cycles whose load or speed jumps, vanishes or reverses, single events, and cycles that are
// interrupted.
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "bearing/over_time/cycle.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"
#include "tests/bearing/pulsed_case.hpp"
#include "tests/bearing/solved.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

TEST_CASE("FilmsAreKeptAtTheInstantsThatTheCaseGives", "[cycle]") {
  Case c = pulsed_case();
  c.model.grid = {24, 5};
  const double degree = kDegree / c.cycle->crank_speed;
  // Not where steps end by themselves; the beginning counts, and so does the end.
  c.cycle->fields_at = {0.0, 123.4 * degree, 361.7 * degree, c.cycle->period};
  const CycleResult r = converged(c);
  REQUIRE(r.frames.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    INFO("instant " << k);
    CHECK(r.frames[k].t == Approx(c.cycle->fields_at[k]).margin(1e-12 * r.period));
  }
  // The cycle ends as it begins, to its closure.
  CHECK(largest(r.frames[3].p) == Approx(largest(r.frames[0].p)).epsilon(1e-2));
}

TEST_CASE("FilmsAreKeptFromEndToEndOfThePeriod", "[cycle]") {
  for (const bool coarse : {false, true}) {
    Case c = pulsed_case();
    c.model.grid = {24, 5};
    if (coarse) c.cycle->step = c.cycle->period / 24.0;  // longer than from one film to the next
    const CycleResult r = converged(c);
    REQUIRE(r.frames.size() >= 20);
    CHECK(r.frames.size() <= 49);
    CHECK(r.frames.front().t == 0.0);
    CHECK(r.frames.back().t == Approx(r.period).epsilon(1e-12));
    for (std::size_t k = 1; k < r.frames.size(); ++k) CHECK(r.frames[k].t > r.frames[k - 1].t);
    CHECK(largest(r.frames.back().p) == Approx(largest(r.frames.front().p)).epsilon(1e-2));
  }
}

TEST_CASE("AfterAJumpOfTheLoadStepsBeginAnew", "[cycle]") {
  Case c = pulsed_case();
  const double T = c.cycle->period;
  LoadCycle jump;
  jump.t = {0.0, 0.5 * T, 0.5 * T, T};
  jump.x = {0.0, 0.0, 500.0, 500.0};
  jump.y = {-1e3, -1e3, -4e3, -4e3};
  jump.period = T;
  jump.journal_mass = 0.5;
  jump.t.pop_back();  // the second half holds until the jump back at the end of the period
  jump.x.pop_back();
  jump.y.pop_back();
  jump.t.push_back(T);
  jump.x.push_back(500.0);
  jump.y.push_back(-4e3);
  c.cycle = jump;
  const CycleResult r = converged(c);
  for (std::size_t k = 1; k < r.instants.size(); ++k) {
    const double begun = r.instants[k].t - r.instants[k].dt;
    const bool after = begun < 1e-9 * T || std::abs(begun - 0.5 * T) < 1e-9 * T;
    if (after) CHECK(r.instants[k].dt * c.operation.omega <= 0.1001 * kDegree);
    CHECK(!(begun < (0.5 - 1e-9) * T && r.instants[k].t > (0.5 + 1e-9) * T));  // none across it
  }
  CHECK(r.audit.impulse < 1e-6);
}

TEST_CASE("ALoadMayPassThroughZero", "[cycle]") {
  Case c = pulsed_case();
  c.cycle = over_two_turns(c, [](double a) { return Load{0.0, -3e3 * std::sin(a)}; });
  for (const double mass : {0.01, 1.0, 100.0}) {  // [kg]
    c.cycle->journal_mass = mass;
    const CycleResult r = converged(c);
    // Each stage balances the load to 1e-5 of its largest, of which the mean is 2/pi.
    CHECK(r.audit.impulse < 0.5 * kPi * 1e-5);
    CHECK(r.audit.load < 1e-4);
  }
}

TEST_CASE("AHeavyJournalPassesTheInstantAtWhichNothingTurnsNorPresses", "[cycle]") {
  // Its inertia over a short step is so stiff that its place, known to sixteen digits, leaves a
  // force open that is large to a load which passes through zero with the speed.
  Case c = plain_case();
  c.bearing = {0.011, 0.011, 20e-6, 293.15, {}};
  c.supplies[0].kind = SupplyKind::circumferential_groove;
  c.supplies[0].arc = 2.0 * kPi;
  c.supplies[0].length = 0.002;
  c.oil.temperature = rheology::ConstantViscosity{0.0015};
  c.model.cavitation_pressure = -0.99e5;
  c.model.grid = {48, 8};
  LoadCycle event;
  for (int k = 0; k <= 360; ++k) {
    const double a = 2.0 * kPi * k / 360;
    event.t.push_back(0.03 * k / 360);
    event.x.push_back(0.3 * std::sin(a));
    event.y.push_back(-1.4 * std::cos(a));
    event.omega.push_back(500.0 * kRpm * std::cos(a));
  }
  for (const double mass : {200.0, 1000.0}) {
    event.journal_mass = mass;
    std::vector<double> h_min;
    for (const double step : {0.1e-3, 0.05e-3}) {  // neither divides the time between two rows
      event.step = step;
      for (const bool sliver : {false, true}) {  // two instants that a step of 1e-10 s lies between
        event.fields_at = {0.0225};
        if (sliver) event.fields_at.push_back(0.0225 + 1e-10);
        c.cycle = event;
        const CycleResult r = converged(c);
        CHECK(r.audit.impulse < 1e-4);
        for (const CycleInstant& i : r.instants) CHECK(i.dt <= step * (1.0 + 1e-9));
        h_min.push_back(value(r, "h_min"));
      }
      CHECK(h_min.back() == Approx(h_min[h_min.size() - 2]).epsilon(1e-6));
    }
    // second order: half the step leaves a fourth of an error of some 1e-4
    CHECK(h_min.back() == Approx(h_min.front()).epsilon(1e-3));
  }
}

TEST_CASE("AnInterruptedCycleKeepsWhatItHas", "[cycle]") {
  const Case c = pulsed_case();
  std::atomic<bool> stop = false;
  SolveControl control;
  control.stop = &stop;
  int steps = 0;
  control.progress = [&](const Progress&) { stop = ++steps > 20; };
  const CycleResult r = solve_cycle(c, Tier::isothermal, control);
  CHECK(r.verdict.status == Status::interrupted);
  CHECK(r.instants.size() > 20);
}

TEST_CASE("ACycleInterruptedInItsSecondRoundKeepsTheFirstWhole", "[cycle]") {
  const Case c = pulsed_case();
  std::atomic<bool> stop = false;
  SolveControl control;
  control.stop = &stop;
  double told = 0.0;
  int rounds = 0;
  control.progress = [&](const Progress& p) {
    rounds += p.residual < told;
    told = p.residual;
    stop = rounds == 1 && told > 0.5;
  };
  const CycleResult r = solve_cycle(c, Tier::isothermal, control);
  CHECK(r.verdict.status == Status::interrupted);
  CHECK(r.cycles == 1);
  CHECK(r.instants.back().t == Approx(c.cycle->period));
  CHECK(r.audit.mass < 1e-12);  // of the round that was ended
  CHECK(r.audit.impulse < 1e-4);
}

TEST_CASE("AnEventWithoutAnyEventStaysAsItBegins", "[cycle]") {
  // A hole opposite to the load: its flow depends on the oil that comes round.
  Case c = hole_case();
  set_load(c, 2e3);
  LoadCycle event;
  event.t = {0.0, 0.03};
  event.x = {0.0, 0.0};
  event.y = {-2e3, -2e3};
  c.cycle = event;
  const CycleResult r = converged(c);
  Case still = c;
  still.cycle.reset();
  const Quantities steady = solve(still).values();
  for (const CycleInstant& i : r.instants) {
    if (i.dt == 0.0) continue;  // flows are means over the step that leads there
    // Newton's tolerance of a step, a hundredth of the error of 1e-3 that one may have
    CHECK(i.supply_flow == Approx(steady.supply_flow).epsilon(1e-4));
    CHECK(i.side_flow == Approx(steady.side_flow).epsilon(1e-3));
    CHECK(i.torque == Approx(steady.friction_torque).epsilon(1e-4));
  }
}

TEST_CASE("AnEventBeginsWithItsFirstRowWhateverItsClock", "[cycle]") {
  Case c = pulsed_case();
  LoadCycle event;
  event.t = {0.0, 0.01, 0.015, 0.02};
  event.x = {0.0, 0.0, 0.0, 0.0};
  event.y = {-1e3, -1e3, -3e3, -1e3};
  event.journal_mass = 0.5;
  c.cycle = event;
  const CycleResult a = converged(c);
  for (double& t : c.cycle->t) t += 7.0;
  const CycleResult b = converged(c);
  CHECK(value(b, "h_min") == Approx(value(a, "h_min")).epsilon(1e-6));
  CHECK(named(b, "h_min").at == Approx(named(a, "h_min").at).epsilon(1e-6));
  set_load(c, 1e3);
  const Quantities steady = steady_values(c);
  CHECK(a.instants[1].h_min == Approx(steady.h_min).epsilon(1e-4));  // it begins at rest
}

TEST_CASE("AJumpAtTheEndOfThePeriodIsOneAtItsBeginning", "[cycle]") {
  Case c = pulsed_case();
  const double T = c.cycle->period;
  LoadCycle jump;
  jump.t = {0.0, 0.0, 0.5 * T};
  jump.x = {0.0, 0.0, 0.0};
  jump.y = {-3e3, -1e3, -2e3};  // from 2 to 3 kN, and at once down to 1
  jump.period = T;
  jump.journal_mass = 0.5;
  c.cycle = jump;
  const LoadCourse course(jump, 1.0);
  CHECK(course.at(0.0).y == Approx(-1e3));
  CHECK(course.at(T, true).y == Approx(-3e3).epsilon(1e-6));
  CHECK(course.at(3.0 * T, true).y == Approx(-3e3).epsilon(1e-6));
  CHECK(course.impulse()[1] == Approx(-2e3 * T));
  const CycleResult r = converged(c);
  CHECK(r.instants[1].dt * c.operation.omega <= 0.1001 * kDegree);
  CHECK(r.audit.impulse < 1e-4);
}

TEST_CASE("SpeedMayPassThroughZero", "[cycle]") {
  Case c = pulsed_case();
  LoadCycle turn;
  const double T = 0.2;
  turn.t = {0.0, 0.25 * T, 0.75 * T};
  turn.x = {0.0, 0.0, 0.0};
  turn.y = {-500.0, -500.0, -500.0};
  turn.omega = {100.0, 200.0, -200.0};
  turn.period = T;
  turn.journal_mass = 0.5;
  c.cycle = turn;
  const CycleResult r = converged(c);
  const auto torque = [&](bool forward) {
    double most = 0.0;
    for (const CycleInstant& i : r.instants) {
      if ((i.omega > 0.0) == forward) most = std::max(most, std::abs(i.torque));
    }
    return most;
  };
  CHECK(torque(true) > 0.0);
  CHECK(torque(false) > 0.0);
  CHECK(r.audit.impulse < 1e-4);
  // Seen in a mirror through the load, the journal turns the other way.
  for (double& omega : c.cycle->omega) omega = -omega;
  c.supplies[0].angle = kPi - c.supplies[0].angle;
  const CycleResult mirrored = converged(c);
  CHECK(value(mirrored, "h_min") == Approx(value(r, "h_min")).epsilon(2e-4));  // of two closures
  CHECK(value(mirrored, "friction_torque") ==
        Approx(-value(r, "friction_torque")).margin(2e-4 * torque(true)));
}

TEST_CASE("TiersThatCannotServeACycleSaySo", "[cycle]") {
  CHECK_THROWS_AS(solve_cycle(pulsed_case(), Tier::tehd), InputError);
}

TEST_CASE("APulseOfASplineIsNotPassedOver", "[cycle]") {
  // 10 kN for 1.5 degrees of 720 over 1 kN: shorter than half a step, whose error says nothing of a
  // film that has not moved yet. As straight lines through the same rows, on which steps end.
  Case c = plain_case();
  c.model.grid = {36, 6};
  double known = 0.0;
  for (const double tolerance : {0.01, 0.1}) {
    c.model.tolerance = tolerance;
    for (const double place : {205.0, 207.0, 210.0, 213.0}) {
      LoadCycle cycle;
      cycle.crank_speed = std::abs(c.operation.omega);
      cycle.period = 4.0 * kPi / cycle.crank_speed;
      cycle.journal_mass = 0.5;
      const double row = place < 210.0 ? 0.375 : 0.01;  // degrees; close rows bend little each
      for (double degrees = 0.0; degrees < 720.0;) {
        const double from = degrees - place;
        cycle.t.push_back(degrees * kDegree / cycle.crank_speed);
        cycle.x.push_back(0.0);
        cycle.y.push_back(-1e3 - 1e4 * std::exp(-4.0 * std::log(2.0) * from * from / 2.25));
        const bool near = from > -6.0 && from < 6.0;
        degrees += near ? row : 5.0;
      }
      c.cycle = cycle;
      const CycleResult lines = solve_cycle(c, Tier::isothermal);
      c.cycle->interpolation = LoadInterpolation::periodic_spline;
      const CycleResult spline = solve_cycle(c, Tier::isothermal);
      INFO(place << " degrees, " << tolerance << ": " << spline.steps << " steps");
      REQUIRE((lines.verdict.good() && spline.verdict.good()));
      // when in the period it comes changes nothing, nor by how many rows it is told
      if (!(known > 0.0)) known = value_of(lines, "p_max");
      CHECK(value_of(lines, "p_max") == Approx(known).epsilon(0.05));
      // a spline through rows of a quarter of the pulse's width rises a few per cent above lines
      CHECK(value_of(spline, "p_max") == Approx(value_of(lines, "p_max")).epsilon(0.1));
      CHECK(value_of(spline, "h_min") == Approx(value_of(lines, "h_min")).epsilon(0.02));
      // A step that is given goes over it, and says so; one of half its width does not.
      for (const double degrees : {6.0, 0.5}) {
        c.cycle->step = degrees * kDegree / cycle.crank_speed;
        if (degrees < 1.0 && place != 207.0) continue;
        const CycleResult given = solve_cycle(c, Tier::isothermal);
        REQUIRE(given.verdict.good());
        CHECK(std::any_of(given.warnings.begin(), given.warnings.end(), [](const Note& n) {
                return std::holds_alternative<note::LoadMissed>(n);
              }) == (degrees > 1.0));
      }
    }
  }
}

TEST_CASE("AtRestASplineOfSpeedHasCornersAsLinesHave", "[cycle]") {
  LoadCycle cycle;
  cycle.period = 1.0;
  for (int k = 0; k < 24; ++k) {
    cycle.t.push_back(k / 24.0);
    cycle.x.push_back(0.0);
    cycle.y.push_back(-1e3);
    cycle.omega.push_back(100.0 * std::sin(2.0 * kPi * (k + 0.3) / 24.0));
  }
  cycle.interpolation = LoadInterpolation::periodic_spline;
  const LoadCourse course(cycle, 0.0, 0.1);
  int rests = 0;
  for (const LoadCorner& corner : course.corners()) {
    if (!std::isinf(corner.slope_change)) continue;
    ++rests;
    CHECK(std::abs(course.at(corner.t).omega) <= 0.1 + 0.05);  // lines of a 16th of a row's way
  }
  CHECK(rests == 6);  // at rest and slow to either side, twice
}

TEST_CASE("LoadsBetweenRowsAreLinesOrSplines", "[cycle]") {
  LoadCycle cycle;
  cycle.t = {0.0, 1.0, 1.0, 3.0};
  cycle.x = {0.0, 2.0, 4.0, 0.0};
  cycle.y = {0.0, 0.0, 0.0, 0.0};
  cycle.period = 4.0;
  const LoadCourse lines(cycle, 7.0);
  CHECK(lines.at(0.5).x == Approx(1.0));
  CHECK(lines.at(1.0).x == Approx(4.0));
  CHECK(lines.at(1.0, true).x == Approx(2.0));
  CHECK(lines.at(2.0).x == Approx(2.0));
  CHECK(lines.at(3.5).x == Approx(0.0));
  CHECK(lines.at(4.5).x == Approx(1.0));
  CHECK(lines.at(0.5).omega == 7.0);
  CHECK(lines.largest_load() == 4.0);
  int jumps = 0;
  for (const LoadCorner& corner : lines.corners()) jumps += corner.jump;
  CHECK(jumps == 1);
  LoadCycle wave;
  wave.period = 2.0 * kPi;
  for (int k = 0; k < 36; ++k) {
    wave.t.push_back(wave.period * k / 36);
    wave.x.push_back(std::sin(wave.t.back()));
    wave.y.push_back(0.0);
  }
  wave.interpolation = LoadInterpolation::periodic_spline;
  const LoadCourse smooth(wave, 1.0);
  // What the wave bends from row to row: no jump, and no step shorter than its rows.
  CHECK(smooth.corners().size() == 36);
  for (const LoadCorner& corner : smooth.corners()) {
    CHECK_FALSE(corner.jump);
    CHECK(corner.slope_change <= 1.01 * wave.period / 36);
  }
  for (double t = 0.03; t < 12.0; t += 0.1) CHECK(std::abs(smooth.at(t).x - std::sin(t)) < 1e-5);
}
