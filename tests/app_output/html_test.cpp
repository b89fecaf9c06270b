#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/labels/quantity_label.hpp"
#include "app/pending_file.hpp"
#include "app/pictures/svg.hpp"
#include "app/pictures/svg_comparison.hpp"
#include "app/write_html.hpp"
#include "app/write_table.hpp"
#include "core/contract.hpp"
#include "core/make_grid.hpp"
#include "markup.hpp"
#include "synthetic.hpp"
#include "tests/contains.hpp"

using namespace shellback;
using test::contains;

namespace {

std::string page(const bearing::Comparison& comparison) {
  return app::comparison_html(test::synthetic_case(), comparison);
}

}  // namespace

TEST_CASE("ThePageNeedsNothingFromOutside") {
  const std::string html = page(test::synthetic_comparison());
  for (const char* load : {"http://", "https://", "<script", "<link", "@import", "url(", "src="}) {
    CHECK_FALSE(contains(html, load));
  }
  CHECK(html.size() < 3'000'000);  // what a mail and a browser take without thought
}

TEST_CASE("ThePageIsWellFormed") {
  CHECK(test::unbalanced_tag(page(test::synthetic_comparison())) == "");
  CHECK(test::unbalanced_tag("<p><b>x</p></b>") != "");  // the check itself bites
}

TEST_CASE("ThePageHoldsEveryQuantityOfEveryResult") {
  const auto comparison = test::synthetic_comparison();
  const std::string html = page(comparison);
  for (const auto& row : app::quantity_rows({}, comparison.results)) {
    CHECK(contains(html, "data-quantity=\"" + row.name + "\""));
    for (const auto& value : row.values) {
      if (value) CHECK(contains(html, app::figures(*value)));
    }
  }
}

TEST_CASE("ThePageShowsStepsNotesAndProvenance") {
  const auto comparison = test::synthetic_comparison();
  const std::string html = page(comparison);
  for (const auto& step : comparison.split.steps) CHECK(contains(html, step.name));
  CHECK(contains(html, "Calibrated equivalent temperature 106.2 °C"));
  CHECK(contains(html, "flooded edges"));
  CHECK(contains(html, "pressure above the oil&#39;s fitted range"));
  CHECK(contains(html, "cases/ks-rig.toml"));
  CHECK(contains(html, "HDF5 "));
}

TEST_CASE("TextFromTheCaseIsEscaped") {
  const std::string html = page(test::synthetic_comparison());
  CHECK(contains(html, "KS rig, test bearing &lt;4 &amp; 8 kN&gt;"));
  CHECK_FALSE(contains(html, "<4 & 8"));
  CHECK(app::escape_markup("\"a\" < 'b' & c") == "&quot;a&quot; &lt; &#39;b&#39; &amp; c");
  CHECK(app::escape_markup("a\tb\nc\x01") == "a\tb\nc\uFFFD");  // XML 1.0, 2.2
}

TEST_CASE("AnUnconvergedResultIsAnnouncedBeforeAnyNumber") {
  auto comparison = test::synthetic_comparison();
  CHECK_FALSE(contains(page(comparison), "NOT CONVERGED"));
  comparison.results.back() = test::not_converged(comparison.results.back());
  const std::string html = page(comparison);
  CHECK(html.find("NOT CONVERGED: iteration limit") < html.find("N·m"));
  CHECK(contains(html, "Film pressure, tehd (NOT CONVERGED)"));
  CHECK(contains(html, "tehd (not converged)"));
  CHECK(contains(html, "try a finer grid or a lower load"));
  CHECK_FALSE(contains(html, "results converged."));
}

TEST_CASE("TiersWithoutFieldsDoNotBreakThePage") {
  auto comparison = test::synthetic_comparison();
  for (auto& result : comparison.results) result.fields = {};
  comparison.split = {};
  comparison.calibration = {};
  const std::string html = page(comparison);
  CHECK(test::unbalanced_tag(html) == "");
  CHECK_FALSE(contains(html, "<figure>"));
  CHECK(test::unbalanced_tag(page({})) == "");
}

TEST_CASE("AFieldWithNotANumberIsRefusedInWords") {
  auto comparison = test::synthetic_comparison();
  comparison.results.back() = test::not_converged(comparison.results.back());
  auto& f = comparison.results.back().fields;
  f.p[77] = std::numeric_limits<double>::quiet_NaN();
  f.T[10] = std::numeric_limits<double>::infinity();
  f.T_solid[3] = std::numeric_limits<double>::quiet_NaN();
  f.T_mean.assign(f.T_mean.size(), std::numeric_limits<double>::quiet_NaN());
  const std::string html = page(comparison);
  CHECK(contains(html, "not drawn: the field holds values that are not numbers"));
  for (const char* number :
       {"\"nan", " nan", "Lnan", "Mnan", ">nan", "\"inf", " inf", "Linf", ">inf"}) {
    CHECK_FALSE(contains(html, number));
  }
}

TEST_CASE("AnUncrossedAxisOrSingleAxialCellStillDraws") {
  auto comparison = test::synthetic_comparison();
  auto& result = comparison.results.back();
  comparison.results = {result};
  auto& f = comparison.results[0].fields;
  f = {};
  f.grid = make_grid(0.02, 0.01, 20, 1, false);
  f.p.assign(20, 0.0);  // a constant field
  f.h.assign(20, 1e-5);
  f.theta.assign(20, 1.0);
  CHECK(test::unbalanced_tag(page(comparison)) == "");
}

TEST_CASE("PageAndPictureAreWrittenOrRefused") {
  const test::ScratchFile html("page.html");
  const test::ScratchFile picture("picture.svg");
  const auto comparison = test::synthetic_comparison();
  app::write_file(html.path(), page(comparison));
  app::write_file(picture.path(), app::comparison_svg(test::synthetic_case(), comparison));
  CHECK(test::file_text(html.path()) == page(comparison));
  const std::string svg = test::file_text(picture.path());
  CHECK(test::unbalanced_tag(svg) == "");
  CHECK(test::count(svg, "http") == 1);  // the name of the SVG namespace
  CHECK_FALSE(contains(svg, "var(--"));  // fixed colours: viewers need not know CSS variables
  CHECK_THROWS_AS(app::write_file("/nowhere/at/all.svg",
                                  app::comparison_svg(test::synthetic_case(), comparison)),
                  FileError);
}

TEST_CASE("ThePageGivesTheDifferenceOfTheTable") {
  const auto comparison = test::synthetic_comparison();
  std::ostringstream table;
  app::write_comparison_table(table, test::synthetic_case(), comparison);
  const std::string percent = app::difference({}, comparison.split.to, comparison.split.from);
  CHECK(contains(table.str(), percent));
  CHECK(
      contains(page(comparison), "The difference is <b>" + app::typeset_number(percent) + "</b>"));
}

TEST_CASE("ThePageSaysWhichResultsTheirBarsLeaveOpen") {
  auto comparison = test::synthetic_comparison();
  CHECK_FALSE(contains(page(comparison), "Cannot be told apart"));  // without bars nothing is said
  for (auto& result : comparison.results) {
    for (auto& q : result.quantities) q.error_grid = std::abs(q.value);
  }
  const std::string html = page(comparison);
  CHECK(contains(html, "Cannot be told apart"));
  CHECK(contains(html, "model.tolerance"));
  CHECK(contains(html, "<code>shellback compare"));
  CHECK(test::unbalanced_tag(html) == "");
}

TEST_CASE("ThePageShowsWhatTheCommandLineChanged") {
  auto subject = test::synthetic_case();
  subject.changes = {{"operation.speed", "\"1500 rpm\"", "--set"}};
  CHECK(contains(app::comparison_html(subject, test::synthetic_comparison()),
                 "changed on the command line: operation.speed = 1500 rpm"));
}
