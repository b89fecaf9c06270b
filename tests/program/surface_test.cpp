// From a height map to a case that runs with its factors.
#include <nlohmann/json.hpp>

#include "app/read_case.hpp"
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
const std::string kTable =
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
  std::string negative = kTable;
  negative.replace(negative.find("2.01, 0.7"), 9, "2.01,-0.7");
  check_words(refused(scratch, negative), {"factors.csv:3:", "phi_x is -0.7", "positive"});
  std::string other = kTable;
  other.replace(other.find("0.3, 2"), 6, "0.4, 2");
  check_words(refused(scratch, other), {"factors.csv:3:1", "same in every row"});
  check_words(refused(scratch, kTable.substr(0, kTable.find("0.3, 4"))), {"2 rows", "3 or more"});
  check_words(refused(scratch, kTable, "[surfaces]\nflow_factors = \"factors.csv\"\n"),
              {"surfaces.flow_factors", "smooth"});
}

TEST_CASE("ATableForAnotherRoughnessOrForTwoSurfacesIsWarnedOf") {
  const ScratchFolder scratch;
  static_cast<void>(scratch.write("factors.csv", kTable));
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
