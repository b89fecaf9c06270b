// Warm-ups and courses that are stopped and gone on with against those that are not.
#include <atomic>
#include <bit>
#include <catch2/catch.hpp>
#include <random>

#include "app/words/ending_words.hpp"
#include "bearing/over_time/course.hpp"
#include "bearing/over_time/kept_run.hpp"
#include "bearing/over_time/solution_members.hpp"
#include "core/contract.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using namespace shellback::bearing::tests;

namespace {

Case coarse(Tier tier) {
  Case c = warm_case();
  c.model.tier = tier;
  c.model.grid = {36, 6};
  return c;
}

/// The same under a load that swings once in two turns.
Case swinging(Tier tier) {
  constexpr int kRows = 24;
  Case c = coarse(tier);
  LoadCycle cycle;
  cycle.period = 4.0 * kPi / c.operation.omega;
  for (int k = 0; k < kRows; ++k) {
    cycle.t.push_back(cycle.period * k / kRows);
    cycle.x.push_back(0.0);
    cycle.y.push_back(-1.5e3 + 5e2 * std::cos(2.0 * kPi * k / kRows));
  }
  cycle.journal_mass = 0.5;
  c.cycle = cycle;
  c.model.tolerance = 0.1;  // long steps: it is not they that are tested
  return c;
}

/// Two speeds, each held for a time [s].
std::vector<Stretch> run_up(const Case& c, double hold) {
  Case slow = c;
  slow.operation.omega *= 0.6;
  return {{slow, hold}, {c, hold}};
}

/// All numbers of a tape.
std::vector<std::uint64_t> bits(const Tape& tape) {
  std::vector<std::uint64_t> all;
  for (const double x : tape.content().numbers) all.push_back(std::bit_cast<std::uint64_t>(x));
  all.insert(all.end(), tape.content().counts.begin(), tape.content().counts.end());
  return all;
}

std::vector<std::uint64_t> numbers(WarmUp run) {
  Tape tape;
  tape(run.instants, run.end, run.solution.film, run.solution.heat, run.solution.cost);
  return bits(tape);
}

std::vector<std::uint64_t> numbers(CourseRun run) {
  Tape tape;
  tape(run.instants, run.ends, run.end);
  return bits(tape);
}

/// What is to be run, under a control.
template <class Run>
using Runs = std::function<Run(const SolveControl&)>;

/// Stopped after so many reports of progress as `wait` says, and gone on with.
template <class Run>
Run in_pieces(const Runs<Run>& run, const std::function<int()>& wait, int& pieces) {
  std::optional<Tape::Content> state;
  const auto save = [&](const Tape::Content& s) { state = s; };
  for (pieces = 0;; ++pieces) {
    std::atomic<bool> stop{false};
    int left = wait();
    KeptRun kept = state ? KeptRun(save, *state) : KeptRun(save);
    SolveControl control;
    control.stop = &stop;
    control.kept = &kept;
    control.progress = [&](const Progress&) { stop = --left <= 0; };
    Run r = run(control);
    if (r.end.verdict.status != Status::interrupted) return r;
  }
}

template <class Run>
void check_in_pieces(const Runs<Run>& run, unsigned seed) {
  int reports = 0;
  SolveControl counting;
  counting.progress = [&](const Progress&) { ++reports; };
  const Run whole = run(counting);
  INFO(app::reason_of(whole.end.verdict));
  REQUIRE(whole.end.verdict.good());
  REQUIRE(whole.instants.size() >= 6);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> length(reports / 8, reports / 3);
  int pieces = 0;
  const Run r = in_pieces<Run>(
      run, [&] { return length(random); }, pieces);
  CHECK(pieces >= 3);
  CHECK(numbers(r) == numbers(whole));  // the same steps: not a bit less
}

void check_warm_up(const Case& c, double end, unsigned seed) {
  WarmUpOptions o;
  o.end = end;
  check_in_pieces<WarmUp>(
      [&](const SolveControl& control) { return warm_up(c, c.model.tier, o, control); }, seed);
}

void check_course(const std::vector<Stretch>& stretches, unsigned seed) {
  check_in_pieces<CourseRun>(
      [&](const SolveControl& control) {
        return run_course(stretches, stretches.front().subject.model.tier, {}, control);
      },
      seed);
}

}  // namespace

TEST_CASE("AWarmUpStoppedAndGoneOnWithIsTheWhole", "[kept]") {
  check_warm_up(coarse(Tier::thd), INFINITY, 3);
}

TEST_CASE("AWarmUpOfElasticSurfacesStoppedAndGoneOnWithIsTheWhole", "[kept]") {
  check_warm_up(coarse(Tier::tehd), 100.0, 4);
}

TEST_CASE("AWarmUpOverACycleStoppedAndGoneOnWithIsTheWhole", "[kept]") {
  check_warm_up(swinging(Tier::tehd), 20.0, 5);
}

TEST_CASE("ACourseStoppedAndGoneOnWithIsTheWhole", "[kept]") {
  check_course(run_up(coarse(Tier::thd), 20.0), 6);
}

TEST_CASE("ACourseOverCyclesStoppedAndGoneOnWithIsTheWhole", "[kept]") {
  check_course(run_up(swinging(Tier::thd), 1.0), 7);
}

TEST_CASE("AWarmUpThatWasKeptAtItsEndIsNotMarchedAgain", "[kept]") {
  for (const Case& c : {coarse(Tier::thd), swinging(Tier::thd)}) {
    std::optional<Tape::Content> state;
    const auto save = [&](const Tape::Content& s) { state = s; };
    WarmUpOptions o;
    o.end = 2.0;
    KeptRun kept(save);
    SolveControl control;
    control.kept = &kept;
    const WarmUp whole = warm_up(c, c.model.tier, o, control);
    REQUIRE(whole.end.verdict.good());
    kept.keep_noted();  // as the program does where it is stopped later on
    REQUIRE(state);
    KeptRun later(save, *state);
    int reports = 0;
    control.kept = &later;
    control.progress = [&](const Progress&) { ++reports; };
    CHECK(numbers(warm_up(c, c.model.tier, o, control)) == numbers(whole));
    CHECK(reports == 0);
  }
}

TEST_CASE("AKeptMarchThatIsCutShortIsRefused", "[kept]") {
  const Case c = coarse(Tier::thd);
  WarmUpOptions o;
  o.end = 2.0;
  std::optional<Tape::Content> state;
  KeptRun kept([&](const Tape::Content& s) { state = s; });
  SolveControl control;
  control.kept = &kept;
  static_cast<void>(warm_up(c, c.model.tier, o, control));
  kept.keep_noted();
  REQUIRE(state);
  const auto go_on = [&](Tape::Content from) {
    KeptRun later([](const Tape::Content&) {}, std::move(from));
    control.kept = &later;
    static_cast<void>(warm_up(c, c.model.tier, o, control));
  };
  Tape::Content shorter = *state;
  shorter.numbers.pop_back();
  CHECK_THROWS_AS(go_on(shorter), FileError);
  Tape::Content longer = *state;
  longer.counts.push_back(0);
  CHECK_THROWS_AS(go_on(longer), FileError);
}
