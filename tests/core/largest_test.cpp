/// Norms of fields in which what is not a number wins, and its name and place.
#include "core/largest.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "core/not_a_number.hpp"

using namespace shellback;

namespace {
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
}

TEST_CASE("TheLargestOfNumbersIsTheirMaximum") {
  const std::vector<double> x{-7.0, 3.0, 5.0, -1.0};
  CHECK(largest(x) == 5.0);
  CHECK(largest_magnitude(x) == 7.0);
  CHECK(largest(std::vector<double>{-2.0, -3.0}) == -2.0);
  CHECK(largest_difference(x, std::vector<double>{-7.0, 3.5, 5.0, 1.0}) == 2.0);
  CHECK(largest_magnitude(std::vector<double>{}) == 0.0);
}

TEST_CASE("WhatIsNotANumberWinsWhereverItStands") {
  for (std::size_t k = 0; k < 5; ++k) {
    std::vector<double> x{4.0, -9.0, 0.0, 2.0, 1.0};
    const std::vector<double> sound = x;
    x[k] = kNaN;
    CHECK(std::isnan(largest(x)));
    CHECK(std::isnan(largest_magnitude(x)));
    CHECK(std::isnan(largest_difference(x, sound)));
    CHECK(std::isnan(largest_difference(sound, x)));
  }
  CHECK(std::isinf(largest_magnitude(std::vector<double>{1.0, -INFINITY, 2.0})));
}

TEST_CASE("ANotANumberIsToldByFieldAndCell") {
  std::vector<double> nodes(12, 1.0);  // three of each of four cells
  CHECK_FALSE(find_not_a_number(FieldName::film_temperature, nodes, 3));
  nodes[7] = kNaN;
  const auto found = find_not_a_number(FieldName::film_temperature, nodes, 3);
  REQUIRE(found);
  CHECK(found->cell == 2);
  CHECK(found->field == FieldName::film_temperature);
}
