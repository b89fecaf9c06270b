#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/labels/quantity_label.hpp"
#include "app/write_table.hpp"
#include "markup.hpp"
#include "synthetic.hpp"

using namespace shellback;

namespace {

std::string table(const bearing::Result& result) {
  std::ostringstream out;
  app::write_table(out, test::synthetic_case(), result);
  return out.str();
}

std::string comparison_table(const bearing::Comparison& comparison) {
  std::ostringstream out;
  app::write_comparison_table(out, test::synthetic_case(), comparison);
  return out.str();
}

}  // namespace

TEST_CASE("ValuesAreShownInEngineeringUnits") {
  CHECK(app::display_unit("h_min", "m")(2.5e-6) == Approx(2.5));
  CHECK(app::display_unit("p_max", "Pa")(59.6e6) == Approx(59.6));
  CHECK(app::display_unit("T_shaft", "K")(373.15) == Approx(100.0));
  CHECK(app::display_unit("side_flow", "m3/s")(1e-3 / 60.0) == Approx(1.0));
  CHECK(app::display_unit("attitude_angle", "rad")(std::acos(-1.0)) == Approx(180.0));
  CHECK(app::display_unit("power_loss", "W", 304.0).unit == "W");
  CHECK(app::display_unit("power_loss", "W", 1304.0)(1304.0) == Approx(1.304));
}

TEST_CASE("FiguresKeepFourSignificantDigits") {
  CHECK(app::figures(59.5612) == "59.56");
  CHECK(app::figures(9.99996) == "10.00");
  CHECK(app::figures(-0.00123456) == "-0.001235");
  CHECK(app::figures(123456.0) == "123456");
  CHECK(app::figures(1.5e-7) == "1.500e-07");
  CHECK(app::figures(0.0) == "0");
  CHECK(app::figures(std::numeric_limits<double>::quiet_NaN()) == "n/a");
}

TEST_CASE("TheTableShowsEveryQuantityAndTheMeasuredDifference") {
  const auto result = test::synthetic_result();
  const std::string text = table(result);
  for (const auto& q : result.quantities) {
    CHECK(text.find(app::quantity_label(q.name)) != std::string::npos);
  }
  CHECK(text.find("-3.2 %") != std::string::npos);  // 0.968 against 1.00
  CHECK(text.find("+1.0 K") != std::string::npos);  // 99 degC against 98 degC
  CHECK(text.find("audit") != std::string::npos);
  CHECK(text.find("Newton steps rejected, 2 times") != std::string::npos);
  CHECK(text.find("flooded edges") != std::string::npos);
}

TEST_CASE("TheTableIsAscii") {
  for (const char c : comparison_table(test::synthetic_comparison())) {
    REQUIRE(static_cast<unsigned char>(c) < 0x80);
  }
}

TEST_CASE("AnUnconvergedTableSaysSoAboveAndBelow") {
  const std::string text = table(test::not_converged(test::synthetic_result()));
  CHECK(test::count(text, "*** tehd: NOT CONVERGED: iteration limit ***") == 2);
  CHECK(text.find("cure:   try a finer grid or a lower load") != std::string::npos);
  CHECK(text.find("NOT CONVERGED") < text.find("friction torque"));
  CHECK(table(test::synthetic_result()).find("NOT CONVERGED") == std::string::npos);
}

TEST_CASE("AnUnconvergedTierIsMarkedInTheComparison") {
  auto comparison = test::synthetic_comparison();
  comparison.results[1] = test::not_converged(comparison.results[1]);
  const std::string text = comparison_table(comparison);
  CHECK(text.find("thd (FAILED)") != std::string::npos);
  CHECK(test::count(text, "*** thd: NOT CONVERGED") == 2);
}

TEST_CASE("TheSplitShowsWhatItLeavesUnexplained") {
  auto comparison = test::synthetic_comparison();
  CHECK(comparison_table(comparison).find("not accounted for") == std::string::npos);
  comparison.split.steps.pop_back();  // 0.013 N m of 1.16 N m are missing
  CHECK(comparison_table(comparison).find("not accounted for") != std::string::npos);
}

TEST_CASE("WhyNoTemperatureHasTheFullFrictionIsTold") {
  bearing::Comparison c = test::synthetic_comparison();
  const auto told = [&](bearing::Calibration at, const std::string& words) {
    c.calibration = at;
    return comparison_table(c).find(words) != std::string::npos;
  };
  const double K = 273.15;
  CHECK(told({NAN, K + 40.0, K + 104.0, 0.2, 0.9},  // the full torque is 0.968
             "from 40.00 to 104.0 degC the isothermal torque is 0.2000 to 0.9000 N m\n"));
  CHECK(told({NAN, K + 60.0, K + 104.0, -0.9, -0.2},
             "60.00 to 104.0 degC the isothermal torque is 0.2000 to 0.9000 N m; beyond, no film"));
  CHECK(told({NAN, K + 60.0, K + 68.0, 0.8, 1.2}, "0.8000 to 1.200 N m and jumps past it\n"));
  CHECK(told({}, "isothermal, the film's mean temperature has no solution\n"));
}

TEST_CASE("TiersThatAppearTwiceAreNumbered") {
  auto comparison = test::synthetic_comparison();
  comparison.results.push_back(comparison.results.front());
  const auto names = app::column_names(comparison.results);
  CHECK(names == std::vector<std::string>{"isothermal 1", "thd", "tehd", "isothermal 2"});
}

TEST_CASE("AnAuditFigureThatDoesNotApplyIsNotPrintedAsANumber") {
  const std::string text = table(test::synthetic_comparison().results.front());
  CHECK(text.find("energy n/a") != std::string::npos);
  CHECK(text.find("nan") == std::string::npos);
}

TEST_CASE("AnEmptyResultStillMakesATable") {
  std::ostringstream out;
  CHECK_NOTHROW(app::write_table(out, bearing::Result{}));
  CHECK_NOTHROW(app::write_comparison_table(out, bearing::Case{}, bearing::Comparison{}));
}

TEST_CASE("AForceComponentOfRoundOffIsShownAsNone") {
  auto comparison = test::synthetic_comparison();
  for (auto& q : comparison.results[0].quantities) {
    if (q.name == "load_x") q.value = 3e-12;  // of 8 kN
  }
  for (const auto& row : app::quantity_rows({}, comparison.results)) {
    if (row.name != "load_x") continue;
    CHECK(*row.values[0] == 0.0);
    CHECK(row.unit.unit == "kN");  // both components in one unit
  }
}

TEST_CASE("StepsAreShownToATenThousandthOfTheTorque") {
  const bearing::FrictionSplit split{0.287, 0.243, {}};
  CHECK(app::signed_change(split, -0.02519) == "-0.0252");
  CHECK(app::signed_change({250.0, 240.0, {}}, -9.96) == "-10.0");
}

TEST_CASE("TheTableShowsTheOperatingPointAndWhatWasChanged") {
  auto subject = test::synthetic_case();
  subject.changes = {{"operation.speed", "1500 rpm", "--set"}, {"model.tier", "\"thd\"", "--tier"}};
  std::ostringstream out;
  app::write_table(out, subject, test::synthetic_result());
  CHECK(out.str().find(app::describe_case(subject, app::Writing::plain)) != std::string::npos);
  CHECK(out.str().find("changed on the command line: operation.speed = 1500 rpm, model.tier = "
                       "thd") != std::string::npos);
}

TEST_CASE("ABarBeyondTheToleranceIsToldWithACommand") {
  auto subject = test::synthetic_case();
  subject.path = "case.toml";
  auto result = test::synthetic_result();
  const auto told = [&](double relative) {
    for (auto& q : result.quantities) q.error_grid = relative * std::abs(q.value);
    std::ostringstream out;
    app::write_table(out, subject, result);
    return out.str();
  };
  CHECK(told(0.5 * subject.model.tolerance).find("model.tolerance") == std::string::npos);
  const std::string text = told(2.0 * subject.model.tolerance);
  CHECK(text.find("model.tolerance (1 %) is not met: friction torque +-2.0 %") !=
        std::string::npos);
  // Twice the bar, first order: twice the cells in each direction.
  CHECK(text.find("shellback run case.toml --set model.grid=\"[400,50]\"") != std::string::npos);
}

TEST_CASE("NodesThatMakeTheBarAreProposedOnTheGridThatWasAskedFor") {
  auto subject = test::synthetic_case();
  subject.path = "case.toml";
  auto result = test::synthetic_result();
  const auto told = [&](double nodes) {
    for (auto& q : result.quantities) {
      q.error_grid = 2.0 * subject.model.tolerance * std::abs(q.value);
      q.error_nodes = nodes * q.error_grid;
    }
    std::ostringstream out;
    app::write_table(out, subject, result);
    return out.str();
  };
  subject.changes = {{"model.grid", "[200,25]", "--set"}};
  const std::string more = std::to_string(subject.model.film_nodes + 2);
  CHECK(told(0.75).find("shellback run case.toml --set model.grid=\"[200,25]\" --set "
                        "model.film_nodes=" +
                        more + "\n") != std::string::npos);
  // Nodes that were given stay where cells are to do it.
  subject.changes = {{"model.film_nodes", "7", "--set"}};
  CHECK(told(0.0).find("shellback run case.toml --set model.film_nodes=7 --set "
                       "model.grid=\"[400,50]\"") != std::string::npos);
}

TEST_CASE("AWarningOfSomeTiersNamesThem") {
  auto comparison = test::synthetic_comparison();
  REQUIRE(comparison.results.size() > 1);
  for (auto& r : comparison.results) r.warnings = {std::string("of all")};
  comparison.results.back().warnings.emplace_back(std::string("of one"));
  std::ostringstream out;
  app::write_comparison_table(out, test::synthetic_case(), comparison);
  const std::string text = out.str();
  CHECK(text.find("  - of all\n") != std::string::npos);
  CHECK(text.find("of all", text.find("  - of all\n") + 5) == std::string::npos);  // once
  CHECK(text.find(std::string("  - ") + to_string(comparison.results.back().tier) + ": of one\n") !=
        std::string::npos);
}

TEST_CASE("ALastIterateShowsNoTemperatureThatNoOilHas") {
  auto result = test::not_converged(test::synthetic_result());
  for (auto& q : result.quantities) {
    if (q.name == "T_film_max") q.value = 249772.0;
  }
  CHECK(table(result).find("2494") == std::string::npos);
}

TEST_CASE("AComparisonNamesTheTierThatMeetsTheTolerance") {
  auto subject = test::synthetic_case();
  subject.path = "case.toml";
  auto comparison = test::synthetic_comparison();
  for (auto& result : comparison.results) {
    const bool full = result.tier == bearing::Tier::tehd;
    for (auto& q : result.quantities) {
      q.error_grid = 0.1 * subject.model.tolerance * std::abs(q.value);
      if (!full) q.error_model = 0.3 * std::abs(q.value);
    }
  }
  std::ostringstream out;
  app::write_comparison_table(out, subject, comparison);
  CHECK(out.str().find("most of it the physics left out") != std::string::npos);
  CHECK(out.str().find("tehd meets it:\n  shellback run case.toml --tier tehd") !=
        std::string::npos);
}
