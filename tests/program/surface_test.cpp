// From a height map to a case that runs with its factors.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/reading/read_case.hpp"
#include "app/result_mark.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/program/run_words.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::program;
using namespace shellback::program::tests;

namespace {

const std::string kMap =
    std::string(SHELLBACK_SOURCE_DIR) + "/data/surfaces/generated-longitudinal.txt";
const std::string kFactors =
    "sigma [um], h_over_sigma [1], average_gap [1], phi_x [1], phi_z [1], phi_s [1], "
    "phi_f [1], phi_fs [1], phi_fp [1]\n"
    "0.3, 1, 1.08, 0.5, 0.4, 0.8, 1.6, 1.1, 0.28\n"
    "0.3, 2, 2.01, 0.7, 0.6, 0.7, 1.6, 0.7, 0.65\n"
    "0.3, 4, 4, 0.9, 0.85, 0.4, 1.1, 0.1, 0.9\n";

std::string with_factors(const std::string& surfaces) {
  std::string text = kSampleCase;
  return text.replace(text.find("[model]"), 7, surfaces + "\n[model]");
}

const std::string kRough =
    "[surfaces]\nflow_factors = \"factors.csv\"\nshell = { roughness = \"0.3 um\" }\n";

std::string refused(const ScratchFolder& scratch, const std::string& table,
                    const std::string& surfaces = kRough) {
  static_cast<void>(scratch.write("factors.csv", table));
  const std::string file = scratch.write("case.toml", with_factors(surfaces));
  const Ended ended = run_words({"check", file});
  CHECK(ended.code == kBadInput);
  return ended.err;
}

void check_words(const std::string& said, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    INFO(said);
    CHECK(said.find(part) != std::string::npos);
  }
}

}  // namespace

TEST_CASE("TheShippedMapGivesWhatItWasMadeOf") {
  // Rq 0.34 um, gamma 3, tilt 5 mrad, curvature 200 1/m along y; 330 independent areas: Rq within
  // 3 x 4 %, lengths within 20 %, tilt and curvature by 9 and 14 % (one deviation).
  const Ended ended = run_words({"surface", kMap, "--json", "-", "--gaps", "1,2,4", "-j", "1"});
  REQUIRE(ended.code == kDone);
  const auto json = nlohmann::json::parse(ended.out);
  CHECK(json["heights"]["Rq"]["value"].get<double>() == Approx(0.34e-6).epsilon(0.12));
  CHECK(json["heights"]["gamma"].get<double>() == Approx(3.0).epsilon(0.25));
  CHECK(json["map"]["form"]["slope"][0].get<double>() == Approx(5e-3).epsilon(0.25));
  CHECK(json["map"]["form"]["curvature"][1]["value"].get<double>() == Approx(200.0).epsilon(0.4));
  CHECK(json["flow_factors"]["rows"].size() == 3);
  CHECK(json["flow_factors"]["rows"][2]["phi_x"].get<double>() == Approx(1.0).epsilon(0.1));
}

TEST_CASE("ACaseRunsWithTheFactorsOfAMap") {
  const ScratchFolder scratch;
  const std::string csv = scratch.path("factors.csv"), picture = scratch.path("map.svg");
  const Ended ended = run_words({"surface", kMap, "--csv", csv, "--picture", picture, "--gaps",
                                 "0.5,0.75,1,1.5,2,3,4,6,10", "-j", "1", "--composite-modulus",
                                 "70 GPa", "--hardness", "300 MPa"});
  INFO(ended.err);
  REQUIRE(ended.code == kDone);
  check_words(ended.out, {"orientation gamma", "spectral moments", "phi_fp", "flow_factors"});
  CHECK(is_result(csv));
  CHECK(is_result(picture));
  const std::string file = scratch.write(
      "case.toml", with_factors("[surfaces]\nflow_factors = \"factors.csv\"\n[surfaces.shell]\n"
                                "roughness = \"0.34 um\"\n"));
  const Ended run = run_words({"run", file, "--tier", "isothermal", "--set", "model.grid=[48, 9]",
                               "--set", "operation.load=20 kN", "--json", "-"});
  INFO(run.err);
  REQUIRE(run.code == kDone);
  const auto json = nlohmann::json::parse(run.out);
  CHECK(json["case"]["surfaces"]["flow_factors"]["table"] == "factors.csv");
  // The table is an input of the run.
  CHECK(run_words({"run", file, "--json", csv}).code == kBadInput);
}

TEST_CASE("ATableOfFactorsThatCannotBeIsRefusedWithItsPlace") {
  const ScratchFolder scratch;
  check_words(refused(scratch, "h_over_sigma [1]\n1\n"), {"factors.csv:1:1", "no column"});
  std::string negative = kFactors;
  negative.replace(negative.find("2.01, 0.7"), 9, "2.01,-0.7");
  check_words(refused(scratch, negative), {"factors.csv:3:", "phi_x is -0.7", "positive"});
  std::string other = kFactors;
  other.replace(other.find("0.3, 2"), 6, "0.4, 2");
  check_words(refused(scratch, other), {"factors.csv:3:1", "same in every row"});
  check_words(refused(scratch, kFactors.substr(0, kFactors.find("0.3, 4"))),
              {"2 rows", "3 or more"});
  std::string shear = kFactors;
  shear.replace(shear.find("0.7, 0.65"), 9, "0.7, 0.95");
  check_words(refused(scratch, shear), {"factors.csv:3:", "phi_fp is 0.95", "reciprocity"});
  check_words(refused(scratch, kFactors, "[surfaces]\nflow_factors = \"factors.csv\"\n"),
              {"surfaces.flow_factors", "smooth"});
}

TEST_CASE("AColumnWithoutUnitTakesPerCent") {
  const ScratchFolder scratch;
  std::string table = kFactors;
  table.replace(table.find("0.7, 0.6, 0.7"), 13, "70 %, 0.6, 70%");
  static_cast<void>(scratch.write("factors.csv", table));
  const auto c = read_case(scratch.write("case.toml", with_factors(kRough)));
  REQUIRE(c.surfaces.flow_factors);
  CHECK(c.surfaces.flow_factors->phi_x.at(1) == Approx(0.7));
}

TEST_CASE("ATableForAnotherRoughnessOrForTwoSurfacesIsWarnedOf") {
  const ScratchFolder scratch;
  static_cast<void>(scratch.write("factors.csv", kFactors));
  const std::string text = with_factors(
      "[surfaces]\nflow_factors = \"factors.csv\"\nshell = { roughness = \"0.6 um\" }\n"
      "shaft = { roughness = \"0.2 um\" }\n");
  const auto c = read_case(scratch.write("case.toml", text));
  std::string all;
  for (const std::string& warning : c.warnings) all += warning + "\n";
  check_words(all, {"measured on a roughness of 0.3 um", "both surfaces are rough"});
}

TEST_CASE("SurfaceRefusesWrongOptionsAndItsOwnMapAsOutput") {
  check_words(run_words({"surface"}).err, {"map's file is missing"});
  CHECK(run_words({"surface", kMap, "--gaps", "2,1,3"}).code == kBadInput);
  CHECK(run_words({"surface", kMap, "--gaps", "1,2"}).code == kBadInput);
  CHECK(run_words({"surface", kMap, "--hardness", "-3 MPa"}).code == kBadInput);
  CHECK(run_words({"surface", kMap, "--hardness", "3"}).code == kBadInput);
  CHECK(run_words({"surface", kMap, "--motion", "z"}).code == kBadInput);
  CHECK(run_words({"surface", kMap, "--csv", kMap, "--force"}).code == kBadInput);
  CHECK(run_words({"surface", "no-such-map.txt"}).code == kBadFile);
}

namespace {

/// A map of z(i, j) in um, 64 x 48 points, a pitch of 1 um, over a case's file.
std::string map_of(const ScratchFolder& scratch, const std::function<double(int, int)>& z,
                   const std::string& header = "# Pitch: 1 um\n# Value units: um\n") {
  std::string text = header;
  for (int j = 0; j < 48; ++j) {
    for (int i = 0; i < 64; ++i) text += fmt::format("{:.17g} ", z(i, j));
    text += "\n";
  }
  return scratch.write("map.txt", text);
}

constexpr double kTurn = 2.0 * 3.14159265358979323846;

double grooves_across(int i, int) { return 0.3 * std::sin(kTurn * (i + 0.25) / 16.0); }

double egg_box(int i, int j) {
  return 0.1 * (std::sin(kTurn * (i + 0.25) / 16.0) + std::sin(kTurn * (j + 0.25) / 16.0));
}

double noise(int i, int j) {
  return std::fmod(std::abs(std::sin(i * 12.9898 + j * 78.233)) * 43758.5, 1.0);
}

}  // namespace

TEST_CASE("AMapThatIsFormAloneIsRefusedByName") {
  const ScratchFolder scratch;
  const auto refused_map = [&](const std::function<double(int, int)>& z, const char* degree) {
    const Ended ended = run_words({"surface", map_of(scratch, z), "--form", degree, "-j", "1"});
    CHECK(ended.code == kBadInput);
    check_words(ended.err, {"map.txt", "no roughness is left"});
  };
  refused_map([](int, int) { return 3.7; }, "0");
  refused_map([](int i, int j) { return 5.0 + 0.01 * i - 0.02 * j; }, "1");
  refused_map([](int i, int j) { return 5.0 + 1e-3 * i * i - 2e-3 * i * j; }, "2");
}

TEST_CASE("AMapInWrongUnitsIsRefusedOrToldBySlopes") {
  // Noise of 1 um over a pitch of 1 um: neighbours differ by 0.41 um (uniform, standing apart),
  // sqrt(2/12) along each axis, 0.58 in all; in mm a thousandfold.
  const ScratchFolder scratch;
  const std::vector<std::string> more{"--error", "1", "--gaps", "3,4,6", "-j", "1"};
  const auto run_map = [&](const std::string& header) {
    std::vector<std::string> words{"surface", map_of(scratch, noise, header)};
    words.insert(words.end(), more.begin(), more.end());
    return run_words(words);
  };
  const Ended wrong = run_map("# Pitch: 1 um\n# Value units: mm\n");
  CHECK(wrong.code == kBadInput);
  check_words(wrong.err, {"map.txt", "slopes of 5", "check the units"});
  const Ended steep = run_map("# Pitch: 1 um\n# Value units: um\n");
  CHECK(steep.code == kDone);
  check_words(steep.out, {"note: slopes of 0.5", "thin-film"});
  const Ended oblong = run_map("# Width: 64 um\n# Height: 48 mm\n# Value units: nm\n");
  CHECK(oblong.code == kDone);
  check_words(oblong.out, {"note: the pitch is 1 um along the motion and 1000 um across"});
}

TEST_CASE("AMapWithoutSummitsOrWithEqualOnesTellsWhatIsNotKnown") {
  const ScratchFolder scratch;
  const auto told = [&](const std::function<double(int, int)>& z) {
    const Ended ended = run_words({"surface", map_of(scratch, z), "--error", "1", "--form", "0",
                                   "--gaps", "2,3,4,6", "-j", "1"});
    INFO(ended.err);
    CHECK(ended.code == kDone);
    CHECK(ended.out.find("nan") == std::string::npos);
    CHECK(ended.out.find("summit_height") == std::string::npos);  // not in the case's lines
    return ended.out;
  };
  check_words(told(grooves_across), {"note: no summit was counted", "n/a"});
  check_words(told(egg_box), {"note: the summits are equal", "n/a"});
}

TEST_CASE("ATableThatNoCaseCanTakeIsNotWritten") {
  // Grooves across, closed below h/sigma = 1.42: of four gaps two are left.
  const ScratchFolder scratch;
  const std::string csv = scratch.path("closed.csv"), json = scratch.path("closed.json");
  const Ended ended =
      run_words({"surface", map_of(scratch, grooves_across), "--error", "1", "--form", "0",
                 "--gaps", "0.5,1,2,4", "-j", "1", "--csv", csv, "--json", json});
  CHECK(ended.code == kBadInput);
  check_words(ended.err, {"map.txt", "2 rows", "--gaps"});
  CHECK_FALSE(std::filesystem::exists(csv));
  CHECK(std::filesystem::exists(json));  // what was found is not lost
  check_words(ended.out, {"note: at the 2 smallest gaps", "note: no case can take"});
}
