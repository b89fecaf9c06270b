// Bars of runnings-in: what a finer grid gives lies within them.
#include "fidelity/running_in_bars.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/kept_run.hpp"
#include "fidelity/cycle_bars.hpp"
#include "tests/bearing/rubbing_cases.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Case wearing_for_ten_minutes() {
  Case c = wearing_case();
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
  Case c = wearing_for_ten_minutes();
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
  const Case c = wearing_for_ten_minutes();
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
    Case c = wearing_for_ten_minutes();
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
    // That of one step, of first order, is exact but for what is of higher order.
    if (run.states.size() == 2) {
      const double off = std::abs(exact.volume - last.volume);
      CHECK(last.volume_error == Approx(off).epsilon(0.2));
    }
    // and they say something: the estimate of one step's error is that of its volume
    CHECK(bars.time.back().volume < 0.05 * last.volume);
  }
}

TEST_CASE("AShapeThatIsWornInHasBarsOfItsGridAlone", "[running_in]") {
  Case c = wearing_for_ten_minutes();
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
  Case c = wearing_for_ten_minutes();
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

TEST_CASE("GridsOnWhichNothingWearsDoNotAgreeThatNothingDoes", "[running_in]") {
  // The sharp edges of even cells hardly touch, on no grid so coarse by as much as the limit: the
  // wear is 0 on each of them, and 0 +- 0 was told; finer ones wear.
  Case c = wearing_for_ten_minutes();
  c.model.grid = {60, 9};
  c.operation.omega = 1500.0 * kPi / 30.0;  // the edges hardly rub
  c.running_in->duration = 1.0;
  c.running_in->limit_pressure = 2.0 * run_of(c).states.front().p_asperity_max;
  c.running_in->duration = 3000.0;
  const RunningInRun run = run_of(c);
  REQUIRE(run.states.back().depth == 0.0);
  const fidelity::RunningInBars bars = fidelity::running_in_bars(c, run);
  REQUIRE(bars.grid.size() == run.states.size());
  c.model.grid = {100, 25};
  const RunningInState fine = run_of(c).states.back();
  CAPTURE(fine.depth, fine.volume, c.running_in->limit_pressure);
  REQUIRE(fine.depth > 1e-8);
  CHECK(fine.depth < bars.grid.back().depth);
  CHECK(fine.volume < bars.grid.back().volume);
}

TEST_CASE("WhatHardlyWearsDoesNotTellHowWellItsFilmIsKnown", "[running_in]") {
  // At 3000 rpm and a third of the load nothing touches: depth, volume and contact are chance.
  Case c = wearing_for_ten_minutes();
  c.model.grid = {60, 9};
  c.operation.omega = 3000.0 * kPi / 30.0;
  set_load(c, 3e3);
  const RunningInRun run = run_of(c);
  REQUIRE(run.states.back().p_asperity_max < 1.0);
  const fidelity::RunningInBars bars = fidelity::running_in_bars(c, run);
  REQUIRE(bars.grid.size() == run.states.size());
  for (const auto value : {&RunningInState::torque, &RunningInState::h_min}) {
    // the shape has not changed, nor has what the grids give; the median of one pair is the other
    CHECK(bars.grid.back().*value == Approx(bars.grid.front().*value).epsilon(1e-6));
  }
}

TEST_CASE("BarsOfARunningInOverACycleHoldFinerStepsWithinIt", "[running_in]") {
  Case c = bearing::tests::rubbing_case(true);
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {36, 5};
  c.running_in = RunningIn{1e-8, 350e6, {}, 0.0, {}, 0.0};
  c.running_in->duration = 60.0;
  const RunningInRun run = run_of(c);
  int saved = 0;
  KeptRun kept([&](const Tape::Content&) { ++saved; });
  SolveControl control;
  control.kept = &kept;
  const fidelity::RunningInBars bars = fidelity::running_in_bars(c, run, control);
  kept.keep_noted();
  CHECK(saved == 0);  // what is kept is the running-in, not the cycles of its bars
  REQUIRE(bars.time.size() == run.states.size());
  // of the new bearing they are what `run` tells of its cycle, from one more grid
  Case same = c;
  same.running_in.reset();
  const CycleResult cycle = fidelity::solve_cycle_with_bars(same);
  for (const auto& [value, name] : {std::pair{&RunningInState::p_asperity_max, "p_asperity_max"},
                                    std::pair{&RunningInState::torque, "friction_torque"},
                                    std::pair{&RunningInState::h_min, "h_min"}}) {
    INFO(name);
    const double told = quantity_named(cycle, name)->quantity.error_time;
    CHECK(bars.time.front().*value > 0.5 * told);
    CHECK(bars.time.front().*value < 3.0 * told);
  }
  Case finer = c;
  finer.model.tolerance *= 0.1;
  const RunningInRun fine = run_of(finer);
  for (const bool first : {true, false}) {
    const RunningInState& at = first ? run.states.front() : run.states.back();
    const RunningInState& exact = first ? fine.states.front() : fine.states.back();
    const RunningInState& bar = first ? bars.time.front() : bars.time.back();
    for (const auto& q : kFollowedStates) {
      INFO(q.name << (first ? " of the new bearing" : " in the end"));
      // three of four bars of a cycle's steps hold (docs/decisions/058), nearly all twice them
      CHECK(std::abs(exact.*q.value - at.*q.value) <= 2.0 * bar.*q.value);
    }
  }
}

TEST_CASE("WhereStatesChangeBarsAreAsLongAsTheChange", "[running_in]") {
  // A run of three states before the change and three behind it, each with the same error of
  // volume.
  RunningInRun run;
  for (int k = 0; k < 6; ++k) {
    RunningInState s;
    s.t = k;
    s.step = 1.0;
    s.volume = s.depth = 1.0 + k;
    s.torque = k < 3 ? 10.0 + 0.1 * k : 2.0 + 0.1 * k;
    s.volume_error = s.depth_error = 0.8;
    s.anew = k == 3;
    run.states.push_back(s);
  }
  auto bars = std::vector<RunningInState>(6);
  fidelity::widen_by_errors_of_steps(run, bars);
  // 1.5 x 0.8 hides a step: the states beside the change may be those behind or before it
  const double change = 10.2 - 2.3;
  CHECK(bars[1].torque == Approx(0.1));  // all that it has changed since it was new
  CHECK(bars[2].torque == Approx(change));
  CHECK(bars[3].torque == Approx(change));
  CHECK(bars[4].torque == Approx(change));
  CHECK(bars[5].torque == Approx(1.2 / 2.0 * 0.2));
  CHECK(bars[5].volume == Approx(1.2));
  // Where nothing wears behind the change, nothing is left of the errors but its time.
  for (int k = 3; k < 6; ++k) {
    run.states[k].volume = run.states[k].depth = 4.0;
    run.states[k].volume_error = run.states[k].depth_error = 0.0;
  }
  bars.assign(6, {});
  fidelity::widen_by_errors_of_steps(run, bars);
  CHECK(bars[4].torque == Approx(change));
  CHECK(bars[5].torque == 0.0);
}
