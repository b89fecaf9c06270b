/// report, export and help: from a result file to a page and to ParaView.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/reading/library.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/contains.hpp"
#include "tests/program/process.hpp"
#include "tests/program/run_words.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::program;
using namespace shellback::program::tests;
using test::contains;

namespace {

namespace fs = std::filesystem;

/// A result file of the sample case, whose table of steps lies beside it no longer.
std::string result_in(const ScratchFolder& scratch) {
  scratch.write("a.csv", "phi [deg], z [mm], height [um]\n0, 0, 1\n180, 0, 1\n");
  const std::string file = scratch.write(
      "case.toml", sample_with("radial_clearance", "profile = \"a.csv\"\nradial_clearance"));
  const std::string result = scratch.path("a.h5");
  const Ended ended =
      run_words({"run", file, "--tier", "isothermal", "--set", kCoarse, "-o", result});
  INFO(ended.err);
  REQUIRE(ended.code == kDone);
  fs::remove(scratch.path("a.csv"));
  fs::remove(file);
  return result;
}

}  // namespace

TEST_CASE("AResultFileAloneMakesAPageAndAFilmForParaView") {
  const ScratchFolder scratch;
  const std::string result = result_in(scratch);
  const std::string page = scratch.path("a.html");
  CHECK(run_words({"report", result, "-o", page}).code == kDone);
  CHECK(contains(text_of(page), "data-quantity=\"friction_torque\""));
  CHECK(contains(text_of(page), "radial_clearance"));              // the case's text
  CHECK(run_words({"report", result, "-o", page}).code == kDone);  // an older page is replaced
  const std::string folder = scratch.path("film");
  CHECK(run_words({"export", result, "--vtu", folder}).code == kDone);
  CHECK(run_words({"export", result, "--vtu", folder}).code == kDone);
  CHECK(contains(text_of(folder + "/film.vtu"), "p [Pa]"));
}

TEST_CASE("AResultOfALoadCycleMovesOnItsPage") {
  const ScratchFolder scratch;
  const std::string result = scratch.path("a.h5"), page = scratch.path("a.html");
  const std::string file = read_text_file(std::string(SHELLBACK_SOURCE_DIR) + "/cases/pulse.toml");
  scratch.write("pulse-load.csv",
                read_text_file(std::string(SHELLBACK_SOURCE_DIR) + "/cases/pulse-load.csv"));
  const Ended ended = run_words({"run", scratch.write("case.toml", file), "--tier", "isothermal",
                                 "--set", kCoarse, "--set", "model.tolerance=10 %", "-o", result});
  INFO(ended.err);
  REQUIRE(ended.code == kDone);
  REQUIRE(run_words({"report", result, "-o", page}).code == kDone);
  const std::string html = text_of(page);
  CHECK(contains(html, "class=\"frame now\""));
  CHECK(contains(html, "Path of the journal"));
  // The circle is the clearance: the journal at the first instant is as far out as the file says.
  CHECK(contains(html, "largest pressure"));
}

TEST_CASE("ASteadyStateIsDrawnAndHasAPage") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", kSampleCase);
  const std::string picture = scratch.path("a.svg"), page = scratch.path("a.html");
  const Ended ended = run_words({"run", file, "--tier", "isothermal", "--set", kCoarse, "--picture",
                                 picture, "--page", page});
  CHECK(ended.code == kDone);
  CHECK(contains(text_of(picture), "<svg"));
  CHECK(contains(text_of(page), "data-quantity=\"friction_torque\""));
}

TEST_CASE("ASweepOverTheSpeedWritesATableForRotordynamics") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", kSampleCase);
  const std::string table = scratch.path("kc.csv");
  const std::vector<std::string> words{
      "sweep", file, "--tier",    "isothermal",           "--set", kCoarse,
      "-j",    "1",  "--no-bars", "--coefficients-table", table,   "--vary"};
  const auto with = [&](const std::string& axis) {
    std::vector<std::string> all = words;
    all.push_back(axis);
    return run_words(all);
  };
  const Ended ended = with("operation.speed=3000 rpm,1500 rpm");
  INFO(ended.err);
  CHECK(ended.code == kDone);
  const std::string text = text_of(table);
  CHECK(std::count(text.begin(), text.end(), '\n') == 3);
  check_parts(text, {"frequency,kxx", "\n157.0796327,", "\n314.1592654,"});
  check_parts(with("operation.load=1 kN,2 kN").err, {"--coefficients-table", "speed alone"});
}

TEST_CASE("ReportAndExportLeaveFilesOfOthersAlone") {
  const ScratchFolder scratch;
  const std::string result = result_in(scratch);
  const std::string own = scratch.write("mine.html", "<!DOCTYPE html>\nmine\n");
  CHECK(run_words({"report", result, "-o", own}).code == kBadInput);
  CHECK(text_of(own) == "<!DOCTYPE html>\nmine\n");
  check_parts(run_words({"report", result, "-o", result, "--force"}).err, {"never replaces"});
  check_parts(run_words({"report", result}).err, {"-o"});
  check_parts(run_words({"report", own, "-o", scratch.path("b.html")}).err,
              {"no result file", "-o FILE.h5"});
  CHECK(run_words({"report", scratch.path("nosuch.h5"), "-o", scratch.path("b.html")}).code ==
        kBadFile);
  fs::create_directory(scratch.path("film"));
  scratch.write("film/film.vtu", "mine");
  check_parts(run_words({"export", result, "--vtu", scratch.path("film")}).err,
              {"--vtu", "film.vtu", "no result of shellback"});
  CHECK(text_of(scratch.path("film/film.vtu")) == "mine");
  check_parts(run_words({"export", result, "--vtu", own}).err, {"--vtu", "is a file"});
  CHECK(run_words({"export", result, "--vtu", scratch.path("no/such")}).code == kBadFile);
}

TEST_CASE("HelpTellsTheKeysOfACase") {
  const Ended all = run_words({"help", "keys"});
  CHECK(all.code == kDone);
  check_parts(all.out, {"radial_clearance", "wear_coefficient"});
  const Ended one = run_words({"help", "keys", "oil"});
  CHECK(one.code == kDone);
  CHECK_FALSE(contains(one.out, "radial_clearance"));
  const Ended none = run_words({"help", "keys", "oli"});
  CHECK(none.code == kBadInput);
  check_parts(none.err, {"help keys", "did you mean \"oil\"?"});
  CHECK(run_words({"help"}).out == run_words({"--help"}).out);
  CHECK(run_words({"help", "sweep"}).out == run_words({"sweep", "--help"}).out);
  const Ended unknown = run_words({"help", "kyes"});
  CHECK(unknown.code == kBadInput);
  check_parts(unknown.err, {"no help on \"kyes\"", "did you mean \"keys\"?"});
}
