/// help keys: the page of docs for a terminal.
#include "app/key_reference.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "core/contract.hpp"
#include "tests/contains.hpp"

using namespace shellback;
using test::contains;

TEST_CASE("TheReferenceOfKeysIsThePageOfDocs") {
  std::ifstream file(std::string(SHELLBACK_SOURCE_DIR) + "/docs/case-file.md");
  std::ostringstream page;
  page << file.rdbuf();
  CHECK(page.str() == app::case_page());
}

TEST_CASE("EveryRowOfThePageIsTold") {
  const std::string all = app::key_reference(app::case_page(), {});
  std::istringstream page(app::case_page());
  int rows = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `")) continue;
    ++rows;
    const std::string key = line.substr(3, line.find('`', 3) - 3);
    INFO(key);
    CHECK(contains(all, "\n  " + key));
  }
  CHECK(rows > 60);  // the tables were found
  CHECK_FALSE(contains(all, "`"));
  CHECK_FALSE(contains(all, "|---"));
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() < 120);
}

TEST_CASE("ASectionIsToldAloneAndAnotherRefused") {
  const std::string page = app::case_page();
  for (const std::string& name : app::sections_of(page)) {
    CHECK_FALSE(app::key_reference(page, {name}).empty());
  }
  const std::string supply = app::key_reference(page, {"supply"});
  CHECK(contains(supply, "vessel_volume"));
  CHECK_FALSE(contains(supply, "wear_coefficient"));
  // The two that share a heading are told together.
  CHECK(app::key_reference(page, {"crank"}) == app::key_reference(page, {"load_cycle"}));
  CHECK_THROWS_WITH(app::key_reference(page, {"suply"}),
                    Catch::Contains("did you mean \"supply\"") && Catch::Contains("running_in"));
}

TEST_CASE("AKeyIsShownAsACaseGivesItWithItsDefault") {
  const std::string page =
      "intro\n\n## `[a]`\n\n| key | example | meaning | default |\n|---|---|---|---|\n"
      "| `x` | \"1 mm\" | of [it](it.md) | - |\n| `y`, `z` | 2 | both | 1 |\n\nend\n";
  CHECK(app::key_reference(page, {"a"}) ==
        "[a]\n\n  x = \"1 mm\"\n      of it; must be given\n  y, z for example 2\n"
        "      both (default: 1)\n\n  end\n");
}
