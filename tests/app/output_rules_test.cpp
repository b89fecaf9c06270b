/// What a run may write: never an input, and no file that is not its own.
#include "app/output_rules.hpp"

#include <sys/stat.h>

#include "app/file_identity.hpp"
#include "app/pending_file.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/text_of_file.hpp"

using namespace shellback;
using namespace shellback::app;

namespace {

namespace fs = std::filesystem;

/// What is said against writing `paths` as JSON; empty if nothing is.
std::string refusal(const std::vector<Output>& outputs, const std::vector<std::string>& inputs = {},
                    bool force = false) {
  try {
    expect_sound(outputs, inputs, force);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("AnOutputIsNoInputWhateverTheTwoAreCalled") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("table.json", "phi [deg], z [mm], height [um]\n");
  fs::create_symlink("table.json", scratch.path("soft.json"));
  fs::create_hard_link(input, scratch.path("hard.json"));
  fs::create_directory_symlink(scratch.path("."), scratch.path("folder"));
  for (const char* name :
       {"table.json", "./table.json", "soft.json", "hard.json", "folder/table.json"}) {
    INFO(name);
    check_parts(refusal({{"--json", scratch.path(name), Format::json}}, {input}, true),
                {"--json: ", name, "never replaces an input", "another name"});
  }
  CHECK(refusal({{"--json", scratch.path("other.json"), Format::json}}, {input}).empty());
}

TEST_CASE("OnlyAResultOrAnEmptyFileIsReplaced") {
  const ScratchFolder scratch;
  const Output foreign{"--json", scratch.write("mine.json", "{\"mine\": 1}\n"), Format::json};
  check_parts(refusal({foreign}), {"mine.json", "no result of shellback", "--force"});
  CHECK(refusal({foreign}, {}, true).empty());
  const std::string result = scratch.write("ours.json", marked(Format::json, "{\n \"a\": 1}\n"));
  CHECK(refusal({{"--json", result, Format::json}}).empty());
  CHECK(refusal({{"--json", scratch.write("empty.json", ""), Format::json}}).empty());
  // Results that somebody has put together are somebody's work.
  const std::string joined = scratch.write("all.json", "[\n" + marked(Format::json, "{}") + "]\n");
  CHECK_FALSE(refusal({{"--json", joined, Format::json}}).empty());
}

TEST_CASE("AnExtensionThatPromisesAnotherFormatIsRefusedWithTheRightOne") {
  struct Row {
    const char* name;
    Format format;
    const char* cure;  ///< nullptr: nothing is said against it
  };
  const ScratchFolder scratch;
  for (const Row& row : std::vector<Row>{{"x.json", Format::hdf5, "x.h5"},
                                         {"x.toml", Format::hdf5, "x.h5"},
                                         {"x.txt", Format::hdf5, "x.h5"},
                                         {"x.h5", Format::json, "x.json"},
                                         {"x.html", Format::csv, "x.csv"},
                                         {"x.SVG", Format::html, "x.html"},
                                         {"x.png", Format::svg, "x.svg"},
                                         {"x.pdf", Format::svg, "x.svg"},
                                         {"x.json", Format::coefficients, "x.csv"},
                                         {"x.csv", Format::markdown, "x.md"},
                                         {"x.HDF5", Format::hdf5, nullptr},
                                         {"x.txt", Format::csv, nullptr},
                                         {"x", Format::png, nullptr},
                                         {"x.Vm3k", Format::json, nullptr}}) {
    INFO(row.name << " as " << static_cast<int>(row.format));
    const std::string said = refusal({{"-o", scratch.path(row.name), row.format}});
    if (row.cure == nullptr) {
      CHECK(said.empty());
    } else {
      check_parts(said, {"-o: ", "promises", std::string("name it ") + scratch.path(row.cure)});
    }
  }
}

TEST_CASE("TwoOutputsAreTwoFiles") {
  const ScratchFolder scratch;
  const Output json{"--json", scratch.path("x"), Format::json};
  check_parts(refusal({json, {"--csv", scratch.path("./x"), Format::csv}}),
              {"--csv: ", "written by --json already"});
  check_parts(refusal({{"--json", "-", Format::json}, {"--csv", "-", Format::csv}}),
              {"standard output"});
  // A link to a file that is not there yet leads to it all the same.
  fs::create_symlink("x", scratch.path("link"));
  CHECK_FALSE(refusal({json, {"--csv", scratch.path("link"), Format::csv}}).empty());
  CHECK(refusal({{"--json", "/dev/null", Format::json}, {"--csv", "/dev/null", Format::csv}})
            .empty());
}

TEST_CASE("APlaceThatTakesNoFileIsAFileError") {
  const ScratchFolder scratch;
  fs::create_directory(scratch.path("folder"));
  for (const std::string& path :
       {scratch.path("nowhere/x.json"), scratch.path("folder"), std::string("/proc/x.json")}) {
    INFO(path);
    CHECK_THROWS_AS(expect_sound({{"--json", path, Format::json}}, {}, true), FileError);
  }
}

TEST_CASE("JudgingLeavesNoTrace") {
  const ScratchFolder scratch;
  CHECK(refusal({{"--json", scratch.path("x.json"), Format::json}}).empty());
  CHECK(fs::is_empty(scratch.path(".")));
}

TEST_CASE("NoWayLeadsBackThroughAFolderThatIsNotThere") {
  // "nosuch/../mine.json" was no file to the judge, and mine.json to the writer.
  const ScratchFolder scratch;
  const std::string mine = scratch.write("mine.json", "{\"mine\": 1}\n");
  const Output output{"--json", scratch.path("nosuch/../mine.json"), Format::json};
  CHECK_THROWS_AS(expect_sound({output}, {}, false), FileError);
  CHECK_THROWS_AS(expect_sound({output}, {mine}, true), FileError);
  CHECK_THROWS_AS(write_file(output.path, "{}"), FileError);
  CHECK(test::text_of_file(mine) == "{\"mine\": 1}\n");
  CHECK(fs::directory_iterator(scratch.path("."))->path().filename() == "mine.json");
}
