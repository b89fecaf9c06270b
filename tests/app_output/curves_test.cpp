/// What a run in time follows, as a table.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/write_curves.hpp"
#include "app/write_cycle_json.hpp"
#include "bearing/instant.hpp"
#include "fidelity/march_bars.hpp"
#include "synthetic_cycle.hpp"

using namespace shellback;

namespace {

std::vector<std::vector<std::string>> fields_of(const std::string& csv) {
  std::vector<std::vector<std::string>> all;
  std::istringstream in(csv);
  for (std::string line; std::getline(in, line);) {
    all.emplace_back();
    std::istringstream fields(line + ",");
    for (std::string field; std::getline(fields, field, ',');) all.back().push_back(field);
  }
  return all;
}

}  // namespace

TEST_CASE("CurvesOfACycleAreThoseOfItsJson") {
  for (const auto& cycle : {test::synthetic_cycle(), test::timed_cycle(), test::stopped_cycle()}) {
    const auto rows =
        fields_of(app::curves_csv(app::curves_of(test::cycle_case(), cycle), cycle.verdict));
    const auto json = nlohmann::json::parse(app::cycle_json(test::cycle_case(), cycle))["cycle"];
    REQUIRE(rows.size() == cycle.instants.size() + 1);
    REQUIRE(rows[0].back() == "status");
    for (std::size_t k = 1; k < rows.size(); ++k) {
      CHECK(rows[k].back() == to_string(cycle.verdict.status));
    }
    for (std::size_t column = 0; column + 1 < rows[0].size(); ++column) {
      const std::string& head = rows[0][column];
      const std::string name = head.substr(0, head.find(" ["));
      INFO(head);
      REQUIRE(json.contains(name));
      CHECK(head == name + " [" + json[name]["unit"].get<std::string>() + "]");
      for (std::size_t k = 1; k < rows.size(); ++k) {
        REQUIRE(rows[k].size() == rows[0].size());
        const auto& value = json[name]["values"][k - 1];
        if (value.is_null()) {
          CHECK(rows[k][column].empty());
        } else {  // all digits are written: the very same number is read back
          CHECK(std::stod(rows[k][column]) == value.get<double>());
        }
      }
    }
  }
}

TEST_CASE("CurvesOfATransientHaveTheirBarsBesideThem") {
  std::vector<bearing::Instant> instants(3);
  fidelity::MarchBars bars;
  for (std::size_t k = 0; k < 3; ++k) {
    instants[k].t = 0.5 * static_cast<double>(k);
    instants[k].torque = -1.25;
    bars.grid.emplace_back();
    bars.time.emplace_back();
    bars.grid[k].torque = 0.25;
    bars.time[k].torque = k == 1 ? NAN : 0.5;
  }
  const auto plain = fields_of(app::curves_csv(
      app::curves_of(instants, fidelity::MarchBars{}, bearing::kFollowedInstants), {}));
  const auto rows =
      fields_of(app::curves_csv(app::curves_of(instants, bars, bearing::kFollowedInstants), {}));
  REQUIRE(rows.size() == 4);
  CHECK(rows[0].size() == 2 * plain[0].size() - 2);  // time and status have no bar
  CHECK(rows[0][0] == "time [s]");
  CHECK(rows[0][1] == "friction_torque [N m]");
  CHECK(rows[0][2] == "friction_torque error [N m]");
  CHECK(std::stod(rows[2][0]) == 0.5);
  CHECK(std::stod(rows[1][1]) == -1.25);
  CHECK(std::stod(rows[1][2]) == 0.75);  // grid and time together
  CHECK(rows[2][2].empty());             // not known whole: no number
}
