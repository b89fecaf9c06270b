// A running-in that is stopped and gone on with against one that is not.
#include <algorithm>
#include <atomic>
#include <bit>
#include <catch2/catch.hpp>
#include <random>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/kept_run.hpp"
#include "bearing/over_time/running_in.hpp"
#include "bearing/over_time/solution_members.hpp"
#include "core/contract.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// The KS bearing at a speed at which its edges rub, getting smoother as it wears.
Case rubbing_case(Tier tier) {
  Case c = rig_case();
  c.model.tier = tier;
  if (tier == Tier::isothermal) c.model.switches.elastic_deformation = true;
  c.model.grid = {40, 7};
  c.operation.omega = 600.0 * kPi / 30.0;
  c.running_in = RunningIn{1e-8, 350e6, 600.0, 0.0, c.surfaces.shell, 1e-6};
  c.running_in->worn->roughness *= 0.8;
  return c;
}

/// The same under a load that swings once in a turn.
Case swinging_case(Tier tier) {
  constexpr int kRows = 24;
  Case c = rubbing_case(tier);
  LoadCycle cycle;
  cycle.period = 0.1;
  for (int k = 0; k < kRows; ++k) {
    cycle.t.push_back(cycle.period * k / kRows);
    cycle.x.push_back(0.0);
    cycle.y.push_back(-6e3 + 5e3 * std::cos(2.0 * kPi * k / kRows));
  }
  cycle.interpolation = LoadInterpolation::periodic_spline;
  cycle.journal_mass = 5.0;
  c.cycle = cycle;
  c.running_in->wear_coefficient = 1e-6;
  c.running_in->duration = 20.0;
  return c;
}

/// All numbers that a running-in tells.
std::vector<std::uint64_t> numbers(RunningInRun run) {
  Tape tape;
  tape(run.states, run.wear, run.complementarity, run.rejected_steps);
  if (run.cycle) {
    run.cycle->cost = {};
    tape(*run.cycle);
  } else {
    tape(run.solution.film, run.solution.heat);
  }
  std::vector<std::uint64_t> all;
  for (const double x : tape.content().numbers) all.push_back(std::bit_cast<std::uint64_t>(x));
  all.insert(all.end(), tape.content().counts.begin(), tape.content().counts.end());
  return all;
}

/// Stopped after so many shapes, or iterations of a shape, as `wait` says, and gone on with.
RunningInRun in_pieces(const Case& c, const std::function<int()>& wait, int& pieces) {
  std::optional<Tape::Content> state;
  const auto save = [&](const Tape::Content& s) { state = s; };
  for (pieces = 0;; ++pieces) {
    std::atomic<bool> stop{false};
    int left = wait();
    KeptRun kept = state ? KeptRun(save, *state) : KeptRun(save);
    SolveControl control;
    control.stop = &stop;
    control.kept = &kept;
    // the new bearing is not solved in pieces
    const auto count = [&] { stop = pieces == 0 || --left == 0 || stop; };
    if (pieces > 0) control.progress = [&](const Progress&) { count(); };
    const auto seen = [&](const RunningInRun&) { count(); };
    RunningInRun run = run_in(c, c.model.tier, control, seen);
    if (run.verdict.status != Status::interrupted) return run;
    REQUIRE(state);
    REQUIRE(!run.states.empty());
    CHECK(*std::max_element(run.wear.begin(), run.wear.end()) == run.states.back().depth);
  }
}

/// `most`: longest piece, in reports of progress.
void check_in_pieces(const Case& c, int most) {
  const RunningInRun whole = run_in(c, c.model.tier);
  INFO(app::reason_of(whole.verdict));
  REQUIRE(whole.verdict.good());
  REQUIRE(whole.states.back().depth > 0.0);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> length(most / 2, most);
  int pieces = 0;
  const RunningInRun r = in_pieces(
      c, [&] { return length(random); }, pieces);
  CHECK(pieces >= 3);
  CHECK(numbers(r) == numbers(whole));  // the same steps: not a bit less
}

}  // namespace

TEST_CASE("ARunningInStoppedAndGoneOnWithIsTheWhole") {
  check_in_pieces(rubbing_case(Tier::isothermal), 4);
}

TEST_CASE("ARunningInWithHeatStoppedAndGoneOnWithIsTheWhole") {
  check_in_pieces(rubbing_case(Tier::tehd), 8);
}

TEST_CASE("AWornInShapeStoppedAndGoneOnWithIsTheWhole") {
  Case c = rubbing_case(Tier::isothermal);
  c.running_in->duration.reset();
  c.running_in->limit_pressure = 2e6;
  check_in_pieces(c, 4);
}

TEST_CASE("ARunningInOverACycleStoppedAndGoneOnWithIsTheWhole") {
  check_in_pieces(swinging_case(Tier::isothermal), 400);
}

TEST_CASE("ARunningInOverACycleWithHeatStoppedAndGoneOnWithIsTheWhole") {
  check_in_pieces(swinging_case(Tier::tehd), 300);
}

TEST_CASE("AKeptRunningInThatIsCutShortIsRefused") {
  const Case c = rubbing_case(Tier::isothermal);
  std::optional<Tape::Content> state;
  std::atomic<bool> stop{false};
  KeptRun kept([&](const Tape::Content& s) { state = s; });
  SolveControl control;
  control.stop = &stop;
  control.kept = &kept;
  const auto seen = [&](const RunningInRun& run) { stop = run.states.size() == 2; };
  REQUIRE(run_in(c, c.model.tier, control, seen).verdict.status == Status::interrupted);
  REQUIRE(state);
  stop = false;
  const auto go_on = [&](Tape::Content from) {
    KeptRun later([](const Tape::Content&) {}, std::move(from));
    control.kept = &later;
    static_cast<void>(run_in(c, c.model.tier, control));
  };
  Tape::Content shorter = *state;
  shorter.numbers.pop_back();
  CHECK_THROWS_AS(go_on(shorter), FileError);
  Tape::Content longer = *state;
  longer.counts.push_back(0);
  CHECK_THROWS_AS(go_on(longer), FileError);
}
