// The chart on coarse grids: its rows, and errors that fall as grids grow finer. Nothing is timed.
#include "validation/chart/chart.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bearing/steady/solve.hpp"
#include "core/contract.hpp"
#include "fidelity/solve_case.hpp"
#include "validation/chart/chart_csv.hpp"
#include "validation/chart/chart_picture.hpp"
#include "validation/chart/chart_scenes.hpp"

using namespace shellback;
using namespace shellback::validation;

namespace {

ChartOptions coarse() {
  ChartOptions o;
  o.grids.ladder = {{24, 5}, {48, 9}};
  o.grids.compared = {{24, 5}};
  o.grids.reference = {{{40, 8}, {80, 16}, {160, 32}}};
  o.repeats = 1;
  o.tolerances = {0.1};
  return o;
}

int count(const ChartScene& s, ChartFamily family) {
  return static_cast<int>(std::count_if(s.points.begin(), s.points.end(), [&](const ChartPoint& p) {
    return p.setting.family == family && p.verdict.good();
  }));
}

int lines(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("ReferenceIsExtrapolatedOnlyWhereSecondOrderShows") {
  const auto f = [](double h) { return 3.0 + 2.0 * h * h; };
  const ReferenceValue r = reference_value(f(0.4), f(0.2), f(0.1));
  CHECK(r.extrapolated);
  CHECK(r.value == Approx(3.0).epsilon(1e-12));
  CHECK(r.uncertainty < 1e-12);
  const ReferenceValue first = reference_value(3.4, 3.2, 3.1);  // first order
  CHECK_FALSE(first.extrapolated);
  CHECK(first.value == 3.1);
  CHECK(first.uncertainty == Approx(0.1));
  const ReferenceValue wild = reference_value(1.0, 2.0, 1.5);
  CHECK(wild.uncertainty == Approx(0.5));
}

TEST_CASE("UncertaintyOfAReferenceCoversAHigherOrderRest") {
  const auto f = [](double h) { return 1.0 + h * h + 3.0 * h * h * h * h; };
  const ReferenceValue r = reference_value(f(0.2), f(0.1), f(0.05));
  REQUIRE(r.extrapolated);
  CHECK(std::abs(r.value - 1.0) < r.uncertainty);
}

TEST_CASE("ChartOfAnIsothermalSceneHasItsRowsAndFallingErrors") {
  const ChartScene s = chart_scene("raimondi-boyd", chart_case("raimondi-boyd"), coarse());
  REQUIRE(s.verdict.good());
  CHECK(count(s, ChartFamily::grid) == 2);
  CHECK(count(s, ChartFamily::cavitation) == 3);
  CHECK(count(s, ChartFamily::tier) == 1);  // the estimate
  CHECK(count(s, ChartFamily::automatic) == 1);
  CHECK(count(s, ChartFamily::layers) == 0);
  CHECK(s.points[1].error[0] < 0.5 * s.points[0].error[0]);
  CHECK(s.points[1].error[1] < 0.5 * s.points[0].error[1]);
  CHECK(std::isnan(s.points[0].error[2]));  // one temperature throughout
  for (const ChartPoint& p : s.points) {
    if (p.setting.mark != "FB") continue;  // the same equations: the same error
    CHECK(p.error[0] == Approx(s.points[0].error[0]).epsilon(1e-4));
  }
  CHECK(s.points.back().setting.family == ChartFamily::automatic);
  CHECK(s.points.back().error[0] < 0.1);  // its tolerance
  CHECK(s.points.back().value != s.points[0].value);
  CHECK(lines(chart_csv({s})) == 2 + static_cast<int>(s.points.size()));
}

TEST_CASE("ChartOfAThermalSceneComparesNodesLayersMeanAndTiers") {
  ChartOptions o = coarse();
  o.grids.ladder = {{24, 5}};
  const ChartScene s = chart_scene("hot", chart_case("hot-plain-bearing"), o);
  REQUIRE(s.verdict.good());
  CHECK(count(s, ChartFamily::nodes) >= 2);  // three nodes may be too few
  CHECK(count(s, ChartFamily::layers) == 3);
  CHECK(count(s, ChartFamily::mean) == 1);
  CHECK(count(s, ChartFamily::tier) == 3);        // estimate, isothermal, lumped
  CHECK(count(s, ChartFamily::cavitation) == 2);  // Swift-Stieber has no heat balance
  for (const ChartPoint& p : s.points) {
    if (p.setting.family == ChartFamily::layers) CHECK(p.error[2] < 5.0);
  }
}

TEST_CASE("ChartOfALoadCycleVariesGridsAndSteps") {
  ChartOptions o = coarse();
  o.of_cycles.ladder = {{20, 4}, {40, 8}};
  o.of_cycles.compared = {{40, 8}};
  o.of_cycles.reference = {{{20, 4}, {40, 8}, {80, 16}}};
  const ChartScene s = chart_scene("cycle", chart_case("flores-slider-crank"), o);
  REQUIRE(s.verdict.good());
  CHECK(count(s, ChartFamily::grid) == 2);
  CHECK(count(s, ChartFamily::steps) == 3);  // the case's own tolerance is that of the grids
  CHECK(count(s, ChartFamily::tier) == 1);
  CHECK(count(s, ChartFamily::cavitation) == 0);  // methods to compare with know no time
  CHECK(count(s, ChartFamily::automatic) == 1);
  CHECK(s.points[1].error[0] < 0.5 * s.points[0].error[0]);  // a grid twice as fine
  CHECK(std::isnan(s.points[0].error[2]));
  CHECK(s.floor[0] > 0.0);
  const auto of_steps = [&](const char* mark) {
    const auto p = std::find_if(s.points.begin(), s.points.end(), [&](const ChartPoint& x) {
      return x.setting.family == ChartFamily::steps && x.setting.mark == mark;
    });
    REQUIRE(p != s.points.end());
    return *p;
  };
  // Shorter steps solve more matrices and come nearer to the grid's own cycle in time.
  CHECK(of_steps("0.3 %").factorizations > of_steps("10 %").factorizations);
  for (const int q : {0, 1}) {  // and each keeps the tolerance that it was asked for
    const double settled = of_steps("0.3 %").value[q];
    CHECK(of_steps("3 %").value[q] == Approx(settled).epsilon(0.03));
    CHECK(of_steps("10 %").value[q] == Approx(settled).epsilon(0.1));
  }
}

TEST_CASE("FailuresAreChartedByName") {
  ChartOptions o = coarse();
  o.grids.ladder = {{48, 7}};
  o.grids.compared = {{48, 7}};
  const ChartScene s = chart_scene("soft", chart_case("ks-rig-80kN"), o);
  REQUIRE(s.verdict.good());
  int failed = 0;
  for (const ChartPoint& p : s.points) {
    if (p.setting.family != ChartFamily::elastic) continue;
    ++failed;
    CHECK_FALSE(p.verdict.good());
    CHECK(std::isnan(p.error[0]));
    CHECK_FALSE(p.on_front[0]);
  }
  CHECK(failed == 2);
  CHECK(count(s, ChartFamily::automatic) == 0);  // it would add heat, which the scene leaves out
  CHECK(chart_csv({s}).find("the fixed point between film and displacement") != std::string::npos);
  CHECK(chart_svg({s}).find("Aitken") != std::string::npos);
}

TEST_CASE("StoppedChartsKeepWhatIsFinished") {
  std::atomic<bool> stop{false};
  ChartOptions o = coarse();
  o.stop = &stop;
  o.tell = [&](const std::string&, int done, int) { stop = done >= 2; };
  const ChartScene s = chart_scene("raimondi-boyd", chart_case("raimondi-boyd"), o);
  CHECK(s.verdict.status == Status::interrupted);
  CHECK(s.points.size() == 1);
}

TEST_CASE("AnUnknownSceneIsRefusedWithTheKnownOnes") {
  CHECK_THROWS_WITH(static_cast<void>(chart_case("raimondi-bod")),
                    Catch::Contains("raimondi-boyd"));
}

TEST_CASE("TheBarOfAFilmAtASharpEdgeHoldsFourTimesAsManyCellsAlong") {
  // The film falls by the same amount whenever the cells at the edge are halved: the change to
  // cells four times as fine is no limit yet, and the bar must reach beyond it (docs/decisions/040:
  // 0.27 um).
  bearing::Case c = chart_case("ks-rig-80kN");
  c.model.grid = {200, 25};
  const bearing::Result coarse = fidelity::solve_case(c);
  c.model.grid = {200, 97};
  const bearing::Solution fine = solve_tier(c, bearing::Tier::isothermal);
  REQUIRE(coarse.verdict.good());
  REQUIRE(fine.verdict.good());
  const auto h_min = std::find_if(coarse.quantities.begin(), coarse.quantities.end(),
                                  [](const auto& q) { return q.name == "h_min"; });
  REQUIRE(h_min != coarse.quantities.end());
  CHECK(h_min->value - fine.film.least.h > 0.02e-6);
  CHECK(h_min->value - h_min->error_grid < 0.27e-6);
  CHECK(h_min->value - h_min->error_grid > 0.2e-6);  // and says something
}
