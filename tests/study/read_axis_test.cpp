/// --vary: what is understood, and what is said when it is not.
#include "app/reading/read_axis.hpp"

#include "app/reading/sweep_case.hpp"
#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;
using shellback::study::Spacing;

namespace {

void check_axis_refused(const std::string& words, const std::vector<std::string>& parts) {
  std::string what;
  try {
    static_cast<void>(parse_axis(words));
  } catch (const InputError& error) {
    what = error.what();
  }
  INFO(words);
  check_parts(what, parts);
}

}  // namespace

TEST_CASE("ARangeTakesItsUnitFromEitherEnd") {
  for (const char* words :
       {"operation.speed=3000 rpm..50 rpm/30log", "operation.speed=3000..50 rpm/30 log",
        "operation.speed = 3000 rpm .. 50 / 30log"}) {
    INFO(words);
    const auto axis = parse_axis(words);
    CHECK(axis.key == "operation.speed");
    CHECK(axis.unit == "rpm");
    CHECK(axis.size() == 30);
    CHECK(axis.spacing == Spacing::logarithmic);
    CHECK(axis.words.back() == "50 rpm");
  }
}

TEST_CASE("TheSlashOfAUnitIsNotThatOfACount") {
  const auto axis = parse_axis("shell.back.heat_transfer=100 W/(m2 K)..500 W/(m2 K)/5");
  CHECK(axis.unit == "W/(m2 K)");
  CHECK(axis.size() == 5);
  CHECK(axis.words[1] == "200 W/(m2 K)");
  const auto bare = parse_axis("k=1e-9 1/Pa..2e-9 1/Pa");
  CHECK(bare.unit == "1/Pa");
  CHECK(bare.size() == kUsualPoints);
  CHECK(parse_axis("k=1 1/\u00b5s..5 1/\u00b5s").unit == "1/\u00b5s");
}

TEST_CASE("PlainNumbersNeedNoUnit") {
  const auto axis = parse_axis("operation.eccentricity_ratio=0.1..0.9/9");
  CHECK(axis.unit.empty());
  CHECK(axis.words[4] == "0.5");
  CHECK(parse_axis("k=-1..1/3").numbers == std::vector<double>{-1.0, 0.0, 1.0});
}

TEST_CASE("ListsHoldNumbersOrWords") {
  const auto loads = parse_axis("operation.load=4, 8 kN");
  CHECK(loads.words == std::vector<std::string>{"4 kN", "8 kN"});
  CHECK(loads.numbers == std::vector<double>{4.0, 8.0});
  const auto grids = parse_axis("model.grid=[100,13],[200,25]");
  CHECK(grids.words == std::vector<std::string>{"[100,13]", "[200,25]"});
  CHECK(grids.numbers.empty());
  CHECK(parse_axis("model.tier=\"thd\",tehd").words == std::vector<std::string>{"thd", "tehd"});
}

TEST_CASE("FilesOfAFolderAboveAreNoRange") {
  const Axis files = parse_axis("bearing.shape=../s1.csv,../s2.csv");
  CHECK(files.words == std::vector<std::string>{"../s1.csv", "../s2.csv"});
  CHECK(parse_axis("title=\"a..b\",\"c\"").words.size() == 2);
  CHECK(parse_axis("operation.speed=100 rpm..200 rpm/3").numbers.size() == 3);
}

TEST_CASE("BadAxesAreRefusedWithPlaceAndCure") {
  check_axis_refused("operation.speed", {"--vary", "KEY=VALUES", "for example"});
  check_axis_refused("=4 kN", {"--vary", "for example"});
  check_axis_refused("operation.speed=", {"--vary operation.speed", "no values"});
  check_axis_refused("operation.speed=fast..50 rpm", {"\"fast\"", "number", "for example"});
  check_axis_refused("operation.speed=3000 rpm..", {"number", "for example"});
  check_axis_refused("k=1...5", {"number"});
  check_axis_refused("operation.speed=3000 rpm..50 Hz", {"\"rpm\"", "\"Hz\"", "same unit"});
  check_axis_refused("operation.speed=3000 rpm..50 rpm/1", {"at least 2"});
  for (const char* count : {"3.5", "-3", "3lin", "3log10"}) {
    check_axis_refused(std::string("operation.speed=3000 rpm..50 rpm/") + count,
                       {count, "whole number of points", "/30log"});
  }
  check_axis_refused("operation.speed=50 rpm..50 rpm/3", {"same"});
  check_axis_refused("operation.load=0 kN..8 kN/3log", {"positive", "leave out \"log\""});
  check_axis_refused("oil.temperature=50..100 degC/3log", {"degC", "leave out \"log\""});
  check_axis_refused("operation.load=4 kN,,8 kN", {"missing"});
  check_axis_refused("operation.load=4 kN,4 kN", {"\"4 kN\"", "twice"});
  check_axis_refused("k=1..2/99999999", {"so many"});
}

TEST_CASE("AKeyIsVariedOnceAndNotSetBesides") {
  const auto refused = [](const std::vector<std::string>& vary, const std::vector<Override>& set,
                          const std::vector<std::string>& parts) {
    std::string what;
    try {
      static_cast<void>(parse_axes(vary, set));
    } catch (const InputError& error) {
      what = error.what();
    }
    check_parts(what, parts);
  };
  const std::string load = "operation.load=4 kN,8 kN";
  refused({load, load}, {}, {"operation.load", "twice"});
  refused({load}, {parse_override("operation.load=3 kN")}, {"--set operation.load", "keep one"});
  refused({}, {}, {"nothing is varied"});
  refused({"a=0..1/9999", "b=0..1/9999"}, {}, {"too many"});
}

TEST_CASE("AWrongValueOfAnAxisIsRefusedWithItsPoint") {
  const auto axes =
      parse_axes({"operation.speed=1000 rpm,2000 rpm", "operation.load=4 kN..0 kN/3"}, {});
  const auto source = case_source(kSampleCase, "case.toml", {}, axes);
  CHECK(
      source({0.5, {1}}).operation.omega ==
      Approx(read_case_text(kSampleCase, "case.toml", {parse_override("operation.speed=1500 rpm")})
                 .operation.omega));
  try {
    static_cast<void>(source({1.0, {2}}));
    FAIL("0 kN was taken");
  } catch (const InputError& error) {
    check_parts(error.what(), {"--vary operation.load", "at operation.speed = 2000 rpm",
                               "operation.load = 0 kN", "positive"});
  }
}

TEST_CASE("ACommaOfDecimalsIsNoList") {
  // Swept were 1 kN and 5 kN.
  check_axis_refused("operation.load=1,5 kN", {"\"1\" beside \"5 kN\"", "one number", "point"});
  check_axis_refused("operation.speed=1,500 rpm,2,000 rpm", {"one number"});
  CHECK(parse_axis("operation.speed=1000,2000,3000 rpm").words.back() == "3000 rpm");
  CHECK(parse_axis("operation.speed=1000 rpm,2000,3000").words[1] == "2000 rpm");
}
