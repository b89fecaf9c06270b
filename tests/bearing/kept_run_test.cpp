// A run over load cycles that is stopped and gone on with against one that is not.
#include "bearing/over_time/kept_run.hpp"

#include <atomic>
#include <bit>
#include <catch2/catch.hpp>
#include <random>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/tape_members.hpp"
#include "core/contract.hpp"
#include "tests/bearing/rubbing_cases.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

/// A load of 1 kN that turns once in two turns of the journal, over 1 kN that stand still.
void let_load_turn(Case& c) {
  constexpr int kRows = 24;
  LoadCycle cycle;
  cycle.period = 4.0 * kPi / c.operation.omega;
  for (int k = 0; k < kRows; ++k) {
    const double angle = 2.0 * kPi * k / kRows;
    cycle.t.push_back(cycle.period * k / kRows);
    cycle.x.push_back(1e3 * std::cos(angle));
    cycle.y.push_back(1e3 * std::sin(angle) - 1e3);
  }
  cycle.journal_mass = 0.5;
  c.cycle = cycle;
  c.model.grid = {48, 8};
  c.model.tolerance = 0.03;  // long steps: it is not they that are tested
}

/// All numbers of a result, and its texts; what the clock says left out.
Tape::Content content(CycleResult r) {
  r.cost.wall_s = 0.0;
  Tape tape;
  tape(r);
  return tape.content();
}

std::vector<std::uint64_t> bits(const std::vector<double>& x) {
  std::vector<std::uint64_t> all;
  for (const double v : x) all.push_back(std::bit_cast<std::uint64_t>(v));
  return all;
}

/// The cycle, stopped after so many steps as `wait` says each time and gone on with.
CycleResult in_pieces(const Case& c, Tier tier, const std::function<int()>& wait, int& pieces) {
  std::optional<Tape::Content> state;
  const auto save = [&](const Tape::Content& s) { state = s; };
  for (pieces = 0;; ++pieces) {
    std::atomic<bool> stop{false};
    int left = wait();
    KeptRun kept = state ? KeptRun(save, *state) : KeptRun(save);
    SolveControl control;
    control.stop = &stop;
    control.kept = &kept;
    control.progress = [&](const Progress& p) {
      if (p.stage == "cycle" && --left == 0) stop = true;
    };
    CycleResult r = solve_cycle(c, tier, control);
    if (r.verdict.status != Status::interrupted) return r;
  }
}

void check_in_pieces(const Case& c, Tier tier) {
  const CycleResult whole = solve_cycle(c, tier);
  INFO(app::reason_of(whole.verdict));
  REQUIRE(whole.verdict.good());
  std::mt19937 random(7);
  std::uniform_int_distribution<int> steps(1, 1 + whole.cycles * whole.steps / 3);
  int pieces = 0;
  const CycleResult r = in_pieces(
      c, tier, [&] { return steps(random); }, pieces);
  CHECK(pieces >= 3);
  const Tape::Content a = content(whole);
  const Tape::Content b = content(r);
  CHECK(bits(a.numbers) == bits(b.numbers));  // the same steps: not a bit less
  CHECK(a.counts == b.counts);
  CHECK(a.text == b.text);
}

}  // namespace

TEST_CASE("AnIsothermalCycleInPiecesIsTheWhole", "[kept]") {
  Case c = warm_case();
  let_load_turn(c);
  check_in_pieces(c, Tier::isothermal);
}

TEST_CASE("TheSearchForOneTemperatureInPiecesIsTheWhole", "[kept]") {
  Case c = warm_case();
  let_load_turn(c);
  check_in_pieces(c, Tier::lumped);
}

TEST_CASE("WallsThatSettleInPiecesAreThoseOfTheWhole", "[kept]") {
  Case c = warm_case();
  let_load_turn(c);
  c.model.grid = {68, 11};  // a coarser one goes before
  check_in_pieces(c, Tier::thd);
}

TEST_CASE("ACycleThatBeginsAgainInPiecesIsTheWhole", "[kept]") {
  check_in_pieces(rubbing_case(true), Tier::thd);  // its first film does not hold together
}

TEST_CASE("AnEventInPiecesIsTheWhole", "[kept]") {
  Case c = warm_case();
  let_load_turn(c);
  c.cycle->period = INFINITY;
  check_in_pieces(c, Tier::thd);
}

TEST_CASE("ACycleWithAVesselInPiecesIsTheWhole", "[kept]") {
  Case c = warm_case();
  let_load_turn(c);
  c.supplies[0].vessel = Vessel{2e-6, 1.5e9, {{0.0, 0.5 * c.cycle->period}}};
  check_in_pieces(c, Tier::isothermal);
}

TEST_CASE("ACycleWithADrillingInPiecesIsTheWhole", "[kept]") {
  Case c = warm_case();
  let_load_turn(c);
  Supply drilling;
  drilling.kind = SupplyKind::drilling;
  drilling.diameter = 8e-3;
  drilling.pressure = 2e5;
  drilling.temperature = 313.15;
  drilling.carry_over = 0.0;
  c.supplies = {drilling};
  check_in_pieces(c, Tier::isothermal);
}

TEST_CASE("AnEventThatIsStoppedBeforeItHasBegunLeavesNothing", "[kept]") {
  Case c = warm_case();
  let_load_turn(c);
  c.cycle->period = INFINITY;
  for (const Tier tier : {Tier::isothermal, Tier::thd}) {  // its steady beginning is being solved
    const std::atomic<bool> stop{true};
    bool saved = false;
    KeptRun kept([&](const Tape::Content&) { saved = true; });
    SolveControl control;
    control.stop = &stop;
    control.kept = &kept;
    const CycleResult r = solve_cycle(c, tier, control);
    CHECK(r.verdict.status == Status::interrupted);
    CHECK(r.instants.empty());
    CHECK_FALSE(saved);
  }
}

TEST_CASE("ResultsThatHaveEndedAreNotSolvedAgain", "[kept]") {
  Case c = plain_case();
  let_load_turn(c);
  std::optional<Tape::Content> state;
  const auto save = [&](const Tape::Content& s) { state = s; };
  std::atomic<bool> stop{false};
  KeptRun kept(save);
  SolveControl control;
  control.stop = &stop;
  control.kept = &kept;
  const CycleResult first = solve_cycle(c, Tier::isothermal, control);
  REQUIRE(first.verdict.good());
  stop = true;
  CHECK(solve_cycle(c, Tier::isothermal, control).verdict.status == Status::interrupted);
  REQUIRE(state);
  KeptRun later(save, *state);
  int steps = 0;
  control.kept = &later;
  control.progress = [&](const Progress&) { ++steps; };
  CHECK(content(solve_cycle(c, Tier::isothermal, control)).numbers.size() ==
        content(first).numbers.size());
  CHECK(steps == 0);
}

TEST_CASE("AStateThatIsCutShortIsRefused", "[kept]") {
  Case c = plain_case();
  let_load_turn(c);
  std::optional<Tape::Content> state;
  std::atomic<bool> stop{true};
  KeptRun kept([&](const Tape::Content& s) { state = s; });
  SolveControl control;
  control.stop = &stop;
  control.kept = &kept;
  REQUIRE(solve_cycle(c, Tier::isothermal, control).verdict.status == Status::interrupted);
  REQUIRE(state);
  stop = false;
  const auto go_on = [&](Tape::Content from) {
    KeptRun later([](const Tape::Content&) {}, std::move(from));
    control.kept = &later;
    static_cast<void>(solve_cycle(c, Tier::isothermal, control));
  };
  Tape::Content shorter = *state;
  shorter.numbers.pop_back();
  CHECK_THROWS_AS(go_on(shorter), FileError);
  Tape::Content longer = *state;
  longer.counts.push_back(0);
  CHECK_THROWS_AS(go_on(longer), FileError);
  Tape::Content wild = *state;
  wild.counts.front() = std::int64_t{1} << 60U;
  CHECK_THROWS_AS(go_on(wild), FileError);
}
