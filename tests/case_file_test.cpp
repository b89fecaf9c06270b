/// docs/case-file.md against the readers: every key that a case may have, and none that it may not.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/text_of_file.hpp"

using shellback::test::text_of_file;

namespace {

namespace fs = std::filesystem;
using Keys = std::set<std::string>;

Keys all_of(const std::string& text, const std::regex& pattern) {
  Keys found;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    found.insert((*it)[1]);
  }
  return found;
}

/// Keys that a reader allows: the texts in its lists `only({"a", "b"}, ...)`.
Keys allowed(const std::string& code) {
  static const std::regex list(R"(only\(\s*\{([^}]*)\})");
  static const std::regex key(R"rx("(\w+)")rx");
  Keys keys;
  for (const std::string& names : all_of(code, list)) keys.merge(all_of(names, key));
  return keys;
}

/// Words of the page that are marked as keys: between backticks, or before "=" in an example.
Keys shown(const std::string& page) {
  static const std::regex marked("`([^`]*)`");
  static const std::regex word(R"((\w+))");
  static const std::regex given(R"((\w+) = )");
  Keys keys = all_of(page, given);
  for (const std::string& text : all_of(page, marked)) keys.merge(all_of(text, word));
  return keys;
}

/// Keys in the first column of the page's tables.
Keys in_first_column(const std::string& page) {
  static const std::regex row(R"(\n\| (`[^|]*) \|)");
  static const std::regex key(R"(`(?:\w+\.)*(\w+)`)");
  Keys keys;
  for (const std::string& cell : all_of(page, row)) keys.merge(all_of(cell, key));
  return keys;
}

}  // namespace

TEST_CASE("EveryKeyOfACaseStandsOnItsPageAndNoneThatIsNotRead") {
  const fs::path root = SHELLBACK_SOURCE_DIR;
  const std::string page = text_of_file(root / "docs" / "case-file.md");
  Keys read;
  for (const auto& entry : fs::directory_iterator(root / "app" / "reading")) {
    const fs::path& file = entry.path();
    if (file.filename().string().rfind("read_", 0) != 0 || file.extension() != ".cpp") continue;
    read.merge(allowed(text_of_file(file)));
  }
  CHECK(read.size() > 100);  // the readers were found
  const Keys on_page = shown(page);
  for (const std::string& key : read) {
    INFO(key << " is not on docs/case-file.md");
    CHECK(on_page.count(key) == 1);
  }
  for (const std::string& key : in_first_column(page)) {
    INFO("docs/case-file.md has " << key << ", which no case has");
    CHECK(read.count(key) == 1);
  }
}

TEST_CASE("KeysAreSeenInCodeAndOnAPage") {
  CHECK(allowed("s.only({\"a\", \"b_c\"}, \"x\"); t->only(\n    {\"d\"},") ==
        Keys{"a", "b_c", "d"});
  CHECK(shown("| `a` or `b.c` | { d = 1 } | plain e |") == Keys{"a", "b", "c", "d"});
  CHECK(in_first_column("\n| `a`, `b.c` | `d` |\n") == Keys{"a", "c"});
}
