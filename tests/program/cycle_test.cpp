/// run on a case with a load cycle: what is refused, before anything is solved.
#include <catch2/catch.hpp>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/program/commands.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/library.hpp"
#include "app/reading/read_case.hpp"
#include "core/contract.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/program/run_words.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::program;
using namespace shellback::program::tests;

TEST_CASE("ALoadCycleHasNoStiffnessAndDamping") {
  bearing::Case subject = read_case_text(kSampleCase, "case.toml", {});
  subject.cycle = bearing::LoadCycle{};
  subject.model.coefficients = true;
  Request request;
  request.command = Command::run;
  CHECK_THROWS_WITH(cycle(request, kSampleCase, subject),
                    Catch::Contains("model.coefficients") && Catch::Contains("load cycle"));
  request.coefficients = true;
  CHECK_THROWS_WITH(cycle(request, kSampleCase, subject), Catch::StartsWith("--coefficients"));
}

TEST_CASE("RigidSurfacesThatCannotCarryTheShippedCycleAreNoDefect") {
  // Oil that pressure does not thicken is carried on to temperatures that no oil has.
  const Ended ended = run_words(
      {"run", case_path("ks-rig-cycle").string(), "--tier", "thd", "--set", "model.grid=[24,5]",
       "--set", "model.elastic_deformation=false", "--set", "model.pressure_dependence=false"});
  CHECK(ended.code == kNotConverged);
  check_parts(ended.err, {"no step in time is found", "leaves what an oil can be"});
}

TEST_CASE("TablesAndTimesAreOfWhatChangesInTime") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", kSampleCase);
  const auto said_of = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"run", file};
    words.insert(words.end(), options.begin(), options.end());
    const Ended ended = run_words(words);
    CHECK(ended.code == kBadInput);
    CHECK(ended.out.empty());
    return ended.err;
  };
  check_parts(said_of({"--csv", scratch.path("a.csv")}), {"--csv", "load cycle", "sweep"});
  check_parts(said_of({"--page", scratch.path("a.html"), "--transient"}), {"--page"});
  check_parts(said_of({"--until", "2 s"}), {"--until", "--transient"});
  check_parts(said_of({"--speeds", "2000 rpm"}), {"--speeds", "--transient"});
  check_parts(said_of({"--hold", "2 s"}), {"--hold", "--transient"});
  check_parts(said_of({"--transient", "--hold", "2 s"}), {"--hold", "--speeds"});
  check_parts(said_of({"--transient", "--speeds", "2000 rpm"}), {"--speeds", "--hold"});
  check_parts(said_of({"--transient", "--speeds", "2000 rpm", "--hold", "2 m"}), {"--hold"});
  check_parts(said_of({"--transient", "--speeds", "2000 rpm", "--hold", "0 s"}), {"positive"});
  check_parts(said_of({"--transient", "--speeds", "2000", "--hold", "2 s"}), {"--speeds", "unit"});
  check_parts(said_of({"--transient", "--speeds", "2000 rpm", "--hold", "2 s", "--until", "3 s"}),
              {"--until"});
}

TEST_CASE("ACourseOverACycleIsRefusedSpeedsThatItsTableHasAndLessThanACycle") {
  const ScratchFolder scratch;
  const std::string own = "time [ms], load_x [N], load_y [N], speed [rpm]\n";
  const std::string given = "time [ms], load_x [N], load_y [N]\n";
  const auto said_of = [&](const std::string& table, const std::vector<std::string>& options) {
    scratch.write("load.csv", table);
    const std::string file =
        scratch.write("case.toml", sample_with("load = \"5 kN\"\n",
                                               "\n[load_cycle]\nfile = \"load.csv\"\n"
                                               "period = \"40 ms\"\n"));
    std::vector<std::string> words{"run", file, "--transient"};
    words.insert(words.end(), options.begin(), options.end());
    const Ended ended = run_words(words);
    CHECK(ended.code == kBadInput);
    return ended.err;
  };
  const std::string swings = own + "0, 0, -4000, 2000\n20, 0, -5000, 3000\n40, 0, -4000, 2000\n";
  const std::string plain = given + "0, 0, -4000\n20, 0, -5000\n40, 0, -4000\n";
  check_parts(said_of(swings, {"--speeds", "4000 rpm", "--hold", "1 s"}),
              {"--speeds", "speeds of its own", "column speed"});
  check_parts(said_of(plain, {"--speeds", "4000 rpm", "--hold", "30 ms"}),
              {"--hold", "one load cycle, 0.04 s"});
  check_parts(said_of(plain, {"--until", "30 ms"}), {"--until", "one load cycle, 0.04 s"});
}

TEST_CASE("NoOptionOfRunIsIgnoredBesideAnother") {
  const ScratchFolder scratch;
  const std::string steady = scratch.write("case.toml", kSampleCase);
  const std::string wearing = case_path("running-in").string();
  const std::string cyclic = case_path("pulse").string();
  const std::string file = scratch.path("a");
  using Words = std::vector<std::string>;
  const std::vector<Words> of_transients{
      {"--from", "20 degC"}, {"--until", "2 s"}, {"--speeds", "2000 rpm"}, {"--hold", "2 s"}};
  const std::vector<Words> of_steady_states{{"--coefficients"}, {"--coefficients-table", file}};
  const auto check_all = [&](Words words, const std::vector<Words>& options,
                             const std::string& reason) {
    for (const Words& option : options) {
      Words all = words;
      all.insert(all.end(), option.begin(), option.end());
      const Ended ended = run_words(all);
      INFO(all[1] << " " << option[0] << ": " << ended.err);
      CHECK(ended.code == kBadInput);
      CHECK(ended.out.empty());
      check_parts(ended.err, {"error: " + option[0] + ": ", reason});
    }
  };
  check_all({"run", wearing, "--running-in"}, of_transients, "belongs to a transient");
  check_all({"run", wearing, "--running-in"}, of_steady_states, "a running-in is asked for");
  check_all({"run", wearing, "--running-in"}, {{"--transient"}, {"-o", file}, {"--page", file}},
            "a running-in writes");
  check_all({"run", cyclic}, of_transients, "add --transient");
  check_all({"run", cyclic}, of_steady_states, "load cycle");
  check_all({"run", cyclic}, {{"--profile", file}}, "add --running-in");
  check_all({"run", steady, "--transient"}, of_steady_states, "a transient is asked for");
  check_all({"run", steady, "--transient", "--speeds", "2000 rpm", "--hold", "2 s"},
            of_steady_states, "a transient is asked for");
  check_all({"run", steady, "--transient"}, {{"-o", file}, {"--page", file}}, "a transient writes");
  check_all({"run", steady}, of_transients, "add --transient");
  const Ended key = run_words({"run", wearing, "--running-in", "--set", "model.coefficients=true"});
  CHECK(key.code == kBadInput);
  check_parts(key.err, {"model.coefficients", "leave out one of them"});
}

/// The smallest films of a sweep over the rotating load [m].
std::vector<double> films_of_sweep(const std::vector<std::string>& more) {
  std::vector<std::string> words{
      "sweep",    case_path("rotating-load").string(), "--set", "model.grid=[32,5]",
      "--set",    "load_cycle.step=\"8 deg\"",         "--csv", "-",
      "--no-bars"};
  words.insert(words.end(), more.begin(), more.end());
  const Ended ended = run_words(words);
  REQUIRE(ended.code == kDone);
  std::vector<double> h_min;
  std::istringstream rows(ended.out);
  std::string row;
  std::getline(rows, row);
  std::size_t column = 0;
  {
    std::istringstream head(row);
    for (std::string name; std::getline(head, name, ','); ++column) {
      if (name == "h_min [m]") break;
    }
  }
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    std::string cell;
    for (std::size_t k = 0; k <= column; ++k) std::getline(cells, cell, ',');
    h_min.push_back(std::stod(cell));
  }
  return h_min;
}

TEST_CASE("ASweepRunsCyclesOverTheLoad") {
  const auto h_min = films_of_sweep({"--vary", "load_cycle.factor=0.5,1"});
  REQUIRE(h_min.size() == 2);
  CHECK(h_min[0] > h_min[1]);   // half the load
  for (const int k : {0, 1}) {  // each as a run on its own finds it
    const Ended alone =
        run_words({"run", case_path("rotating-load").string(), "--set", "model.grid=[32,5]",
                   "--set", "load_cycle.step=\"8 deg\"", "--set",
                   k == 0 ? "load_cycle.factor=0.5" : "load_cycle.factor=1", "--json", "-"});
    REQUIRE(alone.code == kDone);
    const auto found = nlohmann::json::parse(alone.out)["quantities"]["h_min"]["value"];
    CHECK(h_min[k] == Approx(found.get<double>()).epsilon(1e-9));
  }
}

TEST_CASE("ASweepRunsCyclesOverTheSpeed") {
  // The film of a journal without mass knows speed times viscosity alone; the load comes over the
  // angle.
  const auto h_min = films_of_sweep({"--vary", "operation.speed=1500 rpm,3000 rpm"});
  REQUIRE(h_min.size() == 2);
  CHECK(h_min[0] < h_min[1]);
  const auto thick = films_of_sweep({"--vary", "operation.speed=1500 rpm", "--set",
                                     "oil.viscosity.temperature.eta=\"30 mPa s\""});
  REQUIRE(thick.size() == 1);
  CHECK(thick[0] == Approx(h_min[1]).epsilon(1e-6));
}

/// The shipped bearing under a load that swings by a half once in two turns.
std::string swinging_case(const ScratchFolder& scratch) {
  std::istringstream shipped(read_text_file(case_path("thd-plain-bearing").string()));
  std::string text;
  for (std::string line; std::getline(shipped, line);) {
    if (!line.starts_with("load")) text += line + '\n';
  }
  scratch.write("swing.csv",
                "angle [deg], load [kN], direction [deg]\n"
                "0, 2, 270\n180, 3, 270\n360, 4, 270\n540, 3, 270\n");
  return scratch.write("swing.toml", text +
                                         "[load_cycle]\nfile = \"swing.csv\"\n"
                                         "period = \"720 deg\"\n"
                                         "interpolation = \"periodic_spline\"\n");
}

TEST_CASE("CommandsTakeTierEstimateOverACycle") {
  // All outputs without a field; the sweep, with bars and without, is the estimate's own.
  const ScratchFolder scratch;
  const std::string file = case_path("pulse").string();
  const Ended run = run_words({"run", file, "--tier", "estimate", "--json", scratch.path("e.json"),
                               "-o", scratch.path("e.h5"), "--page", scratch.path("e.html"),
                               "--picture", scratch.path("e.svg")});
  INFO(run.err);
  REQUIRE(run.code == kDone);
  check_parts(run.out, {"tier estimate, converged", "smallest film", "mobility", "+- physics"});
  CHECK(run.out.find("supply flow") == std::string::npos);
  const std::string json = read_text_file(scratch.path("e.json"));
  check_parts(json, {"\"h_min\"", "\"eccentricity_x\"", "\"error_model\""});
  for (const char* unknown : {"\"supply_flow\"", "\"tilt_x\"", "\"T_film_max\""}) {
    CHECK(json.find(unknown) == std::string::npos);
  }
  CHECK(read_text_file(scratch.path("e.svg")).find("nan") == std::string::npos);
  const auto swept = [&](std::vector<std::string> more) {
    std::vector<std::string> words{
        "sweep", file, "--tier", "estimate", "--vary", "load_cycle.factor=1,2", "--csv", "-"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = run_words(words);
    CHECK(ended.code == kDone);
    check_parts(ended.out, {"estimate"});
    // What the sweep costs and how its rows end depends on the run; its first numbers do not.
    const auto first = ended.out.find("\n1,");
    return ended.out.substr(first, 60);
  };
  CHECK(swept({}) == swept({"--no-bars"}));
  check_parts(run_words({"run", case_path("start-stop").string(), "--tier", "estimate"}).err,
              {"model.tier", "at rest", "take tier isothermal"});
  check_parts(run_words({"compare", file, "--tiers", "estimate,isothermal"}).err,
              {"no film of its own"});
  check_parts(run_words({"check", file}).out, {"Estimate of the cycle", "smallest film"});
}

TEST_CASE("CompareTakesALoadCycle") {
  const ScratchFolder scratch;
  const Ended ended = run_words({"compare", swinging_case(scratch), "--tiers", "isothermal,thd",
                                 "--set", "model.grid=[48,6]", "--picture", scratch.path("a.svg"),
                                 "-o", scratch.path("a.html"), "--json", scratch.path("a.json")});
  INFO(ended.err);
  REQUIRE(ended.code == kDone);
  check_parts(ended.out, {"viscosity level", "viscosity variation", "heat into the shell",
                          "calibrated equivalent temperature"});
  check_parts(read_text_file(scratch.path("a.svg")),
              {"Friction torque", "Largest temperatures", "thd"});
  check_parts(read_text_file(scratch.path("a.html")), {"Over the cycle", "Friction difference"});
  check_parts(read_text_file(scratch.path("a.json")), {"friction_split", "T_calibrated"});
}

/// That the line above the names of the temperatures says which of each it is.
void check_maxima_and_means(const std::string& table) {
  const std::size_t names = table.rfind('\n', table.find("h_min"));
  const std::size_t above = table.rfind('\n', names - 1);
  std::istringstream words(table.substr(above, names - above));
  const std::vector<std::string> said{std::istream_iterator<std::string>(words), {}};
  CHECK(said == std::vector<std::string>{"largest", "largest", "mean", "mean"});
}

TEST_CASE("AWarmUpTellsLargestAndMeanTemperatures") {
  const Ended ended = run_words({"run", case_path("thd-plain-bearing").string(), "--transient",
                                 "--until", "1 s", "--set", "model.grid=[32,5]"});
  INFO(ended.err);
  REQUIRE(ended.code == kDone);
  check_maxima_and_means(ended.out);
}

TEST_CASE("ACourseOfSpeedsTellsEachOfThem") {
  const ScratchFolder scratch;
  const std::string file = case_path("thd-plain-bearing").string();
  const Ended ended =
      run_words({"run", file, "--transient", "--from", "40 degC", "--speeds",
                 "1000 rpm,2000 rpm,1000 rpm", "--hold", "30 s", "--set", "model.grid=[48,6]",
                 "--json", scratch.path("a.json"), "--picture", scratch.path("a.svg")});
  INFO(ended.err);
  REQUIRE(ended.code == kDone);
  check_parts(ended.out, {"1000", "2000", "audit"});
  check_maxima_and_means(ended.out);
  check_parts(read_text_file(scratch.path("a.json")), {"stretches", "\"passed\": true", "T_shaft"});
  check_parts(read_text_file(scratch.path("a.svg")), {"Course of speeds", "speed [rpm]"});
}

TEST_CASE("StudiesAreListedAndNamed") {
  const Ended list = run_words({"study"});
  CHECK(list.code == kDone);
  check_parts(list.out, {"ks-rig"});
  const Ended wrong = run_words({"study", "ks-rgi"});
  CHECK(wrong.code == kBadInput);
  check_parts(wrong.err, {"ks-rgi", "ks-rig"});
  const ScratchFolder scratch;
  const std::string precious = scratch.write("page.html", "mine");
  const Ended kept = run_words({"study", "ks-rig", "-o", precious});
  CHECK(kept.code == kBadInput);
  CHECK(read_text_file(precious) == "mine");
}
