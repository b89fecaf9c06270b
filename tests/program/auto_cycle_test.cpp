/// Tier auto over shipped load cycles against finer grids and richer tiers.
#include "fidelity/auto_cycle.hpp"

#include <fmt/format.h>

#include <atomic>
#include <catch2/catch.hpp>

#include "app/reading/case_text.hpp"
#include "app/reading/library.hpp"
#include "app/reading/read_case.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"
#include "bearing/judge/judge_case.hpp"
#include "core/constants.hpp"
#include "fidelity/cycle_bars.hpp"
#include "tests/app/sample_case.hpp"
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

/// A bearing that a drilling of its journal alone feeds, under a load that turns at once and at
/// half the speed; `supply`: more keys of it.
Case drilled(const ScratchFolder& folder, double diameter, const std::string& supply,
             double tolerance) {
  std::string rows = "angle [deg], load_x [N], load_y [N]\n";
  for (int degrees = 0; degrees < 720; degrees += 20) {
    const double a = degrees * kPi / 180.0;
    rows += fmt::format("{}, {:.4f}, {:.4f}\n", degrees,
                        900.0 * std::cos(0.5 * a) + 400.0 * std::cos(a),
                        -1200.0 + 900.0 * std::sin(0.5 * a) + 400.0 * std::sin(a));
  }
  std::string text = read_text_file(case_path("rotating-load").string());
  const std::size_t from = text.find("[[supply]]"), to = text.find("[operation]");
  text.replace(from, to - from,
               fmt::format("[[supply]]\nkind = \"drilling\"\nangle = \"90 deg\"\ndiameter = "
                           "\"{} mm\"\npressure = \"2 bar\"\ntemperature = \"60 degC\"\n{}\n",
                           1e3 * diameter, supply));
  folder.write("rot.csv", rows);
  return read_case(folder.write("case.toml", text),
                   {{"load_cycle.file", "\"rot.csv\"", "--set"},
                    {"load_cycle.period", "\"720 deg\"", "--set"},
                    {"model.grid", "[60, 8]", "--set"},
                    {"model.tolerance", fmt::format("\"{} %\"", 100.0 * tolerance), "--set"}});
}

}  // namespace

TEST_CASE("CyclesThatOnlyTheChoiceOfStepsKeepsApartAreFound") {
  // They differ by 1e-5 for ever, which might be the end of a slow approach; it is none.
  const ScratchFolder folder;
  const std::string vessel = "vessel_volume = \"1 cm3\"\nopen = [\"0 deg\", \"400 deg\"]\n";
  std::vector<double> torques;
  for (const double tolerance : {0.01, 0.009}) {
    const CycleResult r = solve_cycle(drilled(folder, 3e-3, vessel, tolerance), Tier::isothermal);
    INFO(tolerance << ": " << r.cycles << " cycles, " << app::reason_of(r.verdict));
    REQUIRE(r.verdict.good());
    CHECK(r.cycles < 100);
    CHECK(r.closure <= 1e-4);
    torques.push_back(value_of(r, "friction_torque"));
  }
  // By as much as their steps may err: a tenth of the tolerance each in the film.
  CHECK(torques[0] == Approx(torques[1]).epsilon(1e-3));
}

TEST_CASE("BarsOfTimeBesideADrillingHoldShorterSteps") {
  // Half the width of its mouth bounds the steps, whatever they err. The largest pressure is a
  // spike of a step or two where the mouth passes, which no bar of steps holds (decision 086).
  const ScratchFolder folder;
  Case c = drilled(folder, 5e-3, "", 0.1);
  const auto r = fidelity::cycle_with_bars_of_steps(c, {});
  REQUIRE(r);
  c.cycle->step = c.cycle->period / 720.0;
  const CycleResult fine = solve_cycle(c, Tier::isothermal);
  REQUIRE(fine.verdict.good());
  for (const char* name : {"friction_torque", "power_loss", "side_flow"}) {
    const Quantity& q = bearing::quantity_named(*r, name)->quantity;
    INFO(name << " " << q.value << " +- " << q.error_time << ", " << value_of(fine, name));
    CHECK(std::abs(q.value - value_of(fine, name)) <= q.error_time);
  }
}

TEST_CASE("AutoOverARotatingLoadIsWithinItsTolerance") {
  check_within("rotating-load", 0.15, "\"15 %\"");
}

TEST_CASE("AutoOverAPulseIsWithinItsTolerance") { check_within("pulse", 0.05, "\"5 %\""); }

TEST_CASE("AutoOverACycleFindsAGridForMorePassagesThanItsFirstProbesHold") {
  Case c = shipped("pulse", "\"50 %\"");
  c.model.grid_given = false;
  Supply hole = c.supplies.front();
  hole.kind = SupplyKind::hole;
  hole.diameter = 0.5e-3;
  hole.arc = hole.length = hole.diameter / c.bearing.radius;
  c.supplies.clear();
  for (int k = 0; k < 42; ++k) {  // 84 edges around: more than 80 cells
    hole.angle = 2.0 * kPi * (k + 0.5) / 42.0;
    c.supplies.push_back(hole);
  }
  const CycleResult r = fidelity::solve_auto_cycle(c);
  INFO(app::reason_of(r.verdict));
  REQUIRE(r.verdict.good());
  CHECK(r.grid[0] >= 84);
}

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
  Case c = shipped("pulse", "\"2 %\"");
  c.model.grid_given = false;
  std::atomic<bool> stop{false};
  const auto run = [&](int most, int& steps) {
    SolveControl control;
    control.stop = &stop;
    stop = false;
    steps = 0;
    control.progress = [&](const Progress&) { stop = ++steps >= most; };
    return fidelity::solve_auto_cycle(c, control);
  };
  int all = 0, until = 0;
  const CycleResult whole = run(1000000, all);
  REQUIRE(whole.verdict.good());
  REQUIRE(whole.grid[0] > 96);  // it took more than the first grid
  bool found = false;           // a whole cycle on one of the grids
  for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9, 0.97}) {
    const CycleResult r = run(static_cast<int>(part * all), until);
    INFO(part << " of the steps, shown: " << r.grid[0] << " x " << r.grid[1]);
    CHECK(r.verdict.status == Status::interrupted);
    REQUIRE(!r.instants.empty());
    const bool ended = r.instants.back().t == Approx(c.cycle->length()).epsilon(1e-9);
    if (found) CHECK(ended);
    found = found || (ended && r.grid[0] >= 96);
  }
  CHECK(found);
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
