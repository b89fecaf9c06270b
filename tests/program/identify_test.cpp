/// shellback identify: files, exit codes, and what the program says.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/reading/case_text.hpp"
#include "app/reading/identify_case.hpp"
#include "bearing/steady/solve.hpp"
#include "tests/app/sample_case.hpp"
#include "tests/program/run_words.hpp"

using namespace shellback;
using namespace shellback::app;
using namespace shellback::program;
using namespace shellback::program::tests;

namespace {

/// The sample, isothermal on a coarse grid, rough, with a law of boundary friction.
std::string rubbing_case() {
  std::string text = sample_with(
      "tier = \"tehd\"", "tier = \"isothermal\"\ngrid = [48, 7]\nelastic_deformation = false");
  return text + "\n" + kRoughSurfaces + R"([surfaces.contact.friction_law]
abrasive = 0.01
adhesive = 0.05
a = 10.0
b = 300.0
c = 0.0
summit_radius = "10 um"
)";
}

const std::string kLaw = "surfaces.contact.friction_law.";

/// Torques of the case at these speeds, with an adhesion of 0.08, as a table.
std::string torques(const std::vector<int>& rpm) {
  std::string table = "speed [rpm], friction_torque [N m], friction_torque_sd [N m]\n";
  for (const int n : rpm) {
    const auto c = read_case_text(rubbing_case(), "case.toml",
                                  {parse_override(fmt::format("operation.speed={} rpm", n)),
                                   parse_override(kLaw + "adhesive=0.08")});
    const bearing::Result r = bearing::solve(c);
    REQUIRE(r.verdict.good());
    table += fmt::format("{}, {:.12g}, 0.001\n", n, r.value("friction_torque"));
  }
  return table;
}

}  // namespace

TEST_CASE("IdentifyFindsAKeyAndWritesWhatItFound", "[identify]") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", rubbing_case());
  const auto data = scratch.write("data.csv", torques({10, 40, 150}));
  const Ended ended =
      run_words({"identify", path, "--measured", data, "--fit", kLaw + "adhesive", "--bounds",
                 kLaw + "adhesive=0.01:0.5", "--json", scratch.path("fit.json"), "--csv",
                 scratch.path("fit.csv"), "--picture", scratch.path("fit.svg")});
  INFO(ended.err);
  REQUIRE(ended.code == kDone);
  check_parts(ended.out, {"settled", "determined", "--set " + kLaw + "adhesive=\"0.08"});
  std::ifstream file(scratch.path("fit.json"));
  const auto json = nlohmann::json::parse(file);
  CHECK(json["sound"] == true);
  CHECK(json["keys"][0]["value"].get<double>() == Approx(0.08).epsilon(1e-5));
  CHECK(json["keys"][0]["deviation"].get<double>() > 0.0);
  CHECK(json["points"].size() == 3);
  CHECK(json.contains("changes"));
  CHECK(json["case"]["bearing"].is_object());
  check_parts(read_text_file(scratch.path("fit.svg")), {"<svg", "friction torque", "adhesive = "});
  check_parts(read_text_file(scratch.path("fit.csv")), {"point,speed [rpm],quantity"});
}

TEST_CASE("IdentifyRefusesWhatTheDataCannotTellWithThree", "[identify]") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", rubbing_case());
  const auto data = scratch.write("data.csv", torques({10, 40, 150}));
  const Ended ended = run_words({"identify", path, "--data", data, "--fit",
                                 kLaw + "a," + kLaw + "b", "--set", kLaw + "adhesive=0.08",
                                 "--bounds", kLaw + "a=1.5:100", "--bounds", kLaw + "b=1:1e5"});
  CHECK(ended.code == kNotConverged);
  check_parts(ended.err, {"do not determine", "a x ", "b x ", "--set"});
  check_parts(ended.out, {"NOT determined"});
}

TEST_CASE("IdentifyWithoutWhatItNeedsEndsWithTwo", "[identify]") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", rubbing_case());
  const auto data = scratch.write("data.csv", "speed [rpm], friction_torque [N m]\n40, x\n");
  const auto code = [&](std::vector<std::string> more, const std::string& part) {
    more.insert(more.begin(), {"identify", path});
    const Ended ended = run_words(more);
    check_parts(ended.err, {part});
    return ended.code;
  };
  const std::string key = kLaw + "adhesive";
  const std::string bounds = key + "=0.01:0.5";
  CHECK(code({"--fit", key, "--bounds", bounds}, "--data FILE.csv") == kBadInput);
  CHECK(code({"--measured", data, "--fit", key, "--bounds", bounds}, "data.csv:2:5") == kBadInput);
  const auto good = scratch.write("good.csv", "speed [rpm], friction_torque [N m]\n40, 1\n");
  CHECK(code({"--measured", good}, "--fit KEY") == kBadInput);
  CHECK(code({"--data", good, "--fit", key + "=0.01..2"}, "between 0 and 1") == kBadInput);
  CHECK(code({"--data", good, "--fit", key + "=0.5"}, "KEY=FROM..TO") == kBadInput);
  CHECK(code({"--measured", good, "--set", "oil.name=0W20", "--fit", "oil.name"},
             "oil.name is no number") == kBadInput);
  CHECK(code({"--measured", good, "--fit", kLaw + "adhesvie"}, kLaw + "adhesive") == kBadInput);
  CHECK(code({"--measured", good, "--fit", key, "--bounds", key + "=0.01:2"}, "between 0 and 1") ==
        kBadInput);
  CHECK(code({"--measured", good, "--fit", key, "--bounds", bounds, "--tier", "auto"},
             "tier auto") == kBadInput);
  CHECK(code({"--measured", good, "--fit", key + "," + kLaw + "b", "--bounds", kLaw + "b=1:1e5",
              "--bounds", bounds},
             "1 measured value cannot determine 2 keys") == kBadInput);
  const auto slow = scratch.write("slow.csv", "speed [rpm], T_shell_max [degC]\n40, 90\n");
  CHECK(code({"--measured", slow, "--fit", key, "--bounds", bounds},
             "does not compute T_shell_max") == kBadInput);
  const auto scale = scratch.write(
      "scale.csv", "speed [rpm], T_film_max [degC], T_film_max_sd [degC]\n40, 90, 1\n");
  CHECK(code({"--measured", scale, "--fit", key, "--bounds", bounds}, "write K") == kBadInput);
  const std::string none = scratch.path("none.csv");
  CHECK(code({"--measured", none, "--fit", key}, "from the current folder") == kBadFile);
}

TEST_CASE("KeysWithWhichCellsMoveAreNamed", "[identify]") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", rubbing_case());
  const auto data = scratch.write("data.csv", torques({150}));
  const MeasuredTable table = read_measured_table(data, 1, true);
  const auto named = [&](const std::string& key, const std::string& bounds) {
    const auto keys = fitted_keys(rubbing_case(), path, {}, {key}, {key + "=" + bounds}, table);
    const auto case_at = measured_case(rubbing_case(), path, {}, table, keys);
    return keys_that_move_cells(case_at, keys, {keys[0].value.start}) == std::vector{key};
  };
  CHECK(named("supply.0.diameter", "2:9"));
  CHECK_FALSE(named("supply.0.pressure", "0.5:5"));
  CHECK_FALSE(named("bearing.radial_clearance", "10:60"));
  CHECK(named("bearing.width", "15:30"));  // the hole takes another part of it
}

TEST_CASE("IdentifyWarnsWhereTheCaseDoesNotDescribeTheData", "[identify]") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", rubbing_case());
  const auto data = scratch.write("data.csv", torques({10, 40, 150}));
  const Ended ended =
      run_words({"identify", path, "--measured", data, "--fit", kLaw + "adhesive", "--bounds",
                 kLaw + "adhesive=0.01:0.5", "--set", kLaw + "b=10"});  // 300 made the torques
  CHECK(ended.code == kDone);
  check_parts(ended.err, {"warning: ", "chi2", "does not describe"});
}

TEST_CASE("WithoutDeviationsIdentifyTellsAFitThatMissesTheValuesThemselves", "[identify]") {
  const ScratchFolder scratch;
  const auto path = scratch.write("case.toml", rubbing_case());
  const auto fitted = [&](const std::vector<double>& torque) {
    std::string table = "speed [rpm], friction_torque [N m]\n";
    const std::vector<int> rpm{10, 40, 150};
    for (std::size_t k = 0; k < rpm.size(); ++k)
      table += fmt::format("{}, {}\n", rpm[k], torque[k]);
    const Ended ended =
        run_words({"identify", path, "--measured", scratch.write("data.csv", table), "--fit",
                   kLaw + "adhesive", "--bounds", kLaw + "adhesive=0.01:0.5"});
    return ended.err;  // done, or, of no bearing, not determined
  };
  CHECK(fitted({0.1, 5.0, 0.1}).find("% of themselves") != std::string::npos);  // of no bearing
  std::vector<double> own;
  for (const int n : {10, 40, 150}) {
    const bearing::Result r = bearing::solve(read_case_text(
        rubbing_case(), "case.toml", {parse_override(fmt::format("operation.speed={} rpm", n))}));
    own.push_back(r.value("friction_torque"));
  }
  CHECK(fitted(own).find("of themselves") == std::string::npos);
}
