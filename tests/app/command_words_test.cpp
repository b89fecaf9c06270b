/// Command lines that are named to a user can be typed.
#include "app/labels/command_words.hpp"

#include <cstdio>

#include "app/reading/read_axis.hpp"
#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

/// The words that a shell makes of a line.
std::vector<std::string> shell_words(const std::string& line) {
  FILE* pipe = popen(("printf '%s\\n' " + line).c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::vector<std::string> words(1);
  for (int c = fgetc(pipe); c != EOF; c = fgetc(pipe)) {
    if (c == '\n') {
      words.emplace_back();
    } else {
      words.back() += static_cast<char>(c);
    }
  }
  pclose(pipe);
  words.pop_back();
  return words;
}

}  // namespace

TEST_CASE("AShellGivesBackTheWordsThatWereQuoted") {
  for (const std::string word : {"case.toml", "operation.speed=1500 rpm", "a \"b\" c", "it's", "",
                                 "[200,25]", "$HOME `x` \\", "name with blanks.toml"}) {
    INFO(word);
    CHECK(shell_words(shell_word(word)) == std::vector<std::string>{word});
  }
}

TEST_CASE("ACommandLineRepeatsTheChangesButThoseReplaced") {
  const auto c = read_case_text(kSampleCase, "my case.toml",
                                {parse_override("operation.speed=1500 rpm"),
                                 parse_override("model.grid=[48, 9]"),
                                 {"model.tier", "\"thd\"", "--tier"}});
  const std::string line =
      command_line("run", c, set_words("model.grid", "[96,18]"), {"model.grid"});
  CHECK(shell_words(line) == std::vector<std::string>{"shellback", "run", "my case.toml", "--set",
                                                      "operation.speed=1500 rpm", "--tier", "thd",
                                                      "--set", "model.grid=[96,18]"});
  CHECK(describe_changes(c) ==
        "changed on the command line: operation.speed = 1500 rpm, model.grid = [48, 9], "
        "model.tier = thd");
}

TEST_CASE("AnAxisIsReadBackFromItsWords") {
  for (const std::string given : {"operation.speed=3000 rpm..50 rpm/30log", "operation.load=4 kN,8 kN",
                                  "model.grid=[100,13],[200,25]", "model.tier=thd,tehd"}) {
    const auto axis = parse_axis(given);
    const auto words = shell_words(vary_words(axis));
    REQUIRE(words.size() == 2);
    CHECK(words[0] == "--vary");
    CHECK(parse_axis(words[1]).words == axis.words);
  }
}

TEST_CASE("WordsThatBeginWithDigitsStayWords") {
  using Words = std::vector<std::string>;
  CHECK(parse_axis("load_cycle.file=1500rpm.csv,3000rpm.csv").words ==
        Words{"1500rpm.csv", "3000rpm.csv"});
  CHECK(parse_axis("oil.name=0W20,0W-8").words == Words{"0W20", "0W-8"});
  CHECK(parse_axis("oil.name=0W-8").words == Words{"0W-8"});
  CHECK(parse_axis("supply.0.arc=280deg,300deg").unit == "deg");
}

TEST_CASE("AProposedRunAsksForTheCoefficientsWithoutTheirTable") {
  auto c = read_case_text(kSampleCase, "a.toml", {});
  c.changes = {{"model.coefficients", "true", "--coefficients-table"}};
  CHECK(command_line("run", c, "", {}) == "shellback run a.toml --coefficients");
}
