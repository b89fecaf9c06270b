#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/write_json.hpp"
#include "synthetic.hpp"

using namespace shellback;
using nlohmann::json;

namespace {
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
}

TEST_CASE("EveryQuantityComesBackWithItsValueAndUnit") {
  const auto result = test::synthetic_result();
  const auto j = json::parse(app::result_json(test::synthetic_case(), result));
  REQUIRE(j["quantities"].size() == result.quantities.size());
  for (const auto& q : result.quantities) {
    const auto& read = j["quantities"][q.name];
    // Doubles are printed with enough digits to come back exactly.
    CHECK(read["value"].get<double>() == q.value);
    CHECK(read["unit"] == q.unit);
    CHECK_FALSE(read.contains("error"));
  }
}

TEST_CASE("AResultHasTheBindingKeys") {
  const auto result = test::synthetic_result();
  const auto j = json::parse(app::result_json(test::synthetic_case(), result));
  for (const char* key : {"status", "tier", "title", "quantities", "audit", "effects", "grid",
                          "cost", "provenance", "limiters", "warnings", "assumptions", "history"}) {
    CHECK(j.contains(key));
  }
  CHECK(j["status"] == "converged");
  CHECK(j["tier"] == "tehd");
  CHECK(j["grid"] == json({200, 25}));
  for (const char* key : {"mass", "energy", "load", "moment"}) CHECK(j["audit"].contains(key));
  for (const char* key : {"wall_s", "factorizations", "newton_iterations", "outer_iterations"}) {
    CHECK(j["cost"].contains(key));
  }
  for (const char* key : {"version", "git", "input", "libraries"}) {
    CHECK(j["provenance"].contains(key));
  }
  CHECK(j["effects"][0]["name"] == "elastic deformation");
  CHECK(j["history"].size() == result.history.size());
  CHECK(j["limiters"][0]["count"] == 2);
  CHECK_FALSE(j.contains("reason"));
}

TEST_CASE("AQuantityTheTierDoesNotKnowIsAbsent") {
  const auto j = json::parse(
      app::result_json(test::synthetic_case(), test::synthetic_comparison().results.front()));
  CHECK_FALSE(j["quantities"].contains("T_film_max"));
  CHECK(j["quantities"].contains("T_equivalent"));
}

TEST_CASE("EveryRootOfTheHeatBalanceIsWrittenAndTheSolutionMarked") {
  auto result = test::synthetic_result();
  CHECK_FALSE(json::parse(app::result_json(test::synthetic_case(), result)).contains("heat_roots"));
  const double T = result.value("T_film_mean");
  REQUIRE(T > 0.0);
  result.heat_roots = {{T, -1.5, 0.3, 4e-6}, {T + 40.0, 0.4, 1.1, 2e-6}};
  const auto j = json::parse(app::result_json(test::synthetic_case(), result))["heat_roots"];
  REQUIRE(j.size() == 2);
  CHECK(j[0]["T_film_mean"]["value"].get<double>() == T);
  CHECK(j[0]["T_film_mean"]["unit"] == "K");
  CHECK(j[0]["stable"] == true);
  CHECK(j[0]["solution"] == true);
  CHECK(j[1]["stable"] == false);
  CHECK(j[1]["solution"] == false);
  CHECK(j[1]["friction_torque"]["value"] == 1.1);
  CHECK(j[1]["h_min"]["unit"] == "m");
}

TEST_CASE("NotANumberIsNeverPrintedAsANumber") {
  auto result = test::not_converged(test::synthetic_result());
  result.audit.energy = kNaN;
  result.quantities[0].value = std::numeric_limits<double>::infinity();
  result.history[0].residual = kNaN;
  result.effects[0].indicator = kNaN;
  const std::string text = app::result_json(test::synthetic_case(), result);
  const auto j = json::parse(text);  // NaN or Infinity would not parse
  CHECK(j["audit"]["energy"].is_null());
  CHECK(j["quantities"]["friction_torque"]["value"].is_null());
  CHECK(j["history"][0]["residual"].is_null());
}

TEST_CASE("WhatHasNoBarsIsNotToldToMeetATolerance") {
  auto result = test::synthetic_result();
  result.choice.reset();
  result.quantities = {{"friction_torque", 0.3, "N m"}, {"h_min", 2e-6, "m"}};
  const auto met = [&](double friction, double film) {
    result.quantities[0].error_grid = friction;
    result.quantities[1].error_grid = film;
    return json::parse(app::result_json(test::synthetic_case(), result))["tolerance"]["met"];
  };
  for (auto& q : result.quantities) q.error_model = 0.0;
  CHECK(met(1e-6, 1e-12) == true);
  CHECK(met(1e-6, 1e-6) == false);
  CHECK(met(kNaN, 1e-6) == false);  // one of them is enough
  for (auto& q : result.quantities) q.error_model = kNaN;
  CHECK(met(kNaN, kNaN).is_null());
}

TEST_CASE("AnglesAreGivenInDegrees") {
  auto result = test::synthetic_result();
  result.quantities = {{"attitude_angle", std::acos(-1.0) / 6.0, "rad"}};
  const auto j = json::parse(app::result_json(test::synthetic_case(), result));
  CHECK(j["quantities"]["attitude_angle"]["unit"] == "deg");
  CHECK(j["quantities"]["attitude_angle"]["value"].get<double>() == Approx(30.0).epsilon(1e-14));
}

TEST_CASE("AFailedSolveSaysReasonPlaceAndCure") {
  const auto result = test::not_converged(test::synthetic_result());
  const auto j = json::parse(app::result_json(test::synthetic_case(), result));
  CHECK(j["status"] == "iteration limit");
  CHECK(j["converged"] == false);
  CHECK(j["reason"].get<std::string>().find("film 3.2e-03") != std::string::npos);
  CHECK(j["place"] == "phi 301.9 deg, z 0.30 mm");  // 5.27 rad
  CHECK(j["cure"].get<std::string>().find("finer grid") != std::string::npos);
}

TEST_CASE("BrokenUtf8InATitleDoesNotStopTheOutput") {
  auto result = test::synthetic_result();
  result.title = "bearing \xff no. 1";
  CHECK_NOTHROW(json::parse(app::result_json(test::synthetic_case(), result)));
}

TEST_CASE("ComparisonStepsAddUpAndCalibratedTemperatureIsKept") {
  const auto comparison = test::synthetic_comparison();
  const auto j = json::parse(app::comparison_json(test::synthetic_case(), comparison));
  CHECK(j["results"].size() == 3);
  const auto& split = j["friction_split"];
  double sum = split["from"].get<double>();
  for (const auto& step : split["steps"]) sum += step["change"].get<double>();
  // The rest is round-off of the sum of a few numbers of order one.
  CHECK(sum + split["rest"].get<double>() == Approx(split["to"].get<double>()).epsilon(1e-14));
  CHECK(j["T_calibrated"]["value"].get<double>() == comparison.calibration.T);
  CHECK(j["T_calibrated"]["unit"] == "K");
  CHECK(j["measured"]["friction_torque"]["value"] == 1.0);
}

TEST_CASE("OneFailedResultMakesTheComparisonNotConverged") {
  auto comparison = test::synthetic_comparison();
  comparison.results[1] = test::not_converged(comparison.results[1]);
  comparison.split = {};
  comparison.calibration = {};
  const auto j = json::parse(app::comparison_json(test::synthetic_case(), comparison));
  CHECK(j["status"] == "iteration limit");
  CHECK(j["friction_split"].is_null());
  CHECK(j["T_calibrated"].is_null());
}

TEST_CASE("TheJsonHoldsTheCaseAsSolved") {
  auto subject = test::synthetic_case();
  subject.changes = {{"operation.speed", "1500 rpm", "--set"}};
  const auto j = json::parse(app::result_json(subject, test::synthetic_result()));
  CHECK(j["changes"] == json({{{"key", "operation.speed"}, {"value", "1500 rpm"}}}));
  const auto& c = j["case"];
  CHECK(c["bearing"]["diameter"]["value"].get<double>() == 2.0 * subject.bearing.radius);
  CHECK(c["bearing"]["diameter"]["unit"] == "m");
  CHECK(c["operation"]["speed"] == json({{"value", subject.operation.omega}, {"unit", "rad/s"}}));
  CHECK(c["operation"]["load"]["unit"] == "N");
  CHECK(c["operation"]["load_angle"]["value"].get<double>() == Approx(270.0));
  CHECK(c["supply"].size() == subject.supplies.size());
  CHECK(c["supply"][0]["depth"]["value"].get<double>() == subject.supplies[0].depth);  // a default
  CHECK(c["model"]["grid"] == json(subject.model.grid));
  CHECK(c["model"]["edges"] == "flooded");
  CHECK(c["oil"]["viscosity"]["temperature"].contains("law"));
}
