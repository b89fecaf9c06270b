/// Stiffness and damping as they are written.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/words/ending_words.hpp"
#include "app/write_coefficients.hpp"
#include "app/write_json.hpp"
#include "synthetic.hpp"

using namespace shellback;
using nlohmann::json;

namespace {

bearing::Coefficients sample() {
  bearing::Coefficients k;
  k.K = {
      {{2e7, 5e7, 3e5, 4e5}, {-1e7, 1.6e7, 1e5, 2e5}, {1.0, 2.0, 3e4, 4.0}, {5.0, 6.0, 7.0, 8e4}}};
  k.C = {
      {{9e4, 2.5e4, 0.0, 0.0}, {2e4, 3e4, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0}}};
  k.unknowns = 4;
  k.omega = -314.159265358979;
  k.K_load = {{{1.25, 7.5}, {-2.25, 1.5}}};
  k.whirl = {bearing::WhirlVerdict::threshold, 12.5, 150.0};
  k.speed_ratio = 2.125;
  return k;
}

bearing::Result with_coefficients() {
  bearing::Result r = test::synthetic_result();
  r.coefficients = sample();
  return r;
}

json written(const bearing::Result& r) {
  return json::parse(app::result_json(test::synthetic_case(), r));
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) out.push_back(field);
  return out;
}

}  // namespace

TEST_CASE("TheTableOfCoefficientsHasTheColumnsOfRoss", "[coefficients]") {
  std::istringstream text(app::coefficients_csv({sample()}));
  std::string head;
  std::string row;
  std::getline(text, head);
  std::getline(text, row);
  CHECK(head == "frequency,kxx,kxy,kyx,kyy,cxx,cxy,cyx,cyy");
  const std::vector<double> expected{
      -314.159265358979, 2e7, 5e7, -1e7, 1.6e7, 9e4, 2.5e4, 2e4, 3e4};
  const auto values = fields(row);
  REQUIRE(values.size() == expected.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    CHECK(std::stod(values[k]) == Approx(expected[k]).epsilon(1e-8));  // digits written
  }
  CHECK_FALSE(std::getline(text, row));
}

TEST_CASE("TheTableOfCoefficientsRisesWithTheSpeed", "[coefficients]") {
  bearing::Coefficients slow = sample(), fast = sample();
  slow.omega = 10.0;
  fast.omega = 20.0;
  std::istringstream text(app::coefficients_csv({fast, slow}));
  std::string row;
  std::getline(text, row);
  for (const double omega : {10.0, 20.0}) {
    std::getline(text, row);
    CHECK(std::stod(fields(row).front()) == omega);
  }
}

TEST_CASE("JsonHasBothMatricesWithTheirUnits", "[coefficients]") {
  const json j = written(with_coefficients())["coefficients"];
  CHECK(j["K"]["unit"] == "N/m");
  CHECK(j["K"]["value"] == json({{2e7, 5e7}, {-1e7, 1.6e7}}));
  CHECK(j["C"]["unit"] == "N s/m");
  CHECK(j["C"]["value"][0][1] == 2.5e4);
  CHECK(j["K_with_tilt"]["value"][2][2] == 3e4);
  CHECK(j["load_axes"]["K_c_over_W"][0][1] == 7.5);
  CHECK(j["whirl"]["critical_mass"]["value"] == sample().whirl.critical_mass);
  bearing::Result plane = with_coefficients();
  plane.coefficients->unknowns = 2;
  CHECK_FALSE(written(plane)["coefficients"].contains("K_with_tilt"));
  CHECK_FALSE(written(test::synthetic_result()).contains("coefficients"));
}

TEST_CASE("CoefficientsThatWereNotFoundAreNotWritten", "[coefficients]") {
  bearing::Result r = with_coefficients();
  r.coefficients->verdict = {Status::iteration_limit, ending::Plain::unsettled_response};
  const json j = written(r)["coefficients"];
  CHECK(j["reason"] == app::reason_of(r.coefficients->verdict));
  CHECK_FALSE(j.contains("K"));
  std::ostringstream out;
  app::print_coefficients(out, r);
  CHECK(out.str().empty());
}

TEST_CASE("TheTableTellsWhenARotorIsStable", "[coefficients]") {
  bearing::Result r = with_coefficients();
  const auto words = [&] {
    std::ostringstream out;
    app::print_coefficients(out, r);
    return out.str();
  };
  CHECK(words().find("7.5") != std::string::npos);
  CHECK(words().find("per bearing") != std::string::npos);
  r.coefficients->whirl.verdict = bearing::WhirlVerdict::always_stable;
  CHECK(words().find("stably at this speed whatever its mass") != std::string::npos);
  r.coefficients->whirl.verdict = bearing::WhirlVerdict::never_stable;
  CHECK(words().find("does not run stably") != std::string::npos);
}
