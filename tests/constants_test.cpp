// docs/constants.md names every named constant of core/, bearing/ and fidelity/ with its file, and
// none that is gone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/text_of_file.hpp"

using shellback::test::text_of_file;

namespace {

namespace fs = std::filesystem;
using Named = std::set<std::pair<std::string, std::string>>;  ///< constant, file

/// Constants that a text declares: kName behind const or constexpr and a type, with a value.
std::vector<std::string> declared(const std::string& text) {
  static const std::regex pattern(
      R"(\bconst(?:expr)?\s+[\w:]+(?:<[^;={}]*>)?\s+(k[A-Z]\w*)\s*(?:\[\w*\])?\s*[={])");
  std::vector<std::string> names;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    names.push_back((*it)[1]);
  }
  return names;
}

Named declared_in(const fs::path& folder) {
  Named all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string kind = entry.path().extension().string();
    if (kind != ".hpp" && kind != ".cpp") continue;
    for (const std::string& name : declared(text_of_file(entry.path()))) {
      all.emplace(name, entry.path().filename().string());
    }
  }
  return all;
}

/// Cells of a row of a table, without the blanks around them; none: the line is no row.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  if (line.rfind("| ", 0) != 0) return cells;
  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t from = cell.find_first_not_of(' ');
    cells.push_back(
        from == std::string::npos ? "" : cell.substr(from, cell.find_last_not_of(' ') + 1 - from));
  }
  return cells;
}

/// Constants with their files in the tables of a section; a row may name several of one file.
Named listed_in(const std::string& page, const std::string& section) {
  Named all;
  std::istringstream stream(page);
  bool inside = false;
  std::size_t where = 0;  // column
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("## ", 0) == 0) inside = line == "## " + section;
    const std::vector<std::string> cells = cells_of(line);
    if (!inside || cells.empty()) continue;
    if (cells[0] == "constant") {
      where = std::find(cells.begin(), cells.end(), "where") - cells.begin();
      REQUIRE(where < cells.size());
      continue;
    }
    std::istringstream names(cells[0]);
    for (std::string name; std::getline(names >> std::ws, name, ',');) {
      all.emplace(name.substr(name.rfind(':') + 1), cells.at(where));
    }
  }
  return all;
}

}  // namespace

TEST_CASE("EveryNamedConstantStandsInItsTableAndNoneThatIsGone") {
  const fs::path root = SHELLBACK_SOURCE_DIR;
  const std::string page = text_of_file(root / "docs" / "constants.md");
  for (const std::string folder : {"core", "bearing", "fidelity"}) {
    const Named there = declared_in(root / folder);
    const Named listed = listed_in(page, folder);
    CHECK(there.size() > 10);  // the folder was found
    for (const auto& [name, file] : there) {
      INFO(folder << "/" << file << ": " << name << " has no row in docs/constants.md");
      CHECK(listed.count({name, file}) == 1);
    }
    for (const auto& [name, file] : listed) {
      INFO("docs/constants.md: " << name << " is not in " << folder << "/" << file);
      CHECK(there.count({name, file}) == 1);
    }
  }
}

TEST_CASE("ConstantsAreSeenHoweverTheyAreDeclared") {
  const auto seen = [](const char* text) { return declared(text).size(); };
  CHECK(seen("constexpr double kOne = 1.0;") == 1);
  CHECK(seen("  constexpr int kTwo{2};") == 1);
  CHECK(seen("inline constexpr Grid kGrid{3, 4};\nconstexpr std::array<int, 2> kList{1, 2};") == 2);
  CHECK(seen("const std::vector<Grid> kGrids{{1, 2}};") == 1);
  CHECK(seen("constexpr double kLater =\n    2.0;") == 1);
  CHECK(seen("  static constexpr double kOfType = 7.54;") == 1);
  CHECK(seen("x = kOne * y; if (z == kTwo) {}") == 0);
  const std::string page =
      "## other\n| constant | where |\n|---|---|\n| kGone | a.cpp |\n"
      "## bearing\n| constant | value | where |\n|---|---|---|\n"
      "| T::kOne, kTwo | 1, 2 | a.cpp |\n";
  CHECK(listed_in(page, "bearing") == Named{{"kOne", "a.cpp"}, {"kTwo", "a.cpp"}});
}
