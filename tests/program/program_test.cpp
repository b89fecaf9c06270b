/// The whole program in one process: exit codes, and what goes to which stream.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>

#include "app/program/session.hpp"
#include "app/reading/library.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/program/run_words.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::program;
using namespace shellback::program::tests;

namespace {

bool begins_with_brace(const std::string& text) {
  return text.find_first_not_of(" \n") != std::string::npos && text.front() == '{';
}

}  // namespace

TEST_CASE("AnEndingGivesItsExitCode") {
  CHECK(code_of(Verdict{}) == kDone);
  CHECK(code_of(Verdict{Status::no_steady_state}) == kNotConverged);
  CHECK(code_of(Verdict{Status::iteration_limit}) == kNotConverged);
  CHECK(code_of(Verdict{Status::interrupted}) == kInterrupted);
  // A result whose bars were cut off is whole, but its run is not.
  CHECK(code_of(Verdict{}, {bearing::note::Plain::bars_interrupted}) == kInterrupted);
  CHECK(code_of(Verdict{}, {bearing::note::Plain::cycle_bars_unknown}) == kDone);
  CHECK(code_of(Verdict{Status::iteration_limit}, {bearing::note::Plain::bars_interrupted}) ==
        kNotConverged);
  CHECK(code_of(Verdict{Status::invalid_number}) == kDefect);  // not the bearing's fault
}

TEST_CASE("ABadCaseEndsWithTwoAndShowsTheLine") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", sample_with("diameter", "diametre"));
  const Ended ended = run_words({"check", path});
  CHECK(ended.code == kBadInput);
  CHECK(ended.out.empty());
  check_parts(ended.err, {"case.toml:4:1: unknown key \"diametre\"", "diametre = \"50 mm\"",
                          "     4 | ", "       | ^"});
}

TEST_CASE("AMissingFileEndsWithFour") {
  const Ended ended = run_words({"run", "/nowhere/case.toml"});
  CHECK(ended.code == kBadFile);
  check_parts(ended.err, {"no such file"});
}

TEST_CASE("AnOutputThatCannotBeWrittenEndsWithFourBeforeTheWork") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const Ended ended = run_words({"run", path, "--json", "/nowhere/out.json"});
  CHECK(ended.code == kBadFile);
  check_parts(ended.err, {"/nowhere"});
}

TEST_CASE("ABadWordOnTheCommandLineEndsWithTwo") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  CHECK(run_words({"run", path, "--tier", "automatic"}).code == kBadInput);
  check_parts(run_words({"compare", path, "--tiers", "auto,thd"}).err, {"--tiers", "auto"});
  check_parts(run_words({"run", path, "--tier", "tedh"}).err, {"--tier", "did you mean \"tehd\"?"});
  check_parts(run_words({"compare", path, "--tiers", "thd,thd"}).err, {"--tiers", "twice"});
  check_parts(run_words({"run", path, "--set", "operation.speed=3000"}).err,
              {"--set operation.speed", "rpm"});
  check_parts(
      run_words({"run", path, "--set", "operation.load=3 kN", "--set", "operation.load=4 kN"}).err,
      {"--set operation.load", "twice"});
  CHECK(run_words({"frobnicate"}).code == kBadInput);
}

TEST_CASE("CheckPrintsAndEndsWell") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const Ended ended = run_words({"check", path});
  CHECK(ended.code == kDone);
  CHECK(ended.err.empty());
  check_parts(ended.out, {"sample", "Sommerfeld"});
}

TEST_CASE("RunPrintsATableOrJsonNotBoth") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const Ended table = run_words({"run", path, "--tier", "isothermal", "--set", kCoarse});
  INFO(table.err);
  CHECK(table.code == kDone);
  CHECK_FALSE(table.out.empty());
  CHECK_FALSE(begins_with_brace(table.out));
  const Ended json =
      run_words({"run", path, "--tier", "isothermal", "--set", kCoarse, "--json", "-"});
  CHECK(json.code == kDone);
  CHECK(begins_with_brace(json.out));
}

TEST_CASE("RunAndCompareWriteTheirFiles") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const auto exists = [&](const char* name) {
    return std::filesystem::file_size(scratch.path(name)) > 0;
  };
  CHECK(run_words({"run", path, "--tier", "isothermal", "--set", kCoarse, "--json",
                   scratch.path("a.json"), "-o", scratch.path("a.h5")})
            .code == kDone);
  CHECK(exists("a.json"));
  CHECK(exists("a.h5"));
  const Ended compared = run_words({"compare", path, "--tiers", "isothermal,lumped", "--set",
                                    kCoarse, "--json", scratch.path("b.json"), "-o",
                                    scratch.path("b.html"), "--picture", scratch.path("b.svg")});
  INFO(compared.err);
  CHECK(compared.code == kDone);
  CHECK(exists("b.json"));
  CHECK(exists("b.html"));
  CHECK(exists("b.svg"));
}

TEST_CASE("WarningsGoToStandardError") {
  const ScratchFolder scratch;
  const auto path = scratch.write(
      "case.toml", sample_with("temperature = \"90 degC\"", "temperature = \"160 degC\""));
  const Ended ended =
      run_words({"run", path, "--tier", "isothermal", "--set", kCoarse, "--json", "-"});
  check_parts(ended.err, {"warning: ", "outside the range"});
  CHECK(begins_with_brace(ended.out));
}

TEST_CASE("PicturesOverTimeHoldNumbersWhicheverWayTheJournalTurns") {
  const ScratchFolder scratch;
  const std::string picture = scratch.path("a.svg");
  const auto drawn = [&](const std::string& name, std::vector<std::string> words) {
    words.insert(words.begin(), {"run", case_path(name).string()});
    words.insert(words.end(), {"--set", "model.grid=[36,6]", "--picture", picture});
    const Ended ended = run_words(words);
    INFO(ended.err);
    CHECK(ended.code == 0);
    const std::string svg = read_text_file(picture);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    return svg;
  };
  for (const char* turn : {"2000 rpm", "-2000 rpm"}) {
    const std::string speed = std::string("operation.speed=") + turn;
    drawn("thd-plain-bearing", {"--transient", "--until", "100 s", "--set", speed});
    drawn("running-in", {"--running-in", "--set", "running_in.until=20 s", "--set", speed});
  }
  // A course of one stretch has one end: a dot, and the case that was asked for.
  const std::string course = drawn(
      "thd-plain-bearing",
      {"--transient", "--set", "operation.load=3.5 kN", "--speeds", "1500 rpm", "--hold", "10 s"});
  check_parts(course, {"<circle", "operation.load = 3.5 kN", "1 stretch;"});
}

TEST_CASE("WhereNoOilLeavesNoThermalRunawayIsForetold") {
  const std::vector<std::string> words{"check", case_path("raimondi-boyd").string(), "--set",
                                       "operation.eccentricity_ratio=0"};
  const Ended ended = run_words(words);
  CHECK(ended.code == 0);
  CHECK(ended.out.find("runaway is likely") == std::string::npos);
  CHECK(ended.out.find("inf") == std::string::npos);
}

TEST_CASE("OptionsAndKeysThatCannotActAreRefused") {
  const std::string plain = case_path("thd-plain-bearing").string();
  const std::string cycle = case_path("rotating-load").string();
  const std::vector<std::vector<std::string>> wrong{
      {"check", plain, "--tier", "estimate", "--set", "model.coefficients=true"},
      {"sweep", plain, "--tier", "estimate", "--set", "model.coefficients=true", "--vary",
       "operation.speed=1000 rpm,2000 rpm"},
      {"sweep", cycle, "--vary", "load_cycle.factor=1,0.9", "--bars"},
      {"run", plain, "--transient", "--speeds", "1000 rpm", "--hold", "1 s", "--set",
       "operation.speed=5000 rpm"},
      {"study", "--resume"},
      {"study", "--quick"}};
  for (const std::vector<std::string>& words : wrong) {
    const Ended ended = run_words(words);
    INFO(words[0] << " " << words[1] << " ... " << words.back() << ": " << ended.err);
    CHECK(ended.code == kBadInput);
    CHECK(ended.err.find("error: ") != std::string::npos);
  }
}

TEST_CASE("APlaceThatIsNotFoundIsNoLoad") {
  std::string text = read_text_file(case_path("ks-rig-test-bearing").string());
  const std::string load = "load = \"8 kN\"";
  text.replace(text.find(load), load.size(), "eccentricity_ratio = 2\nattitude_angle = \"20 deg\"");
  const ScratchFolder scratch;
  const Ended ended = run_words(
      {"run", scratch.write("c.toml", text), "--tier", "isothermal", "--set", "model.grid=[36,6]",
       "--set", "model.elastic_deformation=true", "--set", "model.asperity_contact=false"});
  CHECK(ended.code == kNotConverged);
  check_parts(ended.err, {"of the eccentricity and tilt given"});
  CHECK(ended.err.find("0 N of 0 N") == std::string::npos);
  CHECK(ended.err.find("a low load") == std::string::npos);
}

TEST_CASE("ASweepPrintsATableAndWritesItsFiles") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const std::vector<std::string> words{"sweep",     path,
                                       "--tier",    "isothermal",
                                       "--set",     kCoarse,
                                       "--vary",    "operation.speed=3000 rpm..1000 rpm/4log",
                                       "-o",        scratch.path("a.h5"),
                                       "--picture", scratch.path("a.svg"),
                                       "--csv",     scratch.path("a.csv"),
                                       "--json",    scratch.path("a.json")};
  const Ended ended = run_words(words);
  INFO(ended.err);
  CHECK(ended.code == kDone);
  check_parts(ended.out, {"4 points, 4 converged", "3000", "1000", "torque"});
  for (const char* name : {"a.h5", "a.svg", "a.csv", "a.json"}) {
    INFO(name);
    CHECK(std::filesystem::file_size(scratch.path(name)) > 500);
  }
}

TEST_CASE("ASweepTellsStiffnessAndDampingOfItsPoints") {
  // A rigid film of constant viscosity at a given eccentricity, fed at ambient pressure: its force
  // goes with the speed, so K does and C does not.
  const std::vector<std::string> words{"sweep",          case_path("raimondi-boyd").string(),
                                       "--coefficients", "--no-bars",
                                       "--set",          kCoarse,
                                       "--vary",         "operation.speed=1000 rpm,2000 rpm"};
  const Ended told = run_words(words);
  INFO(told.err);
  CHECK(told.code == kDone);
  check_parts(told.out, {"Kxx", "Cyy", "MN/m", "kN s/m", "critical mass"});
  std::vector<std::string> as_json = words;
  as_json.insert(as_json.end(), {"--json", "-"});
  const auto points = nlohmann::json::parse(run_words(as_json).out)["points"];
  const auto ratio = [&](const char* name) {
    const auto at = [&](int k) { return points[k]["quantities"][name]["value"].get<double>(); };
    return at(1) / at(0);
  };
  constexpr double kFilm = 1e-6;  // both films are solved to 1e-8 or better
  for (const char* name : {"K_xx", "K_xy", "K_yx", "K_yy"}) {
    CHECK(ratio(name) == Approx(2.0).epsilon(kFilm));
  }
  for (const char* name : {"C_xx", "C_xy", "C_yx", "C_yy"}) {
    CHECK(ratio(name) == Approx(1.0).epsilon(kFilm));
  }
}

TEST_CASE("ABadAxisEndsWithTwoAndAnExample") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const Ended ended = run_words({"sweep", path, "--vary", "operation.speed=fast..slow"});
  CHECK(ended.code == kBadInput);
  CHECK(ended.out.empty());
  check_parts(ended.err, {"--vary operation.speed", "\"fast\"", "for example"});
  CHECK(run_words({"sweep", path}).code == kBadInput);
}

TEST_CASE("ASweepToStandardOutputIsTheCsvAlone") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const Ended ended = run_words({"sweep", path, "--tier", "isothermal", "--set", kCoarse, "--vary",
                                 "operation.load=1 kN,2 kN", "--csv", "-"});
  CHECK(ended.code == kDone);
  CHECK(ended.out.starts_with("operation.load [kN],status,"));
  CHECK(std::count(ended.out.begin(), ended.out.end(), '\n') == 3);
}

TEST_CASE("TheEstimateIsSweptWithoutFilm") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const Ended ended = run_words(
      {"sweep", path, "--tier", "estimate", "--vary", "operation.load=1 kN,2 kN", "--csv", "-"});
  INFO(ended.err);
  CHECK(ended.code == kDone);
  check_parts(ended.out, {"converged,estimate"});
}

TEST_CASE("CoefficientsComeOnlyIfAskedFor") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const std::vector<std::string> plain{"run", path, "--tier", "isothermal", "--set", kCoarse};
  CHECK(run_words(plain).out.find("stiffness") == std::string::npos);
  auto asked = plain;
  asked.emplace_back("--coefficients-table");
  asked.push_back(scratch.path("k.csv"));
  const Ended ended = run_words(asked);
  INFO(ended.err);
  CHECK(ended.code == kDone);
  check_parts(ended.out, {"stiffness K_xx", "K c/W", "a rigid rotor"});
  CHECK(std::filesystem::file_size(scratch.path("k.csv")) > 0);
  asked.back() = scratch.path("no/folder/k.csv");
  CHECK(run_words(asked).code == kBadFile);
  auto other = plain;
  other.insert(other.end(), {"--coefficients", "--set", "model.methods.cavitation=swift-stieber"});
  const Ended refused = run_words(other);
  CHECK(refused.code == kBadInput);
  check_parts(refused.err, {"swift-stieber", "model.coefficients"});
  const Ended no_film = run_words({"run", path, "--tier", "estimate", "--coefficients"});
  CHECK(no_film.code == kBadInput);
  check_parts(no_film.err, {"need a solved film", "isothermal"});
}

TEST_CASE("RunNamesItsOperatingPointAndACommandThatIsTaken") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  const Ended ended = run_words({"run", path, "--tier", "isothermal", "--set", kCoarse, "--set",
                                 "operation.speed=1500 rpm", "--set", "model.tolerance=0.1 %"});
  CHECK(ended.code == kDone);
  check_parts(ended.out, {"1500 rpm, load 5 kN", "changed on the command line: model.grid",
                          "operation.speed = 1500 rpm", "model.tier = isothermal",
                          "model.tolerance (0.1 %) is not met", "shellback run " + path,
                          "--set operation.speed=\"1500 rpm\""});
}

TEST_CASE("ASweepShowsBarsAndWhatTheyLeaveOpen") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  // Loads that differ by a thousandth: no grid of 48 x 9 cells tells them apart.
  std::vector<std::string> words{"sweep",  path,
                                 "--tier", "isothermal",
                                 "--set",  kCoarse,
                                 "--vary", "operation.load=5 kN,5.005 kN",
                                 "--csv",  scratch.path("a.csv"),
                                 "--json", scratch.path("a.json"),
                                 "-j",     "1"};
  const Ended with = run_words(words);
  INFO(with.err);
  CHECK(with.code == kDone);
  check_parts(with.out, {"+-", "cannot be told apart",
                         "1 of 1 pairs of neighbours along "
                         "operation.load",
                         "model.tolerance (1 %) is not met", "shellback sweep " + path,
                         "--vary operation.load="});
  const auto text = [&](const char* name) {
    std::ifstream file(scratch.path(name));
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  check_parts(text("a.csv"), {"friction_torque error [N m]", "h_min error [m]"});
  check_parts(text("a.json"), {"\"indistinct\"", "\"error_grid\"", "\"case\""});
  words.emplace_back("--no-bars");
  const Ended without = run_words(words);
  CHECK(without.code == kDone);
  CHECK(without.out.find("+-") == std::string::npos);
  CHECK(text("a.csv").find("error [") == std::string::npos);
  CHECK(run_words({"sweep", path, "--bars", "--no-bars", "--vary", "operation.load=1,2 kN"}).code ==
        kBadInput);
}

TEST_CASE("CompareSaysWhatTheGridLeavesOpen") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", kSampleCase);
  // No heat to speak of: the tiers differ by less than so coarse a grid can tell.
  const Ended ended = run_words({"compare", path, "--tiers", "isothermal,lumped", "--set", kCoarse,
                                 "--set", "operation.speed=10 rpm", "--set",
                                 "oil.temperature=80 degC", "--set", "operation.load=20 N"});
  INFO(ended.err);
  CHECK(ended.code == kDone);
  check_parts(ended.out, {"cannot be told apart on this grid", "isothermal and lumped"});
}

TEST_CASE("WhatCannotTakeALoadCycleSaysSo") {
  const std::string file = case_path("pulse").string();
  const Ended ended = run_words({"run", file, "--coefficients"});
  CHECK(ended.code == kBadInput);
  CHECK(ended.out.empty());
  check_parts(ended.err, {"not yet available for load cycles"});
  CHECK(run_words({"check", file}).code == kDone);
}

TEST_CASE("TextsForUsersNameNoDocumentsOfOurs") {
  const std::filesystem::path root(SHELLBACK_SOURCE_DIR);
  const std::regex ours("(design|validation|methods|decision|seed|formulas) [0-9]");
  int read = 0;
  for (const char* folder : {"cases", "data", "validation"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".toml") continue;
      std::ifstream file(entry.path());
      const std::string text(std::istreambuf_iterator<char>(file), {});
      INFO(entry.path());
      std::smatch found;
      CHECK_FALSE(std::regex_search(text, found, ours));
      ++read;
    }
  }
  CHECK(read > 10);
}
