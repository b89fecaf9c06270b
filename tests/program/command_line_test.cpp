/// The command line: what is understood, and what is said when it is not.
#include "app/program/cli.hpp"
#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::program;

namespace {

void check_words(const std::vector<std::string>& words, const std::vector<std::string>& parts) {
  const Reading reading = read_command_line(words);
  CHECK(reading.code == kBadInput);
  check_parts(reading.words, parts);
}

}  // namespace

TEST_CASE("RunTakesItsOptions") {
  const Reading reading = read_command_line({"run", "--set", "operation.speed=1500 rpm",
                                             "case.toml", "--set=model.grid=[100,20]", "--tier",
                                             "thd", "--json", "-", "-o", "out.h5", "-j", "4"});
  INFO(reading.words);
  REQUIRE(reading.words.empty());
  const Request& r = reading.request;
  CHECK(r.command == Command::run);
  CHECK(r.case_file == "case.toml");
  CHECK(r.set == std::vector<std::string>{"operation.speed=1500 rpm", "model.grid=[100,20]"});
  CHECK(r.tier == "thd");
  CHECK(r.json == "-");
  CHECK(r.output == "out.h5");
  CHECK(r.threads == 4);
}

TEST_CASE("CompareTakesAListOfTiers") {
  const Reading reading = read_command_line({"compare", "--tiers", "isothermal, tehd", "case.toml",
                                             "--picture", "a.svg", "-o", "a.html"});
  INFO(reading.words);
  REQUIRE(reading.words.empty());
  CHECK(reading.request.tiers == std::vector<std::string>{"isothermal", "tehd"});
  CHECK(reading.request.case_file == "case.toml");
  CHECK(reading.request.picture == "a.svg");
}

TEST_CASE("AListWithAnEmptyPartIsRefused") {
  for (const char* speeds : {"1000 rpm,,2000 rpm", "1000 rpm,", ",1000 rpm", "1000 rpm, ", ""}) {
    check_words({"run", "case.toml", "--speeds", speeds}, {"--speeds", "empty"});
  }
  check_words({"compare", "case.toml", "--tiers", "thd,,tehd"}, {"--tiers", "empty"});
  check_words({"compare", "case.toml", "--tiers", "thd, ,tehd"}, {"--tiers", "empty"});
  check_words({"surface", "map.txt", "--gaps", "0.5,1,2,"}, {"--gaps", "empty"});
  check_words({"honesty", "--grids", "200x25,"}, {"--grids", "empty"});
  const Reading reading =
      read_command_line({"run", "case.toml", "--speeds", "1000 rpm,2000 rpm", "--speeds", "0 rpm"});
  CHECK(reading.request.speeds == std::vector<std::string>{"1000 rpm", "2000 rpm", "0 rpm"});
}

TEST_CASE("AnEmptyValueIsNotTakenForAnOptionThatIsLeftOut") {
  for (const char* option : {"--until", "--hold", "--json", "--tier", "--profile"}) {
    check_words({"run", "case.toml", option, ""}, {option, "empty", "leave it out"});
  }
  check_words({"run", ""}, {"CASE", "empty"});
}

TEST_CASE("SweepTakesItsAxesInTheirOrder") {
  const Reading reading =
      read_command_line({"sweep", "case.toml", "--vary", "operation.speed=3000 rpm..50 rpm/30log",
                         "--vary=operation.load=4 kN,8 kN", "-j", "2", "--csv", "-", "-o", "a.h5",
                         "--picture", "a.svg"});
  INFO(reading.words);
  REQUIRE(reading.words.empty());
  const Request& r = reading.request;
  CHECK(r.command == Command::sweep);
  CHECK(r.case_file == "case.toml");
  CHECK(r.vary == std::vector<std::string>{"operation.speed=3000 rpm..50 rpm/30log",
                                           "operation.load=4 kN,8 kN"});
  CHECK(r.cores == 2);
  CHECK(r.csv == "-");
  CHECK(r.output == "a.h5");
  CHECK(r.picture == "a.svg");
}

TEST_CASE("InitTakesANameOrNone") {
  CHECK(read_command_line({"init"}).request.command == Command::init);
  CHECK(read_command_line({"init", "raimondi-boyd"}).request.name == "raimondi-boyd");
}

TEST_CASE("AMisspeltCommandIsRefusedWithTheRightOne") {
  check_words({"chekc", "case.toml"}, {"no command \"chekc\"", "did you mean \"check\"?"});
  check_words({"frobnicate"}, {"no command", "init, check, run, compare"});
}

TEST_CASE("AMisspeltOptionIsRefusedWithTheRightOne") {
  check_words({"run", "case.toml", "--jsno", "x"}, {"no option \"--jsno\"", "\"--json\"?"});
  check_words({"run", "case.toml", "--tire=thd"}, {"no option \"--tire\"", "\"--tier\"?"});
  check_words({"compare", "case.toml", "--tier", "thd"}, {"no option", "\"--tiers\"?"});
}

TEST_CASE("MissingAndSurplusWordsAreNamed") {
  check_words({"run"}, {"case file is missing", "shellback run CASE.toml"});
  check_words({"check", "a.toml", "b.toml"}, {"one word too many", "b.toml"});
  check_words({"run", "case.toml", "-j", "0"}, {"-j"});
  check_words({"run", "case.toml", "--json"}, {"--json"});
  CHECK(read_command_line({}).code == kBadInput);
}

TEST_CASE("HelpAndVersionEndWell") {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--help"}, {"run", "--help"}, {"-h"}}) {
    const Reading reading = read_command_line(words);
    CHECK(reading.code == kDone);
    CHECK_FALSE(reading.words.empty());
  }
  const Reading version = read_command_line({"--version"});
  CHECK(version.code == kDone);
  CHECK(version.words.find("shellback ") == 0);
}
