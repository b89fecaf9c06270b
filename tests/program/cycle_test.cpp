/// run on a case with a load cycle: what is refused, before anything is solved.
#include <catch2/catch.hpp>

#include "app/program/commands.hpp"
#include "app/read_case.hpp"
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

TEST_CASE("PicturesAndPagesAreOfWhatChangesInTime") {
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
  check_parts(said_of({"--picture", scratch.path("a.svg")}), {"--picture", "load cycle"});
  check_parts(said_of({"--page", scratch.path("a.html")}), {"--page", "load cycle"});
  check_parts(said_of({"--page", scratch.path("a.html"), "--transient"}), {"--page"});
  check_parts(said_of({"--until", "2 s"}), {"--until", "--transient"});
}
