/// The files of a run: none is lost that was there before, and one that fails takes no other along.
#include "app/program/outputs.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/reading/library.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/program/process.hpp"
#include "tests/program/run_words.hpp"
#include "tests/validation/ledger_scratch.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::program;
using namespace shellback::program::tests;

namespace {

namespace fs = std::filesystem;

const std::string kProfile = "phi [deg], z [mm], height [um]\n0, 0, 1\n180, 0, 2\n";

Words plus(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// That `words` with `file` as output are refused, by force or not, and the file stays.
void check_kept(const Words& words, const std::string& file) {
  const std::string before = text_of(file);
  for (const Words& force : {Words{}, Words{"--force"}}) {
    const Ended ended = run_words(plus(plus(words, {file}), force));
    INFO(words.front() << " " << words.back() << " " << file << ": " << ended.err);
    CHECK(ended.code == kBadInput);
    CHECK(ended.out.empty());
    check_parts(ended.err, {"error: " + words.back() + ": ", "never replaces an input"});
    CHECK(text_of(file) == before);
  }
}

/// A library of its own that the program takes for the shipped one while the object lives.
class ScratchLibrary {
 public:
  ScratchLibrary() {
    for (const char* part : {"cases", "data", "validation"}) {
      fs::copy(fs::path(SHELLBACK_SOURCE_DIR) / part, folder_.path(part),
               fs::copy_options::recursive);
    }
    setenv("SHELLBACK_HOME", folder_.path("").c_str(), 1);
  }
  ~ScratchLibrary() { unsetenv("SHELLBACK_HOME"); }
  ScratchLibrary(const ScratchLibrary&) = delete;
  ScratchLibrary& operator=(const ScratchLibrary&) = delete;
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

 private:
  ScratchFolder folder_;
};

}  // namespace

TEST_CASE("NoCommandReplacesTheCaseItReads") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", kSampleCase);
  const Words sweep{"sweep", file, "--vary", "operation.load=1 kN,2 kN"};
  for (const Words& words :
       {Words{"run", file, "-o"}, Words{"run", file, "--json"},
        Words{"run", file, "--coefficients-table"}, Words{"compare", file, "-o"},
        Words{"compare", file, "--json"}, Words{"compare", file, "--picture"}, plus(sweep, {"-o"}),
        plus(sweep, {"--csv"}), plus(sweep, {"--json"}), plus(sweep, {"--picture"}),
        Words{"chart", file, "-o"}, Words{"chart", file, "--png"}, Words{"chart", file, "--csv"}}) {
    check_kept(words, file);
  }
}

TEST_CASE("NorTheTablesThatTheCaseNames") {
  const ScratchFolder scratch;
  const std::string file = scratch.write(
      "case.toml", sample_with("radial_clearance", "profile = \"a.csv\"\nradial_clearance"));
  const std::string first = scratch.write("a.csv", kProfile);
  const std::string second = scratch.write("b.csv", kProfile);
  check_kept({"run", file, "--json"}, first);
  const Words sweep{"sweep", file, "--vary", "bearing.profile=a.csv,b.csv", "--csv"};
  check_kept(sweep, first);
  check_kept(sweep, second);
}

TEST_CASE("NorWhatComesWithTheProgram") {
  const ScratchLibrary library;
  const std::string scene = library.path("validation/stress/scenes.toml");
  REQUIRE(fs::exists(scene));
  check_kept({"stress", "--quick", "--table"}, scene);
  check_kept({"honesty", "--json"}, library.path("cases/raimondi-boyd.toml"));
  check_kept({"auto-honesty", "--json"}, library.path("data/materials.toml"));
  const std::string map = library.path("data/surfaces/generated-longitudinal.txt");
  check_kept({"surface", map, "--csv"}, map);
  check_kept({"surface", map, "--csv"}, library.path("data/tables/plain_bearing.csv"));
  check_kept({"run", library.path("cases/raimondi-boyd.toml"), "--json"},
             library.path("data/oils/") + shipped_oils().front() + ".toml");
}

TEST_CASE("NorTheLedgerThatIsRerun") {
  const validation::tests::ScratchLedger ledger;
  for (const char* option : {"-o", "--csv", "--json"}) {
    check_kept({"validate", "--ledger", ledger.path(), option},
               ledger.path() + "wide/expected.csv");
  }
}

TEST_CASE("AFileOfSomebodyElseIsReplacedOnlyByForce") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", kSampleCase);
  const std::string notes = scratch.write("notes.json", "{\"mine\": 1}\n");
  const Words words{"run", file, "--tier", "isothermal", "--set", kCoarse, "--json", notes};
  const Ended refused = run_words(words);
  CHECK(refused.code == kBadInput);
  CHECK(refused.out.empty());
  check_parts(refused.err, {"notes.json", "no result of shellback", "--force"});
  CHECK(text_of(notes) == "{\"mine\": 1}\n");
  CHECK(run_words(plus(words, {"--force"})).code == kDone);
  CHECK(text_of(notes).find("friction_torque") != std::string::npos);
}

TEST_CASE("OlderResultsAreReplaced") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", kSampleCase);
  const Words coarse{"--set", kCoarse};
  for (const Words& words :
       {Words{"run", file, "--tier", "isothermal", "-o", scratch.path("a.h5"), "--json",
              scratch.path("a.json"), "--coefficients-table", scratch.path("a.csv")},
        Words{"compare", file, "--tiers", "isothermal,lumped", "-o", scratch.path("b.html"),
              "--json", scratch.path("b.json"), "--picture", scratch.path("b.svg")},
        Words{"sweep", file, "--tier", "isothermal", "--vary", "operation.load=1 kN,2 kN", "-o",
              scratch.path("c.h5"), "--json", scratch.path("c.json"), "--picture",
              scratch.path("c.svg"), "--csv", scratch.path("c.csv")}}) {
    for (int time = 1; time <= 2; ++time) {
      const Ended ended = run_words(plus(words, coarse));
      INFO(words.front() << ", time " << time << ": " << ended.err);
      CHECK(ended.code == kDone);
    }
  }
}

TEST_CASE("OutputsAreJudgedTogetherBeforeTheWork") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", kSampleCase);
  const auto said_of = [&](const Words& words) {
    const Ended ended = run_words(plus({"run", file}, words));
    CHECK(ended.code == kBadInput);
    CHECK(ended.out.empty());
    return ended.err;
  };
  check_parts(said_of({"-o", scratch.path("x.json")}), {"-o: ", "HDF5", "name it ", "x.h5"});
  check_parts(said_of({"--json", scratch.path("x.h5")}), {"--json: ", "JSON", "x.json"});
  check_parts(said_of({"--json", scratch.path("x"), "-o", scratch.path("./x")}),
              {"--json: ", "written by -o already"});
  check_parts(said_of({"-o", "-"}), {"-o: ", "standard output"});
}

TEST_CASE("InitWritesACaseAndNothingElse") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("mine.toml", kSampleCase);
  CHECK(run_words({"init", "raimondi-boyd", "-o", file}).code == kBadFile);
  CHECK(text_of(file) == kSampleCase);
  CHECK(run_words({"init", "raimondi-boyd", "-o", scratch.path("x.h5")}).code == kBadInput);
  CHECK(run_words({"init", "raimondi-boyd", "-o", "-"}).code == kBadInput);
  CHECK(run_words({"init", "raimondi-boyd", "-o", scratch.path("no/x.toml")}).code == kBadFile);
  CHECK(run_words({"init", "raimondi-boyd", "-o", scratch.path("x.toml")}).code == kDone);
  CHECK(text_of(scratch.path("x.toml")) == text_of(case_path("raimondi-boyd").string()));
}

TEST_CASE("TheLedgersTableOnStandardOutputStandsAlone") {
  const validation::tests::ScratchLedger ledger;
  const Ended ended = run_words({"validate", "--ledger", ledger.path(), "--csv", "-"});
  CHECK(ended.code == kDone);
  CHECK(ended.out.starts_with("entry,evidence,"));
  CHECK(ended.out.find("entries within") == std::string::npos);
}

TEST_CASE("AFileThatFailsTakesNoOtherAlong") {
  const ScratchFolder scratch;
  fs::create_directory(scratch.path("gone"));
  Request request;
  request.command = Command::run;
  request.output = scratch.path("gone/x.h5");
  request.json = scratch.path("x.json");
  request.coefficients_table = scratch.path("x.csv");
  Outputs outputs(request, {});
  CHECK(outputs.code(kDone) == kDone);
  // Meanwhile a folder vanishes, and somebody writes a file of a wanted name.
  fs::remove_all(scratch.path("gone"));
  static_cast<void>(scratch.write("x.csv", "somebody's"));
  std::ostringstream said;
  auto* cerr = std::cerr.rdbuf(said.rdbuf());
  outputs.give("-o", [] { return std::string("fields"); });
  outputs.give("--coefficients-table", [] { return std::string("table"); });
  outputs.give("--json", [] { return std::string("{\"x\": 1}"); });
  std::cerr.rdbuf(cerr);
  check_parts(said.str(), {"error: cannot write", "gone/x.h5", "error: --coefficients-table",
                           "no result of shellback"});
  CHECK(outputs.code(kDone) == kBadFile);
  CHECK(text_of(scratch.path("x.csv")) == "somebody's");
  CHECK(text_of(scratch.path("x.json")).find("\"x\": 1") != std::string::npos);
}
