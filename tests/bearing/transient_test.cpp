/// A bearing from cold walls to its steady state, and one that seizes on the way.
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/warm_up.hpp"
#include "bearing/steady/solve.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Case coarse(Case c) {
  c.model.grid = {48, 9};
  return c;
}

}  // namespace

TEST_CASE("AWarmUpEndsInTheSteadyStateAndLosesNoHeat", "[transient]") {
  for (const auto& [c, tier] :
       {std::pair{coarse(warm_case()), Tier::thd}, std::pair{coarse(rig_case()), Tier::tehd}}) {
    const WarmUp run = warm_up(c, tier, {});
    INFO(c.title << ": " << app::reason_of(run.end.verdict));
    REQUIRE(run.end.verdict.good());
    CHECK(run.end.at_rest);
    CHECK(run.end.t < 1e5);  // hundreds of its slowest time: not for want of a longer step
    CHECK(run.imbalance() < 1e-8);
    const Solution steady = solve_tier(c, tier);
    REQUIRE(steady.verdict.good());
    const Instant& last = run.instants.back();
    // Each is a fixed point to 3 mK; harmonics above the sixth are interpolated in the steady one.
    CHECK(last.torque == Approx(torque_of(steady)).epsilon(2e-4));
    CHECK(last.h_min == Approx(steady.film.least.h).epsilon(1e-3));
    CHECK(std::abs(last.stored) < 1e-3 * last.heat_in);
  }
}

TEST_CASE("AWarmUpTellsThatItEndsInAnotherSteadyState", "[transient]") {
  // Walls of 300 degC keep the film of the rig's bearing so thin that its contact keeps them hot.
  const Case c = coarse(rig_case());
  const Solution cold = solve_tier(c, Tier::tehd);
  Result steady = summarize(cold, Tier::tehd);
  for (Quantity& q : steady.quantities) q.error_grid = 0.05 * std::abs(q.value);
  WarmUpOptions from;
  const auto told = [&](double T_start) {
    from.T_start = T_start;
    const WarmUp run = warm_up(c, Tier::tehd, from);
    REQUIRE(run.end.at_rest);
    const auto notes = warm_up_warnings(c.oil, run, steady);
    return std::count_if(notes.begin(), notes.end(), [](const Note& n) {
      return std::holds_alternative<note::OtherSteadyState>(n);
    });
  };
  CHECK(told(293.15) == 0);
  CHECK(told(573.15) == 1);
}

TEST_CASE("WarmingWallsAreSlowerTheFartherFromTheFilm", "[transient]") {
  Case c = coarse(warm_case());
  const WarmUp run = warm_up(c, Tier::thd, {});
  REQUIRE(run.end.verdict.good());
  const Instant& end = run.instants.back();
  const auto half_way = [&](double Instant::*T) {
    for (const Instant& i : run.instants) {
      if (i.*T > 0.5 * (293.15 + end.*T)) return i.t;
    }
    return end.t;
  };
  CHECK(half_way(&Instant::T_film_max) < half_way(&Instant::T_shell_max));
  CHECK(half_way(&Instant::T_shell_max) < half_way(&Instant::T_shell_back));
  // Oil that meets cold walls is thick: friction falls as they warm.
  CHECK(run.instants.front().torque > end.torque);
}

TEST_CASE("AWarmUpIsOfSecondOrderAndWithinItsTolerance", "[transient]") {
  // An error of a step that is a quarter makes steps half as long, and the error of the whole, of
  // second order in them, a quarter: at least half where steps are halved and doubled.
  Case c = coarse(warm_case());
  const auto instants = [&](double tolerance) {
    c.model.tolerance = tolerance;
    WarmUpOptions o;
    o.end = 60.0;
    const WarmUp run = warm_up(c, Tier::thd, o);
    REQUIRE(run.end.verdict.good());
    CHECK(run.end.t == Approx(60.0));
    CHECK(run.imbalance() < 1e-8);
    return run.instants;
  };
  const auto fine = instants(4e-4);
  const auto torque_at = [&](double t) {  // of the fine steps, straight between instants
    const auto after =
        std::find_if(fine.begin(), fine.end(), [t](const Instant& i) { return i.t >= t; });
    if (after == fine.begin()) return after->torque;
    const Instant& a = *(after - 1);
    return a.torque + (t - a.t) / (after->t - a.t) * (after->torque - a.torque);
  };
  const auto off = [&](double tolerance) {
    double most = 0.0;
    for (const Instant& i : instants(tolerance)) {
      if (i.t > 1.0) most = std::max(most, std::abs(i.torque / torque_at(i.t) - 1.0));
    }
    CHECK(most < tolerance);
    return most;
  };
  const double rough = off(0.04);
  CHECK(off(0.01) < 0.5 * rough);
}

TEST_CASE("AClearanceThatGrowthUsesUpSeizesAtATime", "[transient]") {
  Case c = coarse(warm_case());
  c.shell->housing->support = HousingSupport::clamped;
  c.bearing.radial_clearance = 8e-6;  // the shaft alone grows by a third of a micrometre per kelvin
  const WarmUp run = warm_up(c, Tier::tehd, {});
  REQUIRE_FALSE(run.instants.empty());
  INFO(app::reason_of(run.end.verdict));
  CHECK_FALSE(run.end.verdict.good());
  CHECK(run.end.t > 0.0);
  CHECK(run.end.t < 3600.0);
  CHECK(run.instants.back().deformation < run.instants.front().deformation);
  CHECK(run.imbalance() < 1e-8);  // to the last instant
}

TEST_CASE("ASlowColdBearingIsCarriedByTheOilThatItsWallsHaveCooled", "[transient]") {
  // As thin as oil of the supply has its film, Barus oil at -20 degC has no pressure there.
  Case c = rig_case();
  c.model.grid = {36, 5};
  c.operation.omega = 100.0 * kRpm;
  set_load(c, 4e3);
  WarmUpOptions o;
  o.T_start = 253.15;
  o.end = 0.05;
  const WarmUp run = warm_up(c, Tier::thd, o);
  INFO(app::reason_of(run.end.verdict));
  REQUIRE(run.end.verdict.good());
  Case cold = c;
  cold.oil_temperature = o.T_start;
  const double h_min = solved(cold, Tier::isothermal).film.least.h;
  // hot oil from the supply thins it by a few per cent
  CHECK(run.instants.front().h_min == Approx(h_min).epsilon(0.1));
}

TEST_CASE("OnlyTiersWithWallsHaveATransient", "[transient]") {
  CHECK_THROWS_AS(warm_up(warm_case(), Tier::isothermal, {}), InputError);
}

TEST_CASE("HeatThatComesFromTheBackIsWaitedFor", "[transient]") {
  // A slow, lightly loaded bearing as warm as its supply, cooled from behind: nothing moves at the
  // bore until the cold has come through the wall.
  Case c = coarse(warm_case());
  const double warm = c.supplies[0].temperature;
  c.operation.omega *= 0.03;
  c.operation.position = LoadGiven{20.0, std::get<LoadGiven>(c.operation.position).angle};
  c.shell->housing = Housing{steel(), 0.15, HousingSupport::held};
  c.shaft->overhang = 0.0;
  c.shell->back = ConvectiveBack{500.0, warm - 60.0};
  c.shell->end_heat_transfer = 0.0;
  WarmUpOptions o;
  o.T_start = warm;
  const WarmUp run = warm_up(c, Tier::thd, o);
  INFO(app::reason_of(run.end.verdict));
  REQUIRE(run.end.verdict.good());
  CHECK(run.end.at_rest);
  const Solution steady = solve_tier(c, Tier::thd);
  REQUIRE(steady.verdict.good());
  const Instant& last = run.instants.back();
  CHECK(last.T_shell_back < warm - 10.0);
  CHECK(last.T_shell_max == Approx(largest(steady.heat.T_shell)).margin(0.1));
  CHECK(std::abs(last.stored) < 1e-2 * std::abs(last.heat_out));
}

TEST_CASE("AMarchTellsWhereItsOilWasOutOfRange", "[transient]") {
  rheology::Oil oil;
  oil.range.T_min = 290.0;
  oil.range.T_max = 400.0;
  std::vector<Instant> instants(2);
  instants[0].T_film_max = 350.0;
  instants[0].T_film_min = 300.0;
  instants[1].T_film_max = 380.0;  // of a cycle: its coldest is not known
  CHECK(march_warnings(oil, instants).empty());
  instants[1].T_film_max = 401.0;
  CHECK(march_warnings(oil, instants).size() == 1);
  const auto of_cycles = march_warnings(oil, {instants[1]});
  REQUIRE(of_cycles.size() == 1);
  CHECK(std::isnan(std::get<note::BeyondOilRange>(of_cycles[0]).T_low));
  instants[1].T_film_max = 380.0;
  instants[0].T_film_min = 280.0;
  CHECK(march_warnings(oil, instants).size() == 1);
}
