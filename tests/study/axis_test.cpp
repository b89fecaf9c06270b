/// Values of an axis.
#include "app/study/axis.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace shellback::study;

TEST_CASE("ALogarithmicAxisHasEqualRatiosAndItsEnds") {
  const Axis axis = spaced_axis("operation.speed", 3000.0, 50.0, 30, Spacing::logarithmic, "rpm");
  REQUIRE(axis.size() == 30);
  CHECK(axis.numbers.front() == 3000.0);
  CHECK(axis.numbers.back() == 50.0);
  const double ratio = std::pow(50.0 / 3000.0, 1.0 / 29.0);
  for (int k = 1; k < 30; ++k) {
    // Values are rounded to ten figures.
    CHECK(axis.numbers[k] / axis.numbers[k - 1] == Approx(ratio).epsilon(1e-9));
  }
  CHECK(axis.words.front() == "3000 rpm");
}

TEST_CASE("ALinearAxisHasEqualDifferencesWithoutRoundOffInItsWords") {
  const Axis axis = spaced_axis("operation.eccentricity_ratio", 0.1, 0.9, 9, Spacing::linear, "");
  CHECK(axis.words[2] == "0.3");
  CHECK(axis.words[7] == "0.8");
}

TEST_CASE("ANumberBetweenTwoValuesIsTheirMean") {
  const Axis linear = spaced_axis("k", 10.0, 20.0, 2, Spacing::linear, "degC");
  CHECK(word_at(linear, 0.5) == "15 degC");
  const Axis logarithmic = spaced_axis("k", 10.0, 40.0, 2, Spacing::logarithmic, "N");
  CHECK(word_at(logarithmic, 0.5) == "20 N");
  // The coordinate grows evenly with the index on both.
  for (const Axis& axis : {linear, logarithmic}) {
    CHECK(2.0 * coordinate(axis, 0.5) ==
          Approx(coordinate(axis, 0.0) + coordinate(axis, 1.0)).epsilon(1e-12));
  }
}

TEST_CASE("ListedNumbersOverAWideRangeCountByTheirRatio") {
  CHECK(is_logarithmic(listed_axis("k", {1.0, 10.0, 100.0}, "N")));
  CHECK_FALSE(is_logarithmic(listed_axis("k", {10.0, 11.0}, "N")));
  CHECK_FALSE(is_logarithmic(listed_axis("k", {-1.0, 10.0}, "N")));
  CHECK_FALSE(is_logarithmic(listed_axis("k", {1.0, 100.0}, "degC")));
}

TEST_CASE("WordsHaveNothingBetweenThem") {
  const Axis axis = word_axis("model.tier", {"thd", "tehd"});
  CHECK_FALSE(axis.has_between());
  CHECK(word_at(axis, 1.0) == "tehd");
}
