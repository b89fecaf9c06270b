/// A load cycle filled by hand: its numbers, and why it is refused.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "bearing/judge/judge_case.hpp"
#include "bearing/load_cycle.hpp"
#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "bearing/row_gaps.hpp"
#include "core/contract.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// A load of 1 to 3 kN that swings about the vertical, period 0.04 s.
Case cycle_case() {
  Case c = plain_case();
  c.operation.position = LoadGiven{};  // the cycle takes its place
  LoadCycle cycle;
  cycle.t = {0.0, 0.01, 0.02, 0.03};
  cycle.x = {0.0, 500.0, 0.0, -500.0};
  cycle.y = {-1000.0, -2000.0, -3000.0, -2000.0};
  cycle.period = 0.04;
  c.cycle = cycle;
  return c;
}

template <class Change>
Finding refusal(Change change) {
  Case c = cycle_case();
  change(*c.cycle);
  for (const Finding& f : judge(c)) {
    if (f.refused()) return f;
  }
  return {Gravity::unusual, "", "", ""};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("ALoadCycleFilledByHandIsTaken") {
  CHECK(judge(cycle_case()).empty());
  CHECK(possible_tiers(cycle_case()) == std::vector{Tier::isothermal, Tier::lumped});
}

TEST_CASE("AJournalThatItsLoadDoesNotMoveIsRefused") {
  const Finding heavy = refusal([](LoadCycle& cycle) { cycle.journal_mass = 1e15; });
  CHECK(heavy.key == "load_cycle.journal_mass");
  CHECK(holds(heavy.problem, "of the clearance"));
  // Free fall under the mean load through the clearance, in the cycles of a search.
  const double time = kMostCycles * 0.04;
  const double most = 0.5 * cycle_numbers(*cycle_case().cycle, -20.0).net * time * time / 30e-6;
  CHECK(refusal([&](LoadCycle& cycle) { cycle.journal_mass = 0.99 * most; }).key.empty());
  CHECK(refusal([&](LoadCycle& cycle) { cycle.journal_mass = 1.01 * most; }).refused());
}

TEST_CASE("StepsShorterThanAnyThatASearchTakesAreRefused") {
  CHECK(refusal([](LoadCycle& cycle) { cycle.step = 1e-9; }).key == "load_cycle.step");
  CHECK(refusal([](LoadCycle& cycle) { cycle.step = 1e-5; }).key.empty());
}

TEST_CASE("StepsTooLongForSecondOrderAreTold") {
  const auto told = [](double step) {
    Case c = cycle_case();
    c.cycle->step = step;
    const std::vector<Finding> found = judge(c);
    return std::any_of(found.begin(), found.end(), [](const Finding& f) {
      return f.key == "load_cycle.step" && !f.refused() && holds(f.problem, "square");
    });
  };
  CHECK(told(0.04));
  CHECK(told(0.04 / 23.0));
  CHECK_FALSE(told(0.04 / 25.0));
}

TEST_CASE("NumbersOfACycleAreThoseOfItsLines") {
  const CycleNumbers n = cycle_numbers(*cycle_case().cycle, -20.0);
  CHECK(n.length == 0.04);
  CHECK(n.largest == 3000.0);
  CHECK(n.at == 0.02);
  CHECK(n.angle == Approx(1.5 * kPi));
  CHECK(n.smallest == Approx(1000.0));
  const LoadCourse course(*cycle_case().cycle, -20.0);
  CHECK(n.net == Approx(std::hypot(course.impulse()[0], course.impulse()[1]) / 0.04).epsilon(1e-9));
  double mean = 0.0;  // of the magnitude, by its middle in each of many parts
  constexpr int kParts = 4000;
  for (int k = 0; k < kParts; ++k) {
    const LoadNow now = course.at((k + 0.5) * 0.04 / kParts);
    mean += std::hypot(now.x, now.y) / kParts;
  }
  CHECK(n.mean == Approx(mean).epsilon(1e-6));
  CHECK(n.mean_speed == Approx(-20.0));
  CHECK(n.largest_speed == Approx(20.0));
}

TEST_CASE("TheMeanLoadIsThatOfWhatIsSolvedNotThatOfTheRows") {
  // Along straight lines of both components the load falls between directions, or through zero.
  LoadCycle reverses = *cycle_case().cycle;
  reverses.x = {0.0, 0.0, 0.0, 0.0};
  reverses.y = {-1000.0, 1000.0, 1000.0, -1000.0};
  CHECK(cycle_numbers(reverses, 0.0).mean == Approx(750.0));  // two of four quarters halved
  CHECK(vanishing_load(reverses) == std::size_t{0});
  LoadCycle turns = *cycle_case().cycle;
  turns.x = {1000.0, 0.0, -1000.0, 0.0};
  turns.y = {0.0, 1000.0, 0.0, -1000.0};
  // the side of a square at distance q from its middle: q (sqrt 2 + asinh 1)/2
  const double q = 1000.0 / std::sqrt(2.0);
  const CycleNumbers square = cycle_numbers(turns, 0.0);
  CHECK(square.mean == Approx(0.5 * q * (std::sqrt(2.0) + std::asinh(1.0))));
  CHECK(square.smallest == Approx(q));
}

TEST_CASE("ASplineIsJudgedByWhatItGoesThroughNotByItsRows") {
  LoadCycle c = *cycle_case().cycle;
  c.interpolation = LoadInterpolation::periodic_spline;
  c.x = {0.0, 0.0, 0.0, 0.0};
  c.y = {-300.0, -300.0, -6000.0, -6000.0};  // between equal rows it swings beyond them
  const LoadCourse course(c, 0.0);
  double largest = 0.0, smallest = INFINITY;
  for (int k = 0; k < 40000; ++k) {
    const LoadNow now = course.at(k * 1e-6);
    largest = std::max(largest, -now.y);
    smallest = std::min(smallest, -now.y);
  }
  REQUIRE(smallest < 0.0);
  const CycleNumbers n = cycle_numbers(c, 0.0);
  // lines of a sixteenth: a cubic that swings by a tenth is within 1/256 of that
  CHECK(n.largest == Approx(largest).epsilon(1e-3));
  CHECK(course.largest_load() == n.largest);
  CHECK(vanishing_load(c) == std::size_t{0});
  c.interpolation = LoadInterpolation::linear;
  CHECK(cycle_numbers(c, 0.0).largest == 6000.0);
  CHECK_FALSE(vanishing_load(c));
}

TEST_CASE("ASpeedColumnGivesMeanAndLargestSpeed") {
  LoadCycle cycle = *cycle_case().cycle;
  cycle.omega = {100.0, 140.0, 100.0, 60.0};
  const CycleNumbers n = cycle_numbers(cycle, -20.0);
  CHECK(n.mean_speed == Approx(100.0));
  CHECK(n.mean_sliding == Approx(100.0));
  CHECK(n.largest_speed == Approx(140.0));
}

TEST_CASE("AJournalThatSwingsSlidesThoughItsMeanSpeedIsNone") {
  LoadCycle cycle = *cycle_case().cycle;
  cycle.omega = {100.0, -100.0, 100.0, -100.0};  // triangles about zero: half of their height
  const CycleNumbers even = cycle_numbers(cycle, -20.0);
  CHECK(even.mean_speed == Approx(0.0).margin(1e-12));
  CHECK(even.mean_sliding == Approx(50.0));
  cycle.omega = {300.0, -100.0, 300.0, -100.0};  // 300 over three quarters, 100 over one
  const CycleNumbers uneven = cycle_numbers(cycle, -20.0);
  CHECK(uneven.mean_speed == Approx(100.0));
  CHECK(uneven.mean_sliding == Approx(0.5 * (300.0 * 0.75 + 100.0 * 0.25)));
}

TEST_CASE("RowsThatMakeNoCycleAreRefused") {
  const auto said = [](auto change) {
    const Finding f = refusal(change);
    CHECK(f.key == "load_cycle.file");
    return f.words();
  };
  CHECK(holds(said([](LoadCycle& c) { c.x.pop_back(); }), "make no table"));
  CHECK(holds(said([](LoadCycle& c) { c.omega = {1.0}; }), "1 speeds"));
  CHECK(holds(said([](LoadCycle& c) { c.t = {0.0}, c.x = {1.0}, c.y = {1.0}; }), "two or more"));
  CHECK(holds(said([](LoadCycle& c) { c.y[2] = kNan; }), "row 2"));
  CHECK(holds(said([](LoadCycle& c) { std::swap(c.t[1], c.t[2]); }), "sort"));
  CHECK(holds(said([](LoadCycle& c) { c.t = {0.0, 0.01, 0.01, 0.01}; }), "third"));
  CHECK(holds(said([](LoadCycle& c) { c.t[0] = -0.01; }), "out of the period"));
  CHECK(holds(said([](LoadCycle& c) { c.t[3] = 0.04; }), "out of the period"));
  CHECK(holds(said([](LoadCycle& c) { c.x = c.y = {0.0, 0.0, 0.0, 0.0}; }), "zero throughout"));
}

TEST_CASE("PeriodMassAndStepAreNumbersThatCanBe") {
  const auto key = [](auto change) { return refusal(change).key; };
  CHECK(key([](LoadCycle& c) { c.period = 0.0; }) == "load_cycle.period");
  CHECK(key([](LoadCycle& c) { c.period = kNan; }) == "load_cycle.period");
  CHECK(key([](LoadCycle& c) { c.journal_mass = -1.0; }) == "load_cycle.journal_mass");
  CHECK(key([](LoadCycle& c) { c.journal_mass = INFINITY; }) == "load_cycle.journal_mass");
  CHECK(key([](LoadCycle& c) { c.step = 0.0; }) == "load_cycle.step");
  CHECK(key([](LoadCycle& c) { c.step = 0.05; }) == "load_cycle.step");
}

TEST_CASE("ASplineNeedsAPeriodAndNoJumps") {
  const auto spline = [](auto change) {
    const Finding f = refusal([&](LoadCycle& c) {
      c.interpolation = LoadInterpolation::periodic_spline;
      change(c);
    });
    return f.key;
  };
  CHECK(spline([](LoadCycle&) {}).empty());
  CHECK(spline([](LoadCycle& c) { c.period = INFINITY; }) == "load_cycle.interpolation");
  CHECK(spline([](LoadCycle& c) { c.t[2] = c.t[1]; }) == "load_cycle.interpolation");
  CHECK(spline([](LoadCycle& c) { c.t.resize(2), c.x.resize(2), c.y.resize(2); }) ==
        "load_cycle.interpolation");
}

TEST_CASE("ASplineThatSwingsToLoadsThatNobodyGaveIsRefused") {
  // The period a hundred times too long: one interval of 4 s beside three of 10 ms, over which the
  // load is said to stay.
  const auto far = [](LoadInterpolation how) {
    return refusal([how](LoadCycle& c) {
      c.interpolation = how;
      c.period = 4.0;
      c.x.back() = 0.0;
      c.y.back() = -1000.0;
    });
  };
  const Finding swung = far(LoadInterpolation::periodic_spline);
  CHECK(swung.key == "load_cycle.period");
  CHECK(holds(swung.problem, "times the largest row"));
  CHECK_FALSE(far(LoadInterpolation::linear).refused());
}

TEST_CASE("ALongStretchWithoutRowsIsRefusedUnlessTheLoadStays") {
  // The period a hundred times too long: one line of 3.97 s beside three of 10 ms.
  const auto far = [](double last) {
    return refusal([last](LoadCycle& c) {
      c.period = 4.0;
      c.x.back() = 0.0;
      c.y.back() = last;
    });
  };
  const Finding lost = far(-2000.0);
  CHECK(lost.key == "load_cycle.file");
  CHECK(holds(lost.words(), "from 0.03 s on no row tells the load for 3.97 s, 397 times"));
  CHECK_FALSE(far(-1000.0).refused());  // the load of the first row
}

TEST_CASE("AStretchIsMeasuredAgainstTheTableAndItsNeighbours") {
  const auto times = [](const std::vector<double>& t, double period) {
    const auto gaps = row_gaps(t, period);
    return gaps.empty() ? 0.0 : gaps.front().times;
  };
  CHECK(times({0.0, 1.0, 2.0, 3.0}, 44.0) == Approx(41.0));
  CHECK(times({0.0, 1.0, 2.0, 3.0}, INFINITY) == 0.0);            // an event ends with its last row
  CHECK(times({0.0, 1.0, 2.0, 3.0, 23.0}, 44.0) == 0.0);          // a row near half way
  CHECK(times({0.0, 1.0, 2.0, 6.0, 24.0}, 24.0) == Approx(4.5));  // beside one of four
  // A row at the seam of two periods, which every table has, is no row half way.
  CHECK(times({0.0, 20.0, 21.0, 22.0, 23.0}, 43.0) == Approx(20.0));
  CHECK(times({0.0, 1.0, 20.0, 21.0}, 40.0) == 0.0);  // half of all lines are long
  CHECK(times({0.0, 0.0, 1.0, 1.0}, 40.0) == 0.0);    // jumps are no stretches
  CHECK(times({0.0}, 40.0) == 0.0);
}

TEST_CASE("TwoCyclesAgreeOnceTheirRateIsKnown") {
  // Differences that shrink by rho leave rho/(1 - rho) of the last one to come.
  for (const double rho : {0.0, 0.5, 0.97}) {
    Closure closure;
    double left = 5e-5;  // of a periodic state that is 5e-5/(1 - rho) away
    closure.add(left);
    CHECK_FALSE(closure.closed());
    while (!closure.closed()) closure.add(left *= rho);
    CHECK(left * rho / (1.0 - rho) <= 1e-4);
  }
  Closure swings;  // 0.8 a cycle, large and small in turn: 2.8e-4 are to come behind the last one
  for (const double d : {5e-4, 1.1e-4, 3.2e-4, 0.704e-4}) {
    swings.add(d);
    CHECK_FALSE(swings.closed());
  }
  // A big end's: three differences tell that less is left than the last of them, two do not.
  Closure fast;
  for (const double d : {0.36, 5.6e-3}) fast.add(d);
  CHECK(fast.left() >= 5.6e-3);
  fast.add(3.4e-4);
  CHECK(fast.left() == Approx(3.4e-4 * 0.0607 / (1.0 - 0.0607)).epsilon(1e-2));
  CHECK(fast.closed());
  Closure same;
  same.add(1e-9);  // near whatever the rate
  CHECK(same.closed());
}

TEST_CASE("CyclesThatWereLedOnDrawNearNoFasterThanBefore") {
  // A mode of 0.9 per cycle, of which a little is left, beside one that is gone at once.
  Closure closure;
  closure.add(1e-2);
  closure.add(0.9e-2);
  closure.lead_on();
  closure.add(2e-3);
  closure.add(1e-4);              // alone it would tell of 0.05, and of 5e-6 to come
  CHECK_FALSE(closure.closed());  // 9e-4 may be to come
  closure.add(1.1e-5);
  CHECK(closure.closed());  // 9.9e-5
}

TEST_CASE("ALoadThatVanishesNeedsAMass") {
  const auto through_zero = [](LoadCycle& c) {
    c.x = {0.0, 0.0, 0.0, 0.0};
    c.y = {-1000.0, 500.0, 700.0, -200.0};  // between rows, never in one
  };
  const Finding f = refusal(through_zero);
  CHECK(f.key == "load_cycle.journal_mass");
  CHECK(holds(f.words(), "at 0 s the load vanishes"));
  CHECK(refusal([&](LoadCycle& c) {
          through_zero(c);
          c.journal_mass = 1.0;
        }).key.empty());
  CHECK(refusal([](LoadCycle& c) { c.x[1] = 1e-4, c.y[1] = 0.0; }).key ==
        "load_cycle.journal_mass");
  // A jump from one side to the other takes no time.
  CHECK(refusal([](LoadCycle& c) {
          c.t = {0.0, 0.01, 0.01, 0.03};
          c.x = {0.0, 0.0, 0.0, 500.0};
          c.y = {-1000.0, -1000.0, 1000.0, 1000.0};
        }).key.empty());
  // From the last row the load returns to the first.
  CHECK(refusal([](LoadCycle& c) {
          c.x = {0.0, 500.0, 500.0, 0.0};
          c.y = {-1000.0, -1000.0, 1000.0, 1000.0};
        }).key == "load_cycle.journal_mass");
}

TEST_CASE("AJournalAtRestIsJudgedByTheCycle") {
  Case c = cycle_case();
  c.operation.omega = 0.0;  // squeezed only, and by a load that never lets go
  REQUIRE(judge(c).size() == 1);
  CHECK_FALSE(judge(c).front().refused());
  CHECK(holds(judge(c).front().problem, "with 1000 N or more all the time"));
  Case fed = c;  // 20 bar on 50 mm x 25 mm lift 2.5 kN
  fed.supplies.front().pressure = 20e5;
  CHECK(judge(fed).empty());
  Case round = c;  // goes round: its mean is none
  round.cycle->x = {1000.0, 0.0, -1000.0, 0.0};
  round.cycle->y = {0.0, 1000.0, 0.0, -1000.0};
  CHECK(judge(round).empty());
  c.cycle->y = {1500.0, -2000.0, -3000.0, -2000.0};  // lets go
  CHECK(judge(c).empty());
  c.cycle->y[2] = -1e9;
  CHECK(judge(c).front().key == "load_cycle.file");
  c = cycle_case();
  c.operation.position = EccentricityGiven{0.5, 0.5, 0.0};
  CHECK(judge(c).front().key == "operation.eccentricity_ratio");
}

TEST_CASE("TiersTakeACycleAsTheyTakeASteadyLoad") {
  CHECK_FALSE(lack_for(cycle_case(), Tier::estimate));
  CHECK_FALSE(lack_for(cycle_case(), Tier::automatic));
  CHECK(lack_for(cycle_case(), Tier::thd)->key == "shell");  // as without a cycle
}

TEST_CASE("ALoadThatTurnsWithTheFilmIsTold") {
  // Two turns of the journal, in which the load makes 2 f; at f = 1/2 oil is not dragged under it.
  const auto told = [](double f, double omega, auto load) {
    Case c = plain_case();
    c.operation.position = LoadGiven{};
    c.operation.omega = omega;
    LoadCycle cycle;
    cycle.period = 4.0 * kPi / std::abs(omega);
    for (int k = 0; k < 120; ++k) {
      const double turned = 4.0 * kPi * k / 120.0 * (omega > 0.0 ? 1.0 : -1.0);
      cycle.t.push_back(cycle.period * k / 120.0);
      cycle.x.push_back(load(k) * std::cos(f * turned));
      cycle.y.push_back(load(k) * std::sin(f * turned));
    }
    c.cycle = cycle;
    for (const Finding& finding : judge(c)) {
      CHECK_FALSE(finding.refused());
      if (holds(finding.problem, "half the speed")) return finding.problem;
    }
    return std::string();
  };
  const auto steady = [](int) { return 1000.0; };
  for (const double omega : {300.0, -300.0}) {
    CHECK(holds(told(0.5, omega, steady), "all the time"));
    for (const double f : {-0.5, 0.0, 1.0, 1.5}) CHECK(told(f, omega, steady).empty());
    // A stretch of 1.5 turns that goes on over the end of the period, and one of half a turn.
    const auto part = [&](int turns) {
      return told(0.5, omega, [turns](int k) { return (k + 15) % 120 < turns ? 1000.0 : 100.0; });
    };
    CHECK(holds(part(91), "1.5 revolutions"));
    CHECK(part(31).empty());
  }
}

TEST_CASE("CyclesFarApartTellWhatIsStillToCome") {
  // Differences that fall by rho from cycle to cycle: n of them come to (1 - rho^n)/(1 - rho), and
  // rho^n/(1 - rho) is left. With no rate up to 0.99 is more left than is told.
  for (const double rho : {0.5, 0.9, 0.97, 0.99}) {
    for (const int n : {kApart, 2 * kApart, 100}) {
      const double apart = (1.0 - std::pow(rho, n)) / (1.0 - rho);
      CHECK(left_after(apart, n) >= std::pow(rho, n) / (1.0 - rho));
    }
  }
  // Steps chosen anew, which differ by 1e-5 however long one waits, end below kClosed.
  CHECK(left_after(1e-5, kApart) < kClosed);
}
