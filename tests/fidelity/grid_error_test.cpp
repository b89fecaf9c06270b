// Laws of the error bar of the grid, on values whose limit is known.
#include "fidelity/grid_error.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "../bearing/sample_bearing.hpp"
#include "fidelity/grid_sequence.hpp"

using namespace shellback::fidelity;

namespace {

/// f0 + a h^p on grids with ratios as the solver's ladder has them: 50x7, 100x13, 200x25.
std::vector<GridValue> series(double limit, double a, double p) {
  std::vector<GridValue> values;
  for (const double cells : {350.0, 1300.0, 5000.0}) {
    const double h = 1.0 / std::sqrt(cells);
    values.push_back({h, limit + a * std::pow(h, p), 0.0});
  }
  return values;
}

GridBar grid_bar(const std::vector<GridValue>& values) {
  return grid_bar(values, values.empty() ? NAN : values.back().h);
}

}  // namespace

TEST_CASE("ValuesOfTheHighestOrderLeadToTheirLimit") {
  const auto value = [](double h) { return 3.0 - 0.4 * std::pow(h, kMostOrder); };
  const std::vector<GridValue> two{{0.2, value(0.2), 0.0}, {0.1, value(0.1), 0.0}};
  CHECK(grid_bar(two, 0.1).limit == Approx(3.0).epsilon(1e-12));
  CHECK(std::isnan(grid_bar({two.front()}, 0.2).limit));  // one grid leads nowhere
}

TEST_CASE("TheOrderOfAPureSeriesIsObservedForAnyRatioOfGrids") {
  for (const double p : {1.05, 1.25, 1.45}) {
    CHECK(observed_order(series(3.0, 7.0, p)) == Approx(p).margin(1e-6));
    CHECK(observed_order(series(3.0, -7.0, p)) == Approx(p).margin(1e-6));
  }
}

TEST_CASE("TheOrderStaysBetweenTheLowestAndTheHighestOfTheScheme") {
  CHECK(observed_order(series(3.0, 7.0, 3.0)) == kMostOrder);
  CHECK(observed_order(series(3.0, 7.0, 0.7)) == kLeastOrder);
}

TEST_CASE("ValuesThatApproachNoLimitHaveNoOrder") {
  std::vector<GridValue> swinging{{0.4, 1.0, 0.0}, {0.2, 2.0, 0.0}, {0.1, 1.5, 0.0}};
  CHECK(std::isnan(observed_order(swinging)));
  std::vector<GridValue> leaving{{0.4, 1.0, 0.0}, {0.2, 1.1, 0.0}, {0.1, 2.0, 0.0}};
  CHECK(std::isnan(observed_order(leaving)));
}

TEST_CASE("TheBarHoldsTheLimitOfEverySeriesTheSchemeCanHave") {
  for (double p = 0.9; p < 3.0; p += 0.1) {
    const auto values = series(1.0, 0.3, p);
    const double error = std::abs(values.back().value - 1.0);
    CHECK(grid_bar(values).bar >= error);
    CHECK(grid_bar({values[1], values[2]}).bar >= error);  // two grids: the lowest order
  }
}

TEST_CASE("TheBarHoldsTheLimitOfASeriesThatHardlyFalls") {
  // Slower than half the lowest order: no order is claimed, and the bar is that of kSlowOrder,
  // whose safety of 1.5 holds orders down to 0.36.
  for (double p = 0.36; p < 0.5; p += 0.02) {
    const auto values = series(1.0, 0.3, p);
    INFO(p);
    CHECK(std::isnan(observed_order(values)));
    CHECK(grid_bar(values).bar >= std::abs(values.back().value - 1.0));
  }
}

TEST_CASE("TheBarHoldsTheMiddleOfASwing") {
  // Whatever the limit is, a swing that does not grow has its last turn around it.
  const std::vector<GridValue> values{{0.4, 1.0, 0.0}, {0.2, 2.0, 0.0}, {0.1, 1.4, 0.0}};
  CHECK(grid_bar(values).bar >= 0.3);
}

TEST_CASE("OneGridGivesNoBar") {
  CHECK(std::isnan(grid_bar({{0.1, 1.0, 0.0}}).bar));
  CHECK(std::isnan(grid_bar({}).bar));
}

TEST_CASE("TheBarIsNoShorterThanTheNoiseOfTheIteration") {
  auto values = series(1.0, 0.0, 1.0);
  values.back().noise = 1e-3;
  CHECK(grid_bar(values).bar >= 1e-3);
}

TEST_CASE("BarsScaleWithTheirQuantity") {
  const auto bar = [](double scale, double shift) {
    auto values = series(1.0, 0.3, 1.4);
    for (GridValue& v : values) v.value = scale * v.value + shift;
    return grid_bar(values).bar;
  };
  CHECK(bar(-1e-6, 0.0) == Approx(1e-6 * bar(1.0, 0.0)));
  CHECK(bar(1.0, 300.0) == Approx(bar(1.0, 0.0)));
}

TEST_CASE("NoBarIsMuchShorterThanThoseOfTheSameFilm") {
  double bars[] = {1e-6, 0.1, 0.2, NAN};
  double part = 4.0;  // no witness of the film
  share_bars(
      {{&bars[0], 1.0}, {&bars[1], 1.0}, {&bars[2], 1.0}, {&bars[3], 1.0}, {&part, 1.0, true}});
  CHECK(bars[0] == Approx(0.02));  // a fifth of the middle one
  CHECK(bars[1] == 0.1);
  CHECK(bars[2] == 0.2);
  CHECK(std::isnan(bars[3]));
  part = 1e-6;
  share_bars({{&bars[1], 1.0}, {&bars[2], 1.0}, {&part, 1.0, true}});
  CHECK(part == Approx(0.04));  // and yet no better known than it
}

TEST_CASE("CoarseGridsAreTwoAtLeastAndCoarser") {
  const auto coarse_grids = [](Grid grid) {
    auto c = shellback::bearing::tests::plain_case();
    c.model.grid = grid;
    return shellback::fidelity::coarse_grids(c);
  };
  for (const Grid fine : {Grid{400, 50}, Grid{200, 25}, Grid{100, 13}, Grid{50, 7}, Grid{60, 9}}) {
    const auto grids = coarse_grids(fine);
    REQUIRE(grids.size() >= 2);
    Grid last{0, 0};
    for (const Grid& g : grids) {
      CHECK(g[0] * g[1] > last[0] * last[1]);
      CHECK(g[0] < fine[0]);
      CHECK(g[1] < fine[1]);
      last = g;
    }
  }
  CHECK(coarse_grids({20, 4}).empty());  // nothing coarser is worth a solve
}
