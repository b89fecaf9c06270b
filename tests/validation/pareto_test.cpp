// The front of known points: what no cheaper point beats.
#include "validation/chart/pareto.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace shellback::validation;

TEST_CASE("TheFrontHoldsThePointsThatNoneBeatsInBothCostAndError") {
  //                                     0         1         2         3         4
  const std::vector<CostError> points{{4, 0.1}, {1, 0.9}, {2, 0.5}, {3, 0.6}, {2, 0.4}};
  CHECK(pareto_front(points) == std::vector<int>{1, 4, 0});
}

TEST_CASE("PointsThatFailedAreOnNoFront") {
  CHECK(pareto_front({{1, NAN}, {NAN, 0.1}, {2, 0.3}}) == std::vector<int>{2});
  CHECK(pareto_front({}).empty());
}

TEST_CASE("BelowTheFloorNoPointIsBetterThanACheaperOne") {
  const std::vector<CostError> points{{1, 0.5}, {2, 0.09}, {3, 0.01}};
  CHECK(pareto_front(points, 0.1) == std::vector<int>{0, 1});
  CHECK(pareto_front(points) == std::vector<int>{0, 1, 2});
}

TEST_CASE("AGainTooSmallToBeMeantIsNotBought") {
  const std::vector<CostError> points{{1, 0.5}, {2, 0.4999}};
  CHECK(pareto_front(points) == std::vector<int>{0});
  CHECK(pareto_front(points, 0.0, 0.0) == std::vector<int>{0, 1});
}
