/// Files that are no case: missing, empty, binary, huge, broken TOML.
#include "app/reading/case_text.hpp"

#include "tests/app/sample_case.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

/// What is said against a file of this content.
std::string said(const std::string& text) {
  const ScratchFolder scratch;
  const std::string path = scratch.write("case.toml", text);
  try {
    static_cast<void>(read_case(path));
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.find(path) == 0 ? "FILE" + what.substr(path.size()) : what;
  }
  return "";
}

}  // namespace

TEST_CASE("AMissingFileIsAFileError") {
  CHECK_THROWS_AS(read_case("/nowhere/case.toml"), FileError);
  CHECK_THROWS_WITH(read_case("/nowhere/case.toml"), Catch::Contains("no such file"));
  const std::string folder = std::filesystem::temp_directory_path().string();
  CHECK_THROWS_AS(read_case(folder), FileError);
  CHECK_THROWS_WITH(read_case(folder), Catch::Contains("folder"));
}

TEST_CASE("AnEmptyFileIsRefused") {
  check_parts(said(""), {"FILE: the file is empty", "shellback init"});
  check_parts(said(" \n\t\r\n"), {"FILE: the file is empty"});
}

TEST_CASE("AHugeFileIsRefusedWithoutReadingIt") {
  const ScratchFolder scratch;
  const std::string path = scratch.write("case.toml", "x");
  std::filesystem::resize_file(path, 100'000'000);  // sparse: takes no room on disk
  CHECK_THROWS_AS(read_case(path), InputError);
  CHECK_THROWS_WITH(read_case(path), Catch::Contains("larger than 10 MB"));
  CHECK_THROWS_WITH(read_case("/dev/zero"), Catch::Contains("larger than 10 MB"));
}

TEST_CASE("ABinaryFileIsRefusedAtTheFirstByteThatIsNoText") {
  using namespace std::string_literals;
  check_parts(said("a = 1\nb\0c"s), {"FILE:2:2", "0x00", "UTF-8"});
  check_parts(said("a = \"\xFF\"\n"), {"FILE:1:6", "0xFF"});
  check_parts(said("\x7F"
                   "ELF\x02\x01\x01\0\0"s),
              {"FILE:1:8", "0x00"});
  check_parts(said("\xFF\xFE[\0b\0"s), {"FILE", "UTF-16"});
  check_parts(said("a = \"\xC0\xAF\"\n"), {"FILE:1:6"});      // overlong
  check_parts(said("a = \"\xED\xA0\x80\"\n"), {"FILE:1:6"});  // surrogate
  check_parts(said("a = \"\xF5\x80\x80\x80\"\n"), {"FILE:1:6"});
}

TEST_CASE("AByteOrderMarkAndForeignLettersAreNoHindrance") {
  CHECK(said("\xEF\xBB\xBF" + kSampleCase).empty());
  CHECK(said(sample_with("title = \"sample\"", "title = \"Lager für Łódź, 轴承\"")).empty());
  std::string windows;
  for (const char c : kSampleCase) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(said(windows).empty());
}

TEST_CASE("BrokenTomlIsRefusedInPlainWords") {
  check_parts(refusal("a = \n"), {"case.toml:1:5", "no value after"});
  check_parts(refusal("a = 3 mm\n"), {"case.toml:1:7", "stands in quotes"});
  check_parts(refusal("a = \"3\n"), {"case.toml:1:7", "quote is not closed"});
  check_parts(refusal("a = 1\na = 2\n"), {"case.toml:2:5", "given twice"});
  check_parts(refusal("abc\n"), {"case.toml:1:4", "no \"=\""});
  check_parts(refusal("a = [1,\n"), {"case.toml:", "ends in the middle"});
  check_parts(refusal("[a\nb = 1\n"), {"case.toml:1:3"});
}

TEST_CASE("DeepNestingIsRefusedNotFollowed") {
  std::string dotted = "a";
  for (int k = 0; k < 200'000; ++k) dotted += ".a";
  check_parts(refusal(dotted + " = 1\n"), {"case.toml:1:1", "nested deeper"});
  std::string quoted_key = "\"a\"";
  for (int k = 0; k < 1000; ++k) quoted_key += " . 'a'";
  check_parts(refusal(quoted_key + " = 1\n"), {"nested deeper"});
  CHECK_FALSE(refusal("a = " + std::string(200'000, '[')).empty());
  std::string tables;
  for (int k = 0; k < 100'000; ++k) tables += "{a=";
  CHECK_FALSE(refusal("a = " + tables).empty());
}
