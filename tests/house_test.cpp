// Rules of the house that a reader of the sources can hold: no files of one folder include each
// other in a ring, no function is longer than 60 lines, and paths that are named exist.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/text_of_file.hpp"

using shellback::test::text_of_file;

namespace {

namespace fs = std::filesystem;
using Texts = std::map<std::string, std::string>;  ///< by path from the root

/// Sources of a folder and of those within it.
Texts sources_in(const fs::path& root, const std::string& folder) {
  Texts texts;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string kind = entry.path().extension().string();
    if (kind != ".hpp" && kind != ".cpp") continue;
    texts[fs::relative(entry.path(), root).string()] = text_of_file(entry.path());
  }
  return texts;
}

/// A header and its source are one unit.
std::string unit_of(const std::string& path) { return path.substr(0, path.rfind('.')); }
std::string beside(const std::string& path) { return path.substr(0, path.rfind('/')); }

/// Units of the same folder that the units include.
std::map<std::string, std::set<std::string>> neighbours(const Texts& texts) {
  std::map<std::string, std::set<std::string>> out;
  for (const auto& [path, text] : texts) {
    std::istringstream stream(text);
    const std::string key = "#include \"";
    for (std::string line; std::getline(stream, line);) {
      if (line.rfind(key, 0) != 0) continue;
      const std::string other =
          unit_of(line.substr(key.size(), line.find('"', key.size()) - key.size()));
      if (other != unit_of(path) && beside(other) == beside(path)) {
        out[unit_of(path)].insert(other);
      }
    }
  }
  return out;
}

/// Units from which includes lead back to themselves.
std::set<std::string> knotted(const Texts& texts) {
  const auto next = neighbours(texts);
  std::set<std::string> knots;
  for (const auto& [begin, unused] : next) {
    std::set<std::string> seen;
    std::vector<std::string> open{begin};
    while (!open.empty()) {
      const std::string unit = open.back();
      open.pop_back();
      const auto found = next.find(unit);
      if (found == next.end()) continue;
      for (const std::string& other : found->second) {
        if (other == begin) knots.insert(begin);
        if (seen.insert(other).second) open.push_back(other);
      }
    }
  }
  return knots;
}

/// First lines of the functions of more than `most` lines. In formatted sources a definition begins
/// in the first column and ends with a brace there.
std::vector<std::string> long_functions(const std::string& text, int most) {
  std::vector<std::string> out;
  std::istringstream stream(text);
  std::string begin;  // of the definition that is read; empty: none
  int length = 0;
  bool open = false;      // its brace was read
  bool function = false;  // and a parenthesis before it
  for (std::string line; std::getline(stream, line);) {
    ++length;
    if (line == "}" || line == "};") {
      if (function && open && length - 1 > most) out.push_back(begin);
      begin.clear();
    } else if (begin.empty() && !line.empty() && line[0] != ' ' &&
               std::string("})#/").find(line[0]) == std::string::npos) {
      begin = line;
      length = 1;
      open = function = false;
    }
    if (!open && line.find('(') != std::string::npos) function = true;
    if (line.ends_with("{")) open = true;
    const bool ended = line.ends_with(";") || line.empty() || line.rfind("namespace", 0) == 0;
    if (ended && (!open || line.rfind("namespace", 0) == 0)) begin.clear();
  }
  return out;
}

const auto kFolders = {"core",    "rheology", "fluid",    "thermal", "solid",
                       "surface", "bearing",  "fidelity", "app",     "validation"};
constexpr int kMostLines = 60;

}  // namespace

TEST_CASE("NoFilesOfAFolderIncludeEachOtherInARing") {
  for (const char* folder : kFolders) {
    const Texts texts = sources_in(SHELLBACK_SOURCE_DIR, folder);
    CHECK(texts.size() > 5);  // the folder was found
    for (const std::string& unit : knotted(texts)) FAIL_CHECK(unit << " includes itself on a way");
  }
}

TEST_CASE("NoFunctionIsLongerThanItsReaderCanHold") {
  for (const char* folder : kFolders) {
    for (const auto& [path, text] : sources_in(SHELLBACK_SOURCE_DIR, folder)) {
      for (const std::string& begin : long_functions(text, kMostLines)) {
        FAIL_CHECK(path << ": " << begin);
      }
    }
  }
}

TEST_CASE("PathsThatCommentsAndPagesNameExist") {
  static const std::regex path(
      R"((^|[^\w/.])((core|rheology|fluid|thermal|solid|surface|bearing|fidelity|app|validation)/[a-z0-9_/]+\.(hpp|cpp)))");
  const fs::path root = SHELLBACK_SOURCE_DIR;
  const auto check = [&](const std::string& of, const std::string& text) {
    for (std::sregex_iterator m(text.begin(), text.end(), path), end; m != end; ++m) {
      const std::string named = (*m)[2];
      if (named == "app/provenance_stamp.hpp") continue;  // made by the build
      if (!fs::exists(root / named)) FAIL_CHECK(of << " names " << named << ", which is not there");
    }
  };
  for (const char* folder : kFolders) {
    for (const auto& [of, text] : sources_in(root, folder)) check(of, text);
  }
  int pages = 0;
  for (const auto& entry : fs::directory_iterator(root / "docs")) {  // decisions tell of their day
    if (entry.path().extension() != ".md") continue;
    check(entry.path().filename().string(), text_of_file(entry.path()));
    ++pages;
  }
  check("README.md", text_of_file(root / "README.md"));
  CHECK(pages > 20);
}

TEST_CASE("APlantedRingIsFound") {
  const Texts chain{{"fluid/a.cpp", "#include \"fluid/a.hpp\"\n#include \"fluid/b.hpp\"\n"},
                    {"fluid/b.cpp", "#include \"fluid/b.hpp\"\n#include \"core/a.hpp\"\n"},
                    {"fluid/c.hpp", "#include \"fluid/a.hpp\"\n"}};
  CHECK(knotted(chain).empty());
  Texts ring = chain;
  ring["fluid/b.hpp"] = "#include \"fluid/c.hpp\"\n";  // by header and source of one unit
  CHECK(knotted(ring) == std::set<std::string>{"fluid/a", "fluid/b", "fluid/c"});
}

TEST_CASE("APlantedLongFunctionIsFound") {
  const auto function = [](int lines) {
    std::string text =
        "constexpr int k =\n    3;\n\nnamespace {\nusing X = int;\ntemplate <class T>\ndouble "
        "f(int x,\n";
    text += "         int y) {\n";
    for (int k = 0; k < lines - 4; ++k) text += k % 7 == 0 ? "\n" : "  x += y;\n";
    return text + "}\n\n}  // namespace\n\nstruct S {\n" + std::string(200, '\n') + "};\n";
  };
  // As many lines as from its first to the one before its closing brace.
  CHECK(long_functions(function(kMostLines + 1), kMostLines).empty());
  CHECK(long_functions(function(kMostLines + 2), kMostLines) ==
        std::vector<std::string>{"template <class T>"});
}
