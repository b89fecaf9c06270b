// The stability map: scenes read, results looked through, rows judged, and a few hard scenes on
// coarse grids without anything wrong, hung, crashed or not a number.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/reading/case_text.hpp"
#include "app/reading/read_case.hpp"
#include "bearing/steady/solve.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "validation/stress/stress_judge.hpp"
#include "validation/stress/stress_list.hpp"
#include "validation/stress/stress_map.hpp"
#include "validation/stress/stress_picture.hpp"
#include "validation/stress/stress_table.hpp"

using namespace shellback;
using namespace shellback::validation;

namespace {

const std::string kFolder = std::string(SHELLBACK_SOURCE_DIR) + "/validation/stress";

const char* const kScene = R"([[scene]]
name = "a"
title = "A"
case = "plain.toml"
tiers = ["isothermal", "thd"]
set = ["operation.load=500 N"]
vary = "operation.speed"
values = ["3000 rpm", "30 rpm"]
trend = "h_min falls"
expect = "e"
)";

std::vector<StressScene> parsed(const std::string& text) {
  return parse_stress_scenes(text, "scenes.toml", kFolder, false);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

/// A plain, small, converged result and its case.
struct Solved {
  bearing::Case subject;
  bearing::Result result;
};
Solved solved() {
  Solved s;
  s.subject = app::read_case(kFolder + "/plain.toml", {app::parse_override("model.tier=thd"),
                                                       app::parse_override("model.grid=[48, 8]")});
  s.result = bearing::solve(s.subject);
  REQUIRE(s.result.verdict.good());
  return s;
}

StressAnswer looked_through(const Solved& s) {
  StressAnswer a;
  look_through(s.subject, s.result, a);
  return a;
}

StressCell cell(double friction, double h) {
  StressCell c;
  c.result = StressClass::converged;
  c.answer.quantities = {{"friction_torque", friction}, {"h_min", h}};
  return c;
}

}  // namespace

TEST_CASE("ASceneIsARowPerTier") {
  const auto rows = parsed(kScene);
  REQUIRE(rows.size() == 2);
  CHECK(full_name(rows[1]) == "a/thd");
  CHECK(words_of(rows[0], rows[0].steps[1], {}) ==
        std::vector<std::string>{"operation.load=500 N", "operation.speed=30 rpm"});
  CHECK(rows[0].trend.falls);
  CHECK(rows[0].expects.words.empty());
  const auto judged = parsed(std::string(kScene) + "expects = { thd = \"steady to 3000 rpm\" }\n");
  CHECK_FALSE(judged[0].expects.steady(0));
  CHECK(judged[1].expects.steady(0));
  CHECK_FALSE(judged[1].expects.steady(1));
}

TEST_CASE("WrongSceneFilesAreRefusedAtTheirPlace") {
  for (const auto& [what, by] :
       {std::pair{"title", "titel"},
        {"[\"isothermal\", \"thd\"]", "[\"isothermal\", \"thx\"]"},
        {"h_min falls", "h_min stays"},
        {"expect = \"e\"", "expect = \"e\"\nexpects = \"steady to 3 rpm\""},
        {"expect = \"e\"", "expect = \"e\"\nexpects = { tehd = \"steady\" }"},
        {"[\"3000 rpm\", \"30 rpm\"]", "[]"},
        {"name = \"a\"", ""}}) {
    INFO(what);
    try {
      static_cast<void>(parsed(replaced(kScene, what, by)));
      FAIL("accepted");
    } catch (const InputError& error) {
      CHECK(std::string(error.what()).find("scenes.toml:") == 0);
    }
  }
  CHECK_THROWS_AS(parsed(std::string(kScene) + kScene), InputError);
  CHECK_THROWS_AS(chosen_stress_scenes(parsed(kScene), {"b"}), InputError);
  CHECK(chosen_stress_scenes(parsed(kScene), {"a/thd"}).size() == 1);
}

TEST_CASE("EveryShippedSceneBeginsHarmless") {
  // Every value of every shipped scene is a case that the reader takes.
  for (const StressScene& scene : shipped_stress_scenes(false)) {
    for (const StressStep& step : scene.steps) {
      INFO(full_name(scene) << " " << step.label);
      std::vector<app::Override> changes;
      for (const std::string& word : words_of(scene, step, {})) {
        changes.push_back(app::parse_override(word));
      }
      CHECK_NOTHROW(app::read_case(scene.case_path, changes, {scene.tier}));
    }
  }
}

TEST_CASE("PlantedFaultsAreSeen") {
  const Solved good = solved();
  CHECK(looked_through(good).faults.empty());
  const auto faults_of = [&](auto&& spoil) {
    Solved bad = good;
    spoil(bad.result);
    return looked_through(bad);
  };
  using bearing::Result;
  CHECK(faults_of([](Result& r) { r.fields.theta[7] = 1.1; }).faults.size() == 1);
  CHECK(faults_of([](Result& r) { r.fields.p[7] = -1e4; }).faults.size() == 1);
  CHECK(faults_of([](Result& r) { r.fields.h[7] = -1e-6; }).faults.size() == 1);
  CHECK(faults_of([](Result& r) { r.fields.T[7] = 200.0; }).faults.size() == 1);
  CHECK(faults_of([](Result& r) { r.fields.T[7] = 3000.0; }).faults.size() == 1);
  CHECK(faults_of([](Result& r) { r.audit.mass = 1e-6; }).faults.size() == 1);
  CHECK(faults_of([](Result& r) { r.audit.load = 1e-3; }).faults.size() == 1);
  CHECK(faults_of([](Result& r) { r.audit.energy = 1.0; }).faults.size() == 1);
  // A balance that the tier has, and that gives no number, is not met.
  CHECK(faults_of([](Result& r) { r.audit.mass = NAN; }).not_a_number);
  CHECK(faults_of([](Result& r) { r.audit.energy = NAN; }).not_a_number);
  CHECK(faults_of([](Result& r) { r.audit.load = NAN; }).not_a_number);
  CHECK(faults_of([](Result& r) { r.audit.moment = INFINITY; }).not_a_number);
  CHECK(faults_of([](Result& r) { r.fields.p[7] = NAN; }).not_a_number);
  CHECK(faults_of([](Result& r) { r.quantities[0].value = INFINITY; }).not_a_number);
}

TEST_CASE("ABalanceThatATierDoesNotHaveIsNotAsked") {
  const bearing::Case c = app::read_case(
      kFolder + "/plain.toml",
      {app::parse_override("model.tier=isothermal"), app::parse_override("model.grid=[48, 8]"),
       app::parse_override("operation={ speed = \"3000 rpm\", load_angle = \"270 deg\", "
                           "attitude_angle = \"40 deg\", eccentricity_ratio = 0.5 }")});
  const bearing::Result r = bearing::solve(c);
  REQUIRE(r.verdict.good());
  CHECK(std::isnan(r.audit.energy));  // one temperature
  CHECK(std::isnan(r.audit.load));    // the position is given
  CHECK(looked_through({c, r}).faults.empty());
}

TEST_CASE("AnswersPassBetweenProcessesWhole") {
  StressAnswer a;
  a.status = "converged";
  a.reason = "why \xff not";  // not UTF-8: must not end the child
  a.audit.energy = NAN;
  a.quantities = {{"h_min", 1.25e-6}, {"friction_torque", NAN}};
  a.faults = {"one", "two"};
  const StressAnswer b = answer_from(to_text(a));
  CHECK(b.converged());
  CHECK(b.value("h_min") == 1.25e-6);
  CHECK(std::isnan(b.value("friction_torque")));
  CHECK(std::isnan(b.audit.energy));
  CHECK(b.faults == a.faults);
  CHECK_FALSE(b.meets_bound);
  a.meets_bound = true;
  CHECK(answer_from(to_text(a)).meets_bound);
}

TEST_CASE("AMirrorImageOfAMirrorImageIsTheBearing") {
  bearing::Case c = solved().subject;
  c.supplies[0].angle = 1.9;
  c.bearing.profile = bearing::Profile{{0.0, 1.0, 2.5}, {-1e-3, 1e-3}, {1, 2, 3, 4, 5, 6}};
  c.operation.alignment = bearing::TiltGiven{1e-4, 2e-4};
  const bearing::Case once = mirrored(c);
  CHECK(once.operation.omega == -c.operation.omega);
  CHECK(once.bearing.profile->phi[1] == Approx(2.0 * M_PI - 2.5));
  const bearing::Case twice = mirrored(once);
  CHECK(twice.supplies[0].angle == Approx(c.supplies[0].angle));
  CHECK(twice.bearing.profile->height == c.bearing.profile->height);
  CHECK(std::get<bearing::TiltGiven>(twice.operation.alignment).about_x == 1e-4);
}

TEST_CASE("BrokenTrendsAndDifferencesAreWrong") {
  StressRow row;
  row.scene = parsed(kScene).front();
  row.cells.assign(stress_methods().size(), std::vector<StressCell>(2));
  row.cells[0] = {cell(1.0, 2e-6), cell(1.0, 3e-6)};  // the film must fall
  row.cells[1] = {cell(1.2, 2e-6), cell(1.0, 3e-6)};  // 20 % off in the first
  judge_row(row);
  CHECK(row.cells[0][0].result == StressClass::converged);
  CHECK(row.cells[0][1].result == StressClass::wrong);
  CHECK(row.cells[1][0].result == StressClass::wrong);
  CHECK(row.cells[1][1].result == StressClass::converged);  // nothing sound to compare with
}

TEST_CASE("HardScenesOnCoarseGridsAreSound", "[stress]") {
  const auto scenes = chosen_stress_scenes(
      shipped_stress_scenes(true),
      {"eccentricity", "load-smooth/isothermal", "speed-reversed/isothermal", "speed-engine/thd",
       "tilt-smooth/isothermal", "supply-angle/isothermal", "axial-grooves/thd"});
  StressOptions options;
  options.at_once = 2;
  options.only_default = true;
  const StressMap map = stress_map(scenes, options);
  CHECK(map.complete);
  for (const StressRow& row : map.rows) {
    for (std::size_t k = 0; k < row.scene.steps.size(); ++k) {
      const StressCell& c = row.cells.front()[k];
      INFO(full_name(row.scene) << " " << row.scene.steps[k].label << ": " << to_string(c.result)
                                << ": " << c.why);
      CHECK_FALSE(is_fault(c.result));
      CHECK(c.result != StressClass::not_run);
    }
    CHECK(row.cells.front().front().result == StressClass::converged);  // the harmless end
  }
  CHECK(map.shipped_is_sound());
  // What is written of it knows every row.
  const std::string page = stress_page(map, "map.svg", "shellback stress");
  const std::string picture = stress_svg(map);
  const std::string csv = stress_csv(map);
  for (const StressRow& row : map.rows) {
    CHECK(page.find("### " + row.scene.name) != std::string::npos);
    CHECK(picture.find(row.scene.title) != std::string::npos);
    CHECK(csv.find(row.scene.name + "," + to_string(row.scene.tier)) != std::string::npos);
  }
}

TEST_CASE("LoadsBeyondATurnThatHaveAStateAreNotRefused", "[stress][refusal]") {
  // Boundary friction heats the dry middle of the bearing: the branch from light loads turns at
  // 10.9 kN, and the bearing comes to rest hot and pressed beyond. Judge: a load that is found from
  // cold is less than what the refusal of a larger one says is carried.
  constexpr const char* kText = R"toml(
bearing = { diameter = "50 mm", width = "20 mm", radial_clearance = "25 um" }
operation = { speed = "283 rpm", load = "12 kN" }
oil = { name = "0W20", temperature = "80 degC" }
shaft = { material = "steel" }
model = { tier = "tehd", grid = [60, 9] }
[[supply]]
kind = "hole"
angle = "90 deg"
diameter = "5 mm"
depth = "1 mm"
pressure = "2 bar"
temperature = "80 degC"
[shell]
layers = [ { material = "AlSn20", thickness = "0.3 mm" }, { material = "steel", thickness = "1.7 mm" } ]
housing = { material = "aluminium", outer_diameter = "90 mm" }
back = { heat_transfer = "300 W/(m2 K)", ambient = "70 degC" }
[surfaces]
shell = { roughness = "0.4 um", summit_roughness = "0.35 um", summit_height = "0.4 um" }
contact = { elastic_factor = 0.001, composite_modulus = "53 GPa", friction = 0.12 }
)toml";
  const auto under = [&](const std::string& load) {
    const bearing::Case c = app::read_case_text(kText, "turn.toml", {app::parse_override(load)});
    return bearing::solve_tier(c, c.model.tier);
  };
  CHECK(under("operation.load=12 kN").verdict.good());
  const bearing::Solution heavy = under("operation.load=40 kN");
  REQUIRE_FALSE(heavy.verdict.good());
  REQUIRE_FALSE(heavy.limits.empty());
  CHECK(heavy.limits.back().part * 40e3 > 12e3);
}

TEST_CASE("AStateThatIsNotFoundIsNoEndOfItsBranch") {
  // Walls that come to rest under the whole as loosely as on the way, where no result is found: "up
  // to 3000 rpm of 3000 rpm, then none" was told.
  bearing::Case c = app::read_case(
      kFolder + "/plain.toml",
      {app::parse_override("shell.layers=[{ material = \"polymer\", thickness = \"5 mm\" }, "
                           "{ material = \"steel\", thickness = \"2.5 mm\" }]"),
       app::parse_override("shell.housing.support=free")});
  c.model.grid = {72, 11};
  c.operation.omega = 3000.0 * kRpm;
  const bearing::Solution s = bearing::solve_tier(c, bearing::Tier::tehd);
  CHECK_FALSE(s.verdict.good());
  REQUIRE_FALSE(s.limits.empty());
  CHECK(s.limits.back().part < 0.93);  // 60 x 9 to 120 x 17 cells: 2680 to 2740 rpm
  CHECK(s.limits.back().part > 0.87);
}

TEST_CASE("WhereTheRigidPlainBearingEndsDoesNotDependOnTheLoadAskedFor") {
  // 40 and 45 kN were given up, the start of the search having taken the work of the branch.
  const auto under = [](double load, std::array<int, 2> grid) {
    bearing::Case c = app::read_case(kFolder + "/plain.toml");
    c.model.grid = grid;
    c.operation.position = bearing::LoadGiven{load, 1.5 * kPi};
    return bearing::solve_tier(c, bearing::Tier::isothermal);
  };
  const auto end_of = [&](double load, std::array<int, 2> grid) {
    const bearing::Solution s = under(load, grid);
    INFO(load << " N");
    CHECK(s.verdict.status == Status::no_steady_state);
    return std::hypot(s.film.force[0], s.film.force[1]);
  };
  const double end = end_of(60e3, {100, 13});
  for (const double load : {34e3, 40e3, 45e3, 60e3}) {
    CHECK(end_of(load, {200, 25}) == Approx(end).epsilon(0.02));  // twice the path's last step
  }
  // 33 kN lie a thousandth beyond what these cells carry, and others carry them.
  CHECK(under(33e3, {200, 25}).verdict.status == Status::iteration_limit);
  CHECK(under(33e3, {300, 38}).verdict.good());
}
