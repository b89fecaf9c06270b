/// The corpus of refusals (scripts/refusals): every key of the shipped cases with values that
/// cannot be. A refusal keeps its reason, its place and its cure.
#include <catch2/catch.hpp>
#include <fstream>

#include "app/reading/library.hpp"
#include "app/reading/overrides.hpp"
#include "app/reading/read_case.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

/// What is said of the case with the change, the file's path cut to its name.
std::string said_of(const std::string& name, const std::string& change) {
  const std::string path = case_path(name).string();
  try {
    static_cast<void>(read_case(path, {parse_override(change)}));
  } catch (const InputError& error) {
    std::string what = error.what();
    const std::size_t at = what.find(path);
    if (at != what.npos) what.replace(at, path.size(), name + ".toml");
    return what;
  }
  return "";
}

}  // namespace

TEST_CASE("EveryRefusalOfTheCorpusStays") {
  std::ifstream file(SHELLBACK_SOURCE_DIR "/tests/app/refusals.tsv");
  int count = 0;
  for (std::string line; std::getline(file, line); ++count) {
    const std::size_t first = line.find('\t');
    const std::size_t second = line.find('\t', first + 1);
    REQUIRE(second != line.npos);
    INFO("scripts/refusals writes the corpus anew; line " << count + 1);
    CHECK(said_of(line.substr(0, first), line.substr(first + 1, second - first - 1)) ==
          line.substr(second + 1));
  }
  CHECK(count > 250);
}
