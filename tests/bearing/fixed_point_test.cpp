#include "core/fixed_point.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "bearing/over_time/led_oil.hpp"
#include "core/extrapolation.hpp"

using namespace shellback::bearing;

namespace {

/// x -> A x + b with one stiff direction: plain iteration diverges, eigenvalues 0.5 and -1.6.
bool linear(const std::vector<double>& x, std::vector<double>& g) {
  g = {0.5 * x[0] + 1.0, -1.6 * x[1] + 0.3 * x[0] + 2.0};
  return true;
}

}  // namespace

TEST_CASE("AccelerationFindsTheFixedPointOfADivergingMap", "[fixed_point]") {
  std::vector<double> x{0.0, 0.0};
  CHECK(fixed_point(linear, {3, 1, 50, 1e-10}, x) == FixedPointEnd::converged);
  CHECK(x[0] == Approx(2.0).epsilon(1e-9));  // x = 0.5 x + 1
  CHECK(x[1] == Approx(1.0).epsilon(1e-9));  // 2.6 x = 0.3 * 2 + 2
}

TEST_CASE("FixedPointOfACosineIsDotties", "[fixed_point]") {
  std::vector<double> x{0.2};
  const auto cosine = [](const std::vector<double>& a, std::vector<double>& g) {
    g = {std::cos(a[0])};
    return true;
  };
  CHECK(fixed_point(cosine, {1, 1, 50, 1e-12}, x) == FixedPointEnd::converged);
  CHECK(std::abs(x[0] - std::cos(x[0])) < 1e-11);
}

TEST_CASE("FixedPointSaysHowItEnded", "[fixed_point]") {
  std::vector<double> x{0.0, 0.0};
  CHECK(fixed_point(linear, {3, 1, 2, 1e-10}, x) == FixedPointEnd::iteration_limit);
  int calls = 0;
  const auto fails = [&](const std::vector<double>& a, std::vector<double>& g) {
    g = {0.5 * a[0] + 1.0, a[1]};
    return ++calls < 3;
  };
  CHECK(fixed_point(fails, {3, 1, 50, 1e-10}, x) == FixedPointEnd::map_failed);
  CHECK(calls == 3);
}

TEST_CASE("AMapWhoseChangesRepeatIsFollowedToItsFixedPoint", "[fixed_point]") {
  // Steps of one length: the differences of the changes, which acceleration divides by, are zero.
  std::vector<double> x{0.0, 0.0};
  const auto map = [](const std::vector<double>& from, std::vector<double>& to) {
    to = {std::min(from[0] + 1.0, 10.0), std::min(from[1] + 1.0, 10.0)};
    return true;
  };
  CHECK(fixed_point(map, {}, x) == FixedPointEnd::converged);
  CHECK(x[0] == Approx(10.0));
}

TEST_CASE("AnIterateThatIsThrownOutOfReachIsNotTried", "[fixed_point]") {
  // Steps that differ by a billionth: acceleration follows the line through two of them to where
  // it thinks they vanish, a billion steps away.
  double farthest = 0.0;
  const auto map = [&](const std::vector<double>& from, std::vector<double>& to) {
    farthest = std::max({farthest, std::abs(from[0]), std::abs(from[1])});
    to = {std::min(from[0] + 1.0 + 1e-9 * from[0], 10.0),
          std::min(from[1] + 1.0 + 1e-9 * from[1], 10.0)};
    return true;
  };
  FixedPointOptions options;
  options.reach = 5.0;
  std::vector<double> x{0.0, 0.0};
  CHECK(fixed_point(map, options, x) == FixedPointEnd::converged);
  CHECK(x[0] == Approx(10.0));
  CHECK(x[1] == Approx(10.0));
  CHECK(farthest <= 15.0);  // from the last value, at most the fixed point, no further than asked
}

TEST_CASE("IteratesOfThreeModesLeadToTheirLimit", "[fixed_point]") {
  // x = b + sum_m v_m lambda^k: a slow one, one that swings and one between them.
  const std::vector<double> limit{1.0, -2.0, 3.0, 0.5};
  const auto at = [&](double slow, double swings, double fast) {
    return std::vector<double>{limit[0] + slow + fast, limit[1] - slow + 2.0 * swings,
                               limit[2] + swings - fast, limit[3] + 0.3 * slow};
  };
  const auto from = [&](double slow, double swings, double fast) {
    return Iterate{at(slow, swings, fast), at(0.97 * slow, -0.8 * swings, 0.4 * fast)};
  };
  const auto check = [&](const std::vector<Iterate>& of) {
    const auto s = extrapolated(of);
    REQUIRE(s);
    for (std::size_t k = 0; k < 4; ++k) CHECK((*s)[k] == Approx(limit[k]).epsilon(1e-9));
  };
  std::vector<Iterate> sequence;
  for (int k = 0; k < 4; ++k) {
    sequence.push_back(from(std::pow(0.97, k), std::pow(-0.8, k), std::pow(0.4, k)));
  }
  check(sequence);
  check({from(1.0, 0.3, 0.0), from(0.2, -0.5, 1.0), from(0.6, 0.1, 0.4), from(2.0, 1.0, -1.0)});
  const Iterate there = from(0.0, 0.0, 0.0);
  CHECK_FALSE(extrapolated({there, there}));
  CHECK_FALSE(extrapolated({there, from(NAN, 0.0, 0.0)}));
}

TEST_CASE("OilThatIsLedOnComesToWhereItsCyclesLead", "[fixed_point]") {
  // Two cells that lose 3 % and 40 % of what they have too much, cycle after cycle: plain cycles
  // would need 750 of them for 1e-10.
  const std::vector<double> limit{2.0, 5.0};
  std::vector<double> oil{1.0, 4.0};
  LedOil led;
  led.begin(oil);
  int cycles = 0;
  int times = 0;
  while (std::hypot(oil[0] - limit[0], oil[1] - limit[1]) > 1e-10 && cycles < 50) {
    oil = {limit[0] + 0.97 * (oil[0] - limit[0]), limit[1] + 0.6 * (oil[1] - limit[1])};
    led.passed();
    ++cycles;
    CHECK_FALSE(led.just_led());
    if (const auto to = led.after(oil, cycles)) {
      oil = *to;
      led.led_to(oil);
      ++times;
      CHECK(led.just_led());
    }
  }
  CHECK(cycles < 12);
  CHECK(times > 0);
}
