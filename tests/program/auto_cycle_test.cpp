/// Tier auto over shipped load cycles against finer grids and richer tiers.
#include "fidelity/auto_cycle.hpp"

#include <atomic>
#include <catch2/catch.hpp>

#include "app/library.hpp"
#include "app/read_case.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"
#include "bearing/judge_case.hpp"
#include "tests/program/run_words.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::bearing;
using namespace shellback::program::tests;

namespace {

Case shipped(const std::string& name, const std::string& tolerance) {
  return read_case(case_path(name).string(),
                   {{"model.tier", "\"auto\"", "--set"}, {"model.tolerance", tolerance, "--set"}});
}

void check_within(const std::string& name, double tolerance, const std::string& words) {
  Case c = shipped(name, words);
  c.model.grid_given = false;
  const CycleResult r = fidelity::solve_auto_cycle(c);
  INFO(name << ": " << app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  REQUIRE(r.choice);
  CHECK(r.choice->met);
  CHECK(r.choice->bar_friction <= tolerance);
  CHECK(r.choice->bar_h_min <= tolerance);
  Case truth = c;
  truth.model.tier = possible_tiers(c).back();
  truth.model.grid = {140, 20};
  truth.model.tolerance = 0.25 * tolerance;
  const CycleResult fine = solve_cycle(truth, truth.model.tier);
  REQUIRE(fine.verdict.good());
  for (const char* quantity : {"friction_torque", "h_min"}) {
    INFO(quantity);
    CHECK(value_of(r, quantity) == Approx(value_of(fine, quantity)).epsilon(tolerance));
  }
}

}  // namespace

TEST_CASE("AutoOverARotatingLoadIsWithinItsTolerance") {
  check_within("rotating-load", 0.1, "\"10 %\"");
}

TEST_CASE("AutoOverAPulseIsWithinItsTolerance") { check_within("pulse", 0.05, "\"5 %\""); }

TEST_CASE("AutoKeepsTheGridThatACaseGivesAndSaysWhatItIsWorth") {
  Case c = shipped("rotating-load", "\"0.1 %\"");
  c.model.grid = {60, 9};  // not the grid on which the tier is chosen
  c.model.grid_given = true;
  c.cycle->step = c.cycle->period / 90.0;
  const CycleResult r = fidelity::solve_auto_cycle(c);
  REQUIRE(r.verdict.good());
  CHECK(r.grid == std::array{60, 9});
  REQUIRE(r.choice);
  CHECK_FALSE(r.choice->met);
  REQUIRE(!r.warnings.empty());
  CHECK(app::words_of(r.warnings.back()).find("tolerance") != std::string::npos);
}

TEST_CASE("AutoThatIsStoppedOnAFinerGridKeepsTheOneBefore") {
  std::atomic<bool> stop{false};
  const auto run = [&](const char* tolerance, int most, int& steps) {
    Case c = shipped("pulse", tolerance);
    c.model.grid_given = false;
    c.cycle->step = c.cycle->length() / 200.0;  // whatever the tolerance
    SolveControl control;
    control.stop = &stop;
    stop = false;
    steps = 0;
    control.progress = [&](const Progress&) { stop = ++steps >= most; };
    return fidelity::solve_auto_cycle(c, control);
  };
  int first = 0, both = 0;
  const CycleResult coarse = run("\"20 %\"", 1000000, first);
  REQUIRE(coarse.verdict.good());
  const CycleResult stopped = run("\"2 %\"", first + 5, both);  // on the way to a finer grid
  REQUIRE(both >= first + 5);
  CHECK(stopped.verdict.status == Status::interrupted);
  CHECK(stopped.grid == coarse.grid);
  for (std::size_t k = 0; k < coarse.quantities.size(); ++k) {
    const double value = coarse.quantities[k].quantity.value;
    if (std::isfinite(value)) CHECK(stopped.quantities[k].quantity.value == value);
  }
  CHECK(value_of(stopped, "h_min") > 0.0);
  bool told = false;
  for (const Note& n : stopped.assumptions) {
    if (const auto* taken = std::get_if<note::TierTaken>(&n)) {
      told = taken->solved.back().find("(stopped)") != std::string::npos;
    }
  }
  CHECK(told);
}

TEST_CASE("CommandsTakeTierAutoOverACycle") {
  const std::string file = case_path("rotating-load").string();
  CHECK(run_words({"check", file, "--tier", "auto"}).code == program::kDone);
  const Ended run = run_words({"run", file, "--tier", "auto", "--set", "model.tolerance=10 %",
                               "--set", "model.grid=[48,8]"});
  CHECK(run.code == program::kDone);
  CHECK(run.out.find("tier auto took tier") != std::string::npos);
  CHECK(run_words({"compare", file, "--set", "model.tier=\"auto\"", "--set", "model.grid=[48,8]"})
            .code == program::kDone);
}
