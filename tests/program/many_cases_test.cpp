/// study plan, run, status, merge: many cases in a folder.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

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

struct Study {
  ScratchFolder scratch;
  std::string file = scratch.write("case.toml", kSampleCase);
  std::string folder = scratch.path("study");

  /// As a process of its own: points are runs of the program that they are started by.
  int run(Words words) {
    const Process process(words, scratch.path("out.txt"), scratch.path("err.txt"));
    return process.wait();
  }
  [[nodiscard]] Ended plan(const std::string& loads) const {
    return run_words({"study", "plan", file, "--vary", "operation.load=" + loads, "--tier",
                      "isothermal", "--set", kCoarse, "-o", folder});
  }
  [[nodiscard]] std::string point(const std::string& name) const {
    return folder + "/points/" + name;
  }
};

}  // namespace

TEST_CASE("AStudyOfManyCasesIsWhatItsPointsAre", "[study]") {
  Study study;
  REQUIRE(study.plan("1 kN,2 kN").code == kDone);
  CHECK(study.run({"study", "run", study.folder, "--part", "1/2"}) == kDone);
  CHECK(contains(run_words({"study", "status", study.folder}).out, "1 converged, 1 open"));
  CHECK(run_words({"study", "merge", study.folder, "--csv", "-"}).code == kNotConverged);
  const auto first = fs::last_write_time(study.point("0001.json"));
  CHECK(study.run({"study", "run", study.folder, "-j", "2"}) == kDone);
  CHECK(fs::last_write_time(study.point("0001.json")) == first);  // what has ended stays
  const Ended merged = run_words({"study", "merge", study.folder, "--json", "-"});
  CHECK(merged.code == kDone);
  const auto all = nlohmann::json::parse(merged.out);
  REQUIRE(all["points"].size() == 2);
  for (const auto& point : all["points"]) {  // the same as a run on its own
    const std::string load = point["varied"]["operation.load"];
    const Ended alone = run_words({"run", study.file, "--tier", "isothermal", "--set", kCoarse,
                                   "--set", "operation.load=" + load, "--json", "-"});
    CHECK(nlohmann::json::parse(alone.out)["quantities"] == point["quantities"]);
  }
}

TEST_CASE("PointsThatAreNotFoundAreToldAndNotMerged", "[study]") {
  Study study;
  REQUIRE(study.plan("1 kN,900 kN").code == kDone);
  CHECK(study.run({"study", "run", study.folder}) == kNotConverged);
  CHECK(contains(run_words({"study", "status", study.folder}).out, "not converged: isothermal"));
  const Ended merged = run_words({"study", "merge", study.folder, "--csv", "-"});
  CHECK(merged.code == kNotConverged);
  std::istringstream lines(merged.out);
  std::string head, good, lost;
  std::getline(lines, head);
  std::getline(lines, good);
  std::getline(lines, lost);
  CHECK(contains(head, "friction_torque [N m],friction_torque_bar [N m]"));
  CHECK(contains(lost, "900 kN,not converged,,"));
  CHECK_FALSE(contains(good, ",,,,"));
}

TEST_CASE("StudiesThatCannotBeAreRefused", "[study]") {
  Study study;
  const auto refused = [&](const Words& words, const std::string& part) {
    const Ended ended = run_words(words);
    INFO(ended.err);
    CHECK(contains(ended.err, part));
    return ended.code;
  };
  CHECK(study.plan("1 kN,-2 kN").code == kBadInput);  // no such case
  CHECK_FALSE(fs::exists(study.folder));
  REQUIRE(study.plan("1 kN,2 kN").code == kDone);
  CHECK(study.plan("1 kN,2 kN").code == kBadInput);  // one is there
  CHECK(refused({"study", "run", study.folder, "--part", "3/2"}, "write I/N") == kBadInput);
  CHECK(refused({"study", "run", study.folder, "--csv", "a.csv"}, "study run") == kBadInput);
  CHECK(refused({"study", "run", study.scratch.path("no")}, "study plan") == kBadFile);
  CHECK(refused({"study", "merge", study.folder}, "--csv FILE") == kBadInput);
  CHECK(refused({"study", "ks-rig", "--vary", "a=1,2"}, "many cases") == kBadInput);
  study.scratch.write("case.toml", std::string(kSampleCase) + "\n# another\n");
  CHECK(refused({"study", "run", study.folder}, "has changed") == kBadInput);
}

TEST_CASE("ATableThatHasChangedSinceItsStudyIsTold", "[study]") {
  const Study study;
  const std::string rows =
      "phi [deg], z [mm], height [um]\n0, -10, 0\n0, 10, 0\n180, -10, 0\n180, 10, ";
  study.scratch.write("shape.csv", rows + "3\n");
  REQUIRE(run_words({"study", "plan", study.file, "--set", "bearing.profile=shape.csv", "-o",
                     study.folder})
              .code == kDone);
  study.scratch.write("shape.csv", rows + "4\n");
  const Ended ended = run_words({"study", "run", study.folder});
  CHECK(ended.code == kBadInput);
  CHECK(contains(ended.err, "shape.csv"));
  CHECK(contains(ended.err, "has changed"));
}

TEST_CASE("APointWhoseResultHasBeenLostIsOpen", "[study]") {
  Study study;
  REQUIRE(study.plan("1 kN,2 kN").code == kDone);
  CHECK(study.run({"study", "run", study.folder}) == kDone);
  fs::remove(study.point("0002.json"));
  CHECK(contains(run_words({"study", "status", study.folder}).out, "1 converged, 1 open"));
  CHECK(study.run({"study", "run", study.folder}) == kDone);
  CHECK(fs::exists(study.point("0002.json")));
  CHECK(contains(run_words({"study", "status", study.folder}).out, "2 converged"));
}
