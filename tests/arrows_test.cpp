// The arrows of the house: core <- rheology, fluid, thermal, solid <- bearing <- its folders film
// <- heat <- steady <- over_time <- judge <- fidelity <- app/study <- app/reading <- app/labels <-
// app/pictures <- app <- validation <- app/program; surface stands on fluid and solid, app/words on
// bearing/over_time, validation/rivals on bearing/film, beside them. A folder within a folder is
// one of its own if it is named here. Every include in the production folders is read; nobody
// includes tests.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/text_of_file.hpp"

using shellback::test::text_of_file;

namespace {

namespace fs = std::filesystem;
using Folders = std::set<std::string>;

/// Folders on which a folder stands, each with all on which that one does.
const std::map<std::string, Folders> kStandsOn{
    {"core", {}},
    {"rheology", {"core"}},
    {"fluid", {"core"}},
    {"thermal", {"core"}},
    {"solid", {"core"}},
    {"surface", {"fluid", "solid"}},
    {"bearing", {"rheology", "fluid", "thermal", "solid"}},
    {"bearing/film", {"bearing"}},
    {"bearing/heat", {"bearing/film"}},
    {"bearing/steady", {"bearing/heat"}},
    {"bearing/over_time", {"bearing/steady"}},
    {"bearing/judge", {"bearing/over_time"}},
    {"fidelity", {"bearing/judge"}},
    {"app/study", {"fidelity"}},
    {"app/words", {"bearing/over_time"}},
    {"app/reading", {"surface", "app/study"}},
    {"app/labels", {"app/reading", "app/words"}},
    {"app/pictures", {"app/labels"}},
    {"app", {"app/pictures"}},
    {"validation/rivals", {"bearing/film"}},
    {"validation", {"app", "validation/rivals"}},
    {"app/program", {"validation"}},
};

/// Folders that files of a folder may include, its own among them.
Folders arrows_of(const std::string& folder) {
  Folders all{folder};
  for (const std::string& below : kStandsOn.at(folder)) all.merge(arrows_of(below));
  return all;
}

/// The folder of the arrows in which a path from the root stands.
std::string folder_of(const std::string& path) {
  const std::size_t first = path.find('/');
  const std::string two = path.substr(0, path.find('/', first + 1));
  return kStandsOn.count(two) > 0 ? two : path.substr(0, first);
}

/// Paths in the #include "..." lines of a text.
std::vector<std::string> included(const std::string& text) {
  std::vector<std::string> paths;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    line.erase(
        std::remove_if(line.begin(), line.end(), [](char c) { return c == ' ' || c == '\t'; }),
        line.end());
    const std::string key = "#include\"";
    if (line.rfind(key, 0) != 0) continue;
    paths.push_back(line.substr(key.size(), line.find('"', key.size()) - key.size()));
  }
  return paths;
}

/// Includes of `text`, a file of `folder`, that go against the arrows or do not start at the root.
std::vector<std::string> wrong_includes(const std::string& folder, const std::string& text) {
  std::vector<std::string> wrong;
  const Folders allowed = arrows_of(folder);
  for (const std::string& path : included(text)) {
    const std::string target = folder_of(path);
    const bool rooted = path.find('/') != std::string::npos && path.find("..") == std::string::npos;
    if (!rooted || allowed.count(target) == 0) wrong.push_back(path);
  }
  return wrong;
}

bool is_source(const fs::path& path) {
  const std::string e = path.extension().string();
  return e == ".hpp" || e == ".cpp" || e == ".h" || e == ".inl";
}

}  // namespace

TEST_CASE("EveryIncludeFollowsTheArrows") {
  const fs::path root = SHELLBACK_SOURCE_DIR;
  int files = 0;
  for (const auto& [folder, below] : kStandsOn) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file() || !is_source(entry.path())) continue;
      if (folder_of(fs::relative(entry.path(), root).string()) != folder) continue;
      ++files;
      for (const std::string& path : wrong_includes(folder, text_of_file(entry.path()))) {
        FAIL_CHECK(fs::relative(entry.path(), root).string() << " must not include " << path);
      }
    }
  }
  CHECK(files > 100);  // the folders were found: a small part of what stands in them
}

TEST_CASE("ThePlantedWrongIncludeIsFound") {
  const auto wrong = [](const char* folder, const char* line) {
    return wrong_includes(folder,
                          std::string("#pragma once\n#include <vector>\n") + line + "\nint x;\n")
        .size();
  };
  CHECK(wrong("core", "#include \"core/grid.hpp\"") == 0);
  CHECK(wrong("core", "#include \"fluid/gap.hpp\"") == 1);
  CHECK(wrong("fluid", "#include \"core/grid.hpp\"") == 0);
  CHECK(wrong("fluid", "  #  include   \"rheology/oil.hpp\"  // why") == 1);
  CHECK(wrong("thermal", "#include \"bearing/tehd.hpp\"") == 1);
  CHECK(wrong("solid", "#include \"thermal/film_energy.hpp\"") == 1);
  CHECK(wrong("bearing", "#include \"fluid/gap.hpp\"\n#include \"app/case.hpp\"") == 1);
  CHECK(wrong("bearing", "#include \"tests/read_csv.hpp\"") == 1);
  CHECK(wrong("app", "#include \"bearing/tehd.hpp\"\n#include \"core/grid.hpp\"") == 0);
  CHECK(wrong("app", "#include \"validation/run.hpp\"") == 1);
  CHECK(wrong("app", "#include \"app/study/sweep.hpp\"") == 0);
  CHECK(wrong("app/study", "#include \"app/case.hpp\"") == 1);
  CHECK(wrong("bearing", "#include \"app/words/ending_words.hpp\"") == 1);
  CHECK(wrong("validation", "#include \"app/program/case.hpp\"") == 1);
  CHECK(wrong("fluid", "#include \"gap.hpp\"") == 1);  // not from the root
  CHECK(wrong("fluid", "#include \"fluid/../app/case.hpp\"") == 1);
  CHECK(wrong("fluid", "// #include \"app/case.hpp\"") == 0);  // a comment
}

TEST_CASE("LinkedLibrariesFollowTheArrows") {
  // target_link_libraries is the arrow: no folder's CMakeLists names a library above it.
  const fs::path root = SHELLBACK_SOURCE_DIR;
  for (const auto& [folder, below] : kStandsOn) {
    if (!fs::exists(root / folder)) continue;
    const std::string text = text_of_file(root / folder / "CMakeLists.txt");
    REQUIRE_FALSE(text.empty());
    const Folders allowed = arrows_of(folder);
    for (const auto& [other, unused] : kStandsOn) {
      if (allowed.count(other) > 0) continue;
      INFO(folder << " links " << other);
      const std::string library = other.substr(other.rfind('/') + 1);
      CHECK(text.find("shellback::" + library + " ") == std::string::npos);
      CHECK(text.find("shellback::" + library + ")") == std::string::npos);
    }
  }
}
