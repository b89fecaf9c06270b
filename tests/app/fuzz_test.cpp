/// The reader against mutilated cases: it takes them or refuses them, and does nothing else.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "app/check.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/library.hpp"
#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

/// Deterministic: the same corpus on every machine (the standard fixes this generator's digits).
using Random = std::minstd_rand;

std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

std::vector<std::string> corpus() {
  std::vector<std::string> texts{kSampleCase};
  for (const std::string& name : shipped_cases()) {
    texts.push_back(read_text_file(case_path(name).string()));
  }
  return texts;
}

/// Beside the shipped cases, so that their tables are found.
std::string beside_cases() { return (library_root() / "cases" / "fuzz.toml").string(); }

/// Reads; a case that is taken must hold numbers that can be computed with.
void expect_case_or_refusal(const std::string& text, const std::string& path = beside_cases(),
                            WholeCycle cycle = WholeCycle::left_out) {
  try {
    const auto c = read_case_text(text, path);
    const bool sane = std::isfinite(c.operation.omega) && c.bearing.radius > 0.0 &&
                      c.bearing.radial_clearance > 0.0 && !c.supplies.empty() &&
                      std::isfinite(c.supplies[0].pressure);
    if (!sane) {
      INFO(text);
      CHECK(sane);
    }
    std::ostringstream out;
    print_check(out, c, cycle);
  } catch (const InputError& error) {
    if (std::string(error.what()).empty()) {
      INFO(text);
      CHECK_FALSE(std::string(error.what()).empty());
    }
  } catch (const FileError&) {
    // A mutated key may have become bearing.profile with a name of no file, or a table's name.
  }
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Sanitized, a case takes ten times as long.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// The lines of the corpus that give a key a value, or begin a section if `headers` too, each key
/// of a section in the first two cases that have it: what a line does to the reader hangs on its
/// key, and the corpus says most of its keys a dozen times.
class ValueLines {
 public:
  explicit ValueLines(bool headers = false) : headers_(headers) {}

  /// Numbers of the lines of `lines`, the next case of the corpus, that are to be changed.
  std::vector<std::size_t> next(const std::vector<std::string>& lines) {
    std::set<std::string> here;
    std::vector<std::size_t> places;
    std::string section;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const bool header = lines[k].starts_with('[');
      if (header) section = lines[k];
      const std::size_t equal = lines[k].find('=');
      const bool says = header ? headers_ : equal != std::string::npos;
      if (!says || lines[k].starts_with('#')) continue;
      const std::string key = header ? section : section + lines[k].substr(0, equal);
      if (cases_with_[key] < 2) places.push_back(k);
      here.insert(key);
    }
    for (const std::string& key : here) ++cases_with_[key];
    return places;
  }

 private:
  bool headers_;
  std::map<std::string, int> cases_with_;
};

}  // namespace

TEST_CASE("FuzzTruncatedCases") {
  ValueLines places(true);
  for (const std::string& text : corpus()) {
    const auto lines = lines_of(text);
    for (const std::size_t k : places.next(lines)) {
      const std::string before =
          joined({lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(k)});
      const std::size_t apart = kSanitized ? 15 : 5;
      for (std::size_t end = k % apart; end < lines[k].size(); end += apart) {
        expect_case_or_refusal(before + lines[k].substr(0, end));
      }
    }
  }
  SUCCEED();
}

TEST_CASE("FuzzLinesDeletedDoubledAndSwapped") {
  ValueLines places(true);
  for (const std::string& text : corpus()) {
    const auto lines = lines_of(text);
    for (const std::size_t k : places.next(lines)) {
      auto without = lines;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
      expect_case_or_refusal(joined(without));
      auto twice = lines;
      twice.insert(twice.begin() + static_cast<std::ptrdiff_t>(k), lines[k]);
      expect_case_or_refusal(joined(twice));
      auto swapped = lines;
      std::swap(swapped[k], swapped[(k * 7 + 3) % lines.size()]);
      expect_case_or_refusal(joined(swapped));
    }
  }
  SUCCEED();
}

TEST_CASE("FuzzCharactersSwappedAndReplaced") {
  Random random(1);
  for (const std::string& text : corpus()) {
    for (int round = 0; round < (kSanitized ? 80 : 300); ++round) {
      std::string mutated = text;
      const std::size_t edits = 1 + below(random, 4);
      for (std::size_t e = 0; e < edits; ++e) {
        const std::size_t at = below(random, mutated.size() - 1);
        if (below(random, 2) == 0) {
          std::swap(mutated[at], mutated[at + 1]);
        } else {
          mutated[at] = static_cast<char>(below(random, 256));
        }
      }
      expect_case_or_refusal(mutated);
    }
  }
  SUCCEED();
}

TEST_CASE("FuzzTheTablesOfLoadCycles") {
  Random random(4);
  const ScratchFolder folder;
  for (const char* name : {"big-end", "flores-slider-crank", "rotating-load", "pulse"}) {
    const std::string text = read_text_file(case_path(name).string());
    const std::string source = tables_of_case(text, case_path(name).string()).front();
    const std::string table = read_text_file(source);
    const std::string target = std::filesystem::path(source).filename().string();
    const std::size_t header = table.find("\n", table.find("\n#\n") + 3);
    for (int round = 0; round < 500; ++round) {
      std::string mutated = table;
      const std::size_t edits = 1 + below(random, 3);
      for (std::size_t e = 0; e < edits; ++e) {
        const std::size_t at = header + below(random, mutated.size() - header - 1);
        const std::string some = "0123456789.,-e\n#[ ;nai";
        if (below(random, 3) == 0) {
          std::swap(mutated[at], mutated[at + 1]);
        } else {
          mutated[at] = some[below(random, some.size())];
        }
      }
      folder.write(target, mutated);
      const bool one_of_ten = round % 10 == 0;
      expect_case_or_refusal(text, folder.path("fuzz.toml"),
                             one_of_ten ? WholeCycle::estimated : WholeCycle::left_out);
    }
  }
  SUCCEED();
}

TEST_CASE("FuzzRandomBytes") {
  Random random(2);
  for (int round = 0; round < 2000; ++round) {
    std::string text(below(random, 300), ' ');
    for (char& c : text) c = static_cast<char>(below(random, 256));
    expect_case_or_refusal(text);
  }
  const std::string alphabet = "[]{}=\"'.,#\n\t aeE+-_0123456789:TZ\\";
  for (int round = 0; round < 5000; ++round) {
    std::string text(below(random, 120), ' ');
    for (char& c : text) c = alphabet[below(random, alphabet.size())];
    expect_case_or_refusal(text);
  }
  SUCCEED();
}

TEST_CASE("FuzzValuesReplacedByExtremes") {
  const std::vector<std::string> values{"0",
                                        "-0.0",
                                        "nan",
                                        "inf",
                                        "-inf",
                                        "1e308",
                                        "-1e308",
                                        "1e-320",
                                        "9223372036854775807",
                                        "-9223372036854775808",
                                        "true",
                                        "\"\"",
                                        "\" \"",
                                        "\"auto\"",
                                        "\"1e308 mm\"",
                                        "\"-1e308 K\"",
                                        "\"1e-320 um\"",
                                        "\"nan degC\"",
                                        "\"1e5 rpm\"",
                                        "\"5 m\"",
                                        "\"300 K\"",
                                        "\"0 deg\"",
                                        "\"0 1/Pa\"",
                                        "\"1e300 Pa\"",
                                        "[]",
                                        "{}",
                                        "[[]]",
                                        "[{}]",
                                        "[1, 2]",
                                        "[1.5, \"a\"]",
                                        "1979-05-27",
                                        "07:32:00",
                                        "{ law = \"none\" }",
                                        "{ law = \"constant\" }",
                                        "\"\\u0000\"",
                                        "\"\\U0001F600\"",
                                        "'''x'''"};
  ValueLines places;
  for (const std::string& text : corpus()) {
    const auto lines = lines_of(text);
    for (const std::size_t k : places.next(lines)) {
      for (const std::string& value : values) {
        auto changed = lines;
        changed[k] = lines[k].substr(0, lines[k].find('=') + 1) + " " + value;
        expect_case_or_refusal(joined(changed));
      }
    }
  }
  SUCCEED();
}

TEST_CASE("FuzzEveryQuotedValueReplacedInPlace") {
  const std::vector<std::string> values{"\"0 mm\"",   "\"-3 K\"",       "\"1e30 kg/m3\"",  "\"\"",
                                        "7",          "\"1e-30 Pa s\"", "\"1e9 W/(m K)\"", "{}",
                                        "\"90 degC\""};
  ValueLines places;
  for (const std::string& text : corpus()) {
    const auto lines = lines_of(text);
    for (const std::size_t k : places.next(lines)) {
      for (std::size_t at = lines[k].find('"'); at != std::string::npos;) {
        const std::size_t end = lines[k].find('"', at + 1);
        if (end == std::string::npos) break;
        for (const std::string& value : values) {
          auto changed = lines;
          changed[k].replace(at, end - at + 1, value);
          expect_case_or_refusal(joined(changed));
        }
        at = lines[k].find('"', end + 1);
      }
    }
  }
  SUCCEED();
}

TEST_CASE("FuzzNestedTablesAndLists") {
  for (const char* open : {"{a=", "[", "{\"a\".b=", "[{x="}) {
    for (const int depth : {1, 10, 100, 1000, 10'000}) {
      std::string value;
      for (int k = 0; k < depth; ++k) value += open;
      expect_case_or_refusal("a = " + value);
      expect_case_or_refusal(sample_with("\"50 mm\"", value));
    }
  }
  std::string headers;
  for (int k = 0; k < 2000; ++k) headers += "[a" + std::to_string(k) + "]\n";
  expect_case_or_refusal(headers);
  std::string supplies;
  for (int k = 0; k < 2000; ++k) supplies += "[[supply]]\n";
  expect_case_or_refusal(supplies);
  SUCCEED();
}

TEST_CASE("FuzzTheCommandLinesChanges") {
  Random random(3);
  const std::vector<std::string> keys{
      "bearing.diameter", "supply.0.pressure", "supply", "oil.viscosity",
      "model.grid",       "shell.layers.0",    "x.y.z",  "a.b.c.d.e.f.g",
      "supply.-1.z"};
  const std::string alphabet = "[]{}=\"'.,#\n\\ aeE+-_0123456789mrp";
  for (int round = 0; round < (kSanitized ? 800 : 3000); ++round) {
    std::string value(below(random, 20), ' ');
    for (char& c : value) c = alphabet[below(random, alphabet.size())];
    const std::string words = keys[below(random, keys.size())] + "=" + value;
    try {
      static_cast<void>(read_case_text(kSampleCase, "fuzz.toml", {parse_override(words)}));
    } catch (const InputError&) {
    }
  }
  SUCCEED();
}
