// Bars of runnings-in: what a finer grid gives lies within them.
#include "fidelity/running_in_bars.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "app/words/ending_words.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// The KS bearing, elastic, at a speed at which its edges rub.
Case rubbing_case() {
  Case c = rig_case();
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {60, 13};
  c.operation.omega = 600.0 * kPi / 30.0;
  c.running_in = RunningIn{1e-8, 350e6, {}, 0.0, {}, 0.0};
  c.running_in->duration = 600.0;
  return c;
}

RunningInRun run_of(const Case& c) {
  RunningInRun run = run_in(c, c.model.tier);
  INFO(app::reason_of(run.verdict));
  REQUIRE(run.verdict.good());
  return run;
}

}  // namespace

TEST_CASE("BarsOfARunningInHoldAFinerGrid", "[running_in]") {
  Case c = rubbing_case();
  const RunningInRun run = run_of(c);
  const fidelity::RunningInBars bars = fidelity::running_in_bars(c, run);
  REQUIRE(bars.grid.size() == run.states.size());
  REQUIRE(bars.time.size() == run.states.size());
  c.model.grid = {120, 27};
  const RunningInState fine = run_of(c).states.back();
  const RunningInState& last = run.states.back();
  const std::size_t k = run.states.size() - 1;
  for (const auto& q : kFollowedStates) {
    INFO(q.name);
    CHECK(std::abs(fine.*q.value - last.*q.value) < bars.at(k, q.value));
    // and say something: no bar is longer than twice the value (cells of a millimetre at the edges)
    CHECK(bars.at(k, q.value) < 2.0 * std::abs(last.*q.value));
  }
}

TEST_CASE("StepsOfARunningInLeaveOpenWhatTheirErrorAllows", "[running_in]") {
  // A step errs by a thousandth of the depth at most (docs/running-in.md: half a per cent of it
  // after all steps); nothing has worn in the first state.
  const Case c = rubbing_case();
  const RunningInRun run = run_of(c);
  const fidelity::RunningInBars bars = fidelity::running_in_bars(c, run);
  CHECK(bars.time.front().depth == 0.0);
  CHECK(bars.time.back().depth > 1e-5 * run.states.back().depth);
  CHECK(bars.time.back().depth < 0.02 * run.states.back().depth);
}

TEST_CASE("BarsOfOneOrAFewStepsHoldShorterOnes", "[running_in]") {
  // From one step, of which none twice as long is left to tell anything, to a handful.
  for (const double until : {2.0, 8.0, 20.0, 60.0}) {
    INFO(until << " s");
    Case c = rubbing_case();
    c.model.grid = {60, 9};
    c.running_in->duration = until;
    const RunningInRun run = run_of(c);
    const fidelity::RunningInBars bars = fidelity::running_in_bars(c, run);
    std::vector<double> steps;
    for (std::size_t k = 1; k < run.states.size(); ++k) {
      for (int part = 0; part < 8; ++part) steps.push_back(run.states[k].step / 8.0);
    }
    const RunningInRun fine = run_in(c, c.model.tier, {}, {}, steps);
    REQUIRE(fine.verdict.good());
    const RunningInState &last = run.states.back(), &exact = fine.states.back();
    REQUIRE(exact.t == Approx(last.t));
    for (const auto& q : kFollowedStates) {
      INFO(q.name);
      CHECK(std::abs(exact.*q.value - last.*q.value) <= bars.time.back().*q.value);
    }
    // and they say something: the estimate of one step's error is that of its volume
    CHECK(bars.time.back().volume < 0.05 * last.volume);
  }
}

TEST_CASE("AShapeThatIsWornInHasBarsOfItsGridAlone", "[running_in]") {
  Case c = rubbing_case();
  c.running_in->duration.reset();
  c.running_in->limit_pressure = 5e6;
  const RunningInRun run = run_of(c);
  REQUIRE(run.states.size() == 2);
  const fidelity::RunningInBars bars = fidelity::running_in_bars(c, run);
  REQUIRE(bars.grid.size() == 2);
  CHECK(bars.grid.back().depth > 0.0);
  CHECK(bars.time.back().depth == 0.0);
}

TEST_CASE("ContactAtANewBearingsEdgesIsAsSureAsTheFilmThere", "[running_in]") {
  // Edges that hardly rub: their pressure of contact goes on rising with cells along (the smallest
  // film stands at the edge), by more than nested grids differ by.
  Case c = rubbing_case();
  c.operation.omega = 1500.0 * kPi / 30.0;
  c.running_in->duration = 60.0;
  const RunningInRun run = run_of(c);
  const fidelity::RunningInBars bars = fidelity::running_in_bars(c, run);
  REQUIRE(!bars.grid.empty());
  c.model.grid = {120, 27};
  const RunningInState fine = run_of(c).states.front();
  const RunningInState& first = run.states.front();
  REQUIRE(std::abs(fine.h_min - first.h_min) < bars.grid.front().h_min);  // else nothing follows
  CHECK(std::abs(fine.p_asperity_max - first.p_asperity_max) < bars.grid.front().p_asperity_max);
}
