// Bars of warm-ups and courses: what shorter steps and a finer grid give lies within them.
#include "fidelity/march_bars.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/words/ending_words.hpp"
#include "fidelity/solve.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Case coarse() {
  Case c = warm_case();
  c.model.tier = Tier::thd;
  c.model.grid = {48, 8};
  return c;
}

WarmUpOptions until(double end) {
  WarmUpOptions o;
  o.T_start = 293.15;
  o.end = end;
  return o;
}

/// Of a followed value at time t, a parabola through three instants.
double at(const std::vector<Instant>& run, double Instant::*value, double t) {
  std::size_t k = 1;
  while (k + 2 < run.size() && run[k].t < t) ++k;
  const Instant &a = run[k - 1], &b = run[k], &c = run[k + 1];
  return a.*value * (t - b.t) * (t - c.t) / ((a.t - b.t) * (a.t - c.t)) +
         b.*value * (t - a.t) * (t - c.t) / ((b.t - a.t) * (b.t - c.t)) +
         c.*value * (t - a.t) * (t - b.t) / ((c.t - a.t) * (c.t - b.t));
}

}  // namespace

TEST_CASE("BarsOfAWarmUpHoldShorterStepsAndAreOfTheirSize", "[transient]") {
  // Bars of time are 1.5 times what doubled steps tell of the error: nine of ten hold, and half of
  // them are shorter than five times the error.
  Case c = coarse();
  const WarmUp run = warm_up(c, Tier::thd, until(60.0));
  const fidelity::MarchBars bars = fidelity::march_bars(c, until(60.0), run);
  REQUIRE(bars.time.size() == run.instants.size());
  c.model.tolerance = 3e-4;
  const std::vector<Instant> fine = warm_up(c, Tier::thd, until(61.0)).instants;
  int judged = 0, held = 0;
  std::vector<double> longer;
  for (std::size_t k = 0; k < run.instants.size(); ++k) {
    const Instant& i = run.instants[k];
    if (i.t < 0.5) continue;  // hot oil first meets cold walls: no step is short enough
    for (double Instant::*value : {&Instant::torque, &Instant::T_shell_max, &Instant::T_shaft}) {
      const double off = std::abs(i.*value - at(fine, value, i.t));
      ++judged;
      held += bars.time[k].*value >= off ? 1 : 0;
      longer.push_back(bars.time[k].*value / off);
    }
  }
  REQUIRE(judged >= 30);
  CHECK(held >= 0.85 * judged);
  std::nth_element(longer.begin(), longer.begin() + judged / 2, longer.end());
  CHECK(longer[judged / 2] < 5.0);
}

TEST_CASE("BarsOfAWarmUpEndAsThoseOfTheSteadyState", "[transient]") {
  const Case c = coarse();
  const WarmUpOptions o = until(INFINITY);
  const WarmUp run = warm_up(c, Tier::thd, o);
  REQUIRE(run.end.at_rest);
  const fidelity::MarchBars bars = fidelity::march_bars(c, o, run);
  REQUIRE(bars.grid.size() == run.instants.size());
  const Result steady = fidelity::solve(c);
  const Quantity* torque = quantity_in(steady.quantities, "friction_torque");
  // The same grids; the steady state's bars have the nodes across the film besides.
  const Instant& end = bars.grid.back();
  CHECK(end.torque == Approx(torque->error_grid).epsilon(0.5));
  CHECK(bars.time.back().torque < 0.1 * end.torque);  // at rest, steps change nothing
}

TEST_CASE("NoBarOfAStateIsFarShorterThanThoseBesideIt", "[transient]") {
  // Of 4, 2, 1 % and nothing the median is 2 %, of which each has a fifth; what is not known stays.
  std::vector<Instant> bars(2);
  const auto put = [&](double torque, double film, double out, double stored, double opening) {
    bars[0].torque = torque;
    bars[0].h_min = film;
    bars[0].heat_out = out;
    bars[0].stored = stored;
    bars[0].deformation = opening;
  };
  constexpr std::array kSome{kFollowedInstants[0], kFollowedInstants[1], kFollowedInstants[8],
                             kFollowedInstants[9], kFollowedInstants[6]};
  const std::vector<double> size{2.0, 20e-6, 300.0, 300.0, 1e-6};
  put(0.0, 0.04 * size[1], 0.02 * size[2], NAN, 0.01 * size[4]);
  bars[1].torque = 0.5;  // one alone has none to share with
  bars[1].h_min = bars[1].heat_out = bars[1].stored = bars[1].deformation = NAN;
  const auto size_of = [&](std::size_t, const Followed<Instant>& q) {
    for (std::size_t k = 0; k < kSome.size(); ++k) {
      if (kSome[k].value == q.value) return size[k];
    }
    return double{NAN};
  };
  auto parts = bars;
  const auto none = [](const Followed<Instant>&) { return false; };
  fidelity::share_bars_of_states(kSome, size_of, none, bars);
  // the film's as a part of something else: the smaller two are left to share
  fidelity::share_bars_of_states(
      kSome, size_of, [](const Followed<Instant>& q) { return q.value == &Instant::h_min; }, parts);
  CHECK(parts[0].torque == Approx(0.2 * 0.01 * size[0]).epsilon(1e-12));
  CHECK(bars[0].torque == Approx(0.2 * 0.02 * size[0]).epsilon(1e-12));
  CHECK(bars[0].h_min == 0.04 * size[1]);
  CHECK(bars[0].heat_out == 0.02 * size[2]);
  CHECK(std::isnan(bars[0].stored));
  CHECK(bars[0].deformation == 0.01 * size[4]);
  CHECK(bars[1].torque == 0.5);
}

TEST_CASE("TheHeatOfAnInstantIsKnownNoBetterThanItsTorque", "[transient]") {
  // As walls warm up what two grids differ by passes through zero, in one quantity after another.
  const Case c = coarse();
  const WarmUpOptions o = until(30.0);
  const WarmUp run = warm_up(c, Tier::thd, o);
  const fidelity::MarchBars bars = fidelity::march_bars(c, o, run);
  REQUIRE(bars.grid.size() == run.instants.size());
  for (std::size_t k = 0; k < bars.grid.size(); ++k) {
    const Instant& now = run.instants[k];
    INFO(now.t << " s");
    const double torque = bars.grid[k].torque / std::abs(now.torque);
    for (const double Instant::*wall :
         {&Instant::T_shell_max, &Instant::T_shell_back, &Instant::T_shaft}) {
      CHECK(bars.grid[k].*wall >= 0.999 * torque * std::abs(now.*wall - o.T_start));
    }
    CHECK(bars.grid[k].T_film_max >=
          0.999 * torque * std::abs(now.T_film_max - mean_supply_temperature(c)));
    CHECK(bars.grid[k].heat_in >= 0.999 * torque * now.heat_in);
  }
}

TEST_CASE("BarsOfACourseAreThoseOfItsStretches", "[transient]") {
  const Case c = coarse();
  Case fast = c;
  fast.operation.omega *= 2.0;
  const std::vector<Stretch> stretches{{c, 20.0}, {fast, 20.0}};
  const CourseRun run = run_course(stretches, Tier::thd, until(0.0));
  const fidelity::MarchBars bars = fidelity::march_bars(stretches, until(0.0), run);
  REQUIRE(bars.grid.size() == run.instants.size());
  // The first stretch does not know the second one.
  const WarmUp alone = warm_up(c, Tier::thd, until(20.0));
  const fidelity::MarchBars of_one = fidelity::march_bars(c, until(20.0), alone);
  REQUIRE(alone.instants.size() == run.ends[0] + 1);
  for (const std::size_t k : {run.ends[0] / 2, run.ends[0]}) {
    CHECK(bars.grid[k].T_shaft == Approx(of_one.grid[k].T_shaft));
    CHECK(bars.time[k].T_shaft == Approx(of_one.time[k].T_shaft));
  }
  for (std::size_t k = 0; k < run.instants.size(); ++k) {
    CHECK(std::isfinite(bars.grid[k].torque + bars.time[k].torque));
  }
}

TEST_CASE("EveryStretchOfACourseTellsWhatItsFilmLeaves", "[transient]") {
  const Case slow = coarse();
  Case fast = slow;
  fast.bearing.radial_clearance = 4.0 * slow.bearing.radial_clearance;
  const double omega = fast.operation.omega;
  const auto laminar = [](const std::vector<Note>& notes) {
    return std::none_of(notes.begin(), notes.end(),
                        [](const Note& n) { return std::holds_alternative<note::NotLaminar>(n); });
  };
  std::vector<Stretch> stretches{{fast, 5.0}, {fast, 5.0}};
  stretches[1].subject.operation.omega = 40.0 * omega;
  const CourseRun run = run_course(stretches, Tier::thd, until(0.0));
  REQUIRE(run.warnings.size() == 2);
  CHECK(laminar(run.warnings[0]));
  CHECK_FALSE(laminar(run.warnings[1]));
}

TEST_CASE("TheTimeOfASeizureHasBarsThatHoldAFinerGridAndShorterSteps", "[transient]") {
  Case c = coarse();
  c.model.tier = Tier::tehd;
  c.shell->housing->support = HousingSupport::clamped;
  c.bearing.radial_clearance = 8e-6;
  const WarmUp run = warm_up(c, Tier::tehd, until(INFINITY));
  INFO(app::reason_of(run.end.verdict) << " " << run.instants.size());
  REQUIRE(run.end.left_bounds);
  const fidelity::EndBars bars = fidelity::march_bars(c, until(INFINITY), run).end;
  REQUIRE(bars.grid > 0.0);
  REQUIRE(bars.time > 0.0);
  c.model.tolerance *= 0.1;
  const WarmUp shorter = warm_up(c, Tier::tehd, until(INFINITY));
  CHECK(std::abs(shorter.end.t - run.end.t) < bars.time);
  c.model.grid = {72, 12};
  c.model.tolerance *= 10.0;
  const WarmUp finer = warm_up(c, Tier::tehd, until(INFINITY));
  CHECK(std::abs(finer.end.t - run.end.t) < bars.grid);
  CHECK(bars.grid < 0.5 * run.end.t);  // and tell something
}

TEST_CASE("AMarchThatIsStoppedHasNoBars", "[transient]") {
  const Case c = coarse();
  const WarmUp run = warm_up(c, Tier::thd, until(1.0));
  const std::atomic<bool> stop{true};
  SolveControl control;
  control.stop = &stop;
  const fidelity::MarchBars bars = fidelity::march_bars(c, until(1.0), run, control);
  CHECK(bars.interrupted);
  CHECK(bars.grid.empty());
}

TEST_CASE("TheFirstOfAnOddNumberOfStepsErrsAsThoseBehindIt", "[transient]") {
  // It is the same step in both runs: what these differ by there says nothing.
  const auto states = [](const std::vector<double>& torques) {
    std::vector<Instant> out(torques.size());
    for (std::size_t k = 0; k < torques.size(); ++k) out[k].torque = torques[k];
    return out;
  };
  const auto usual = states({1.0, 2.0, 3.0}), joined = states({1.0, 3.3});
  auto bars = states({0.0, 0.0, 0.0});
  std::size_t n = 0;
  fidelity::add_bars_of_steps(usual, joined, usual, 2.0, 0, 2, kFollowedInstants, n, bars);
  for (const Instant& bar : bars) CHECK(bar.torque == Approx(1.5 * 0.3 / 3.0));
}
