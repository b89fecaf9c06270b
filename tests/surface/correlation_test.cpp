#include "surface/correlation.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/constants.hpp"
#include "surface/gaussian_surface.hpp"

using namespace shellback;
using namespace shellback::surface;

TEST_CASE("LengthsAndOrientationOfAGeneratedSurfaceComeBack") {
  // About N = A/(2.27 * 4 * 12) = 1500 independent areas: lengths scatter by some 5 % (measured
  // over 20 seeds: 3 %), three times that is allowed.
  for (const auto shape : {CorrelationShape::smooth, CorrelationShape::linear}) {
    const HeightMap map = gaussian_surface({512, 320, 1e-6, 1e-6, 1e-7, 12e-6, 4e-6, shape, 4});
    const Correlation c = correlation_of(map);
    CHECK(c.along.length == Approx(12e-6).epsilon(0.15));
    CHECK(c.across.length == Approx(4e-6).epsilon(0.15));
    CHECK(c.gamma == Approx(3.0).epsilon(0.15));
    CHECK(std::abs(c.lay) < 10.0 * kPi / 180.0);
    CHECK_FALSE(c.bounded());
  }
}

TEST_CASE("ExchangedAxesHaveTheReciprocalGamma") {
  const HeightMap map = gaussian_surface({200, 160, 1e-6, 2e-6, 1e-7, 12e-6, 8e-6});
  const Correlation a = correlation_of(map), b = correlation_of(exchanged(map));
  CHECK(a.gamma * b.gamma == Approx(1.0).epsilon(1e-9));  // the same sums: round-off of the FFT
  CHECK(a.independent == Approx(b.independent).epsilon(0.1));  // searched in whole degrees
}

TEST_CASE("TheLayOfRidgesIsTheirDirection") {
  // Plane waves whose crests run at 30 degrees, with a short second wave that lets R fall along
  // them.
  const double angle = kPi / 6.0;
  HeightMap map{300, 300, 1e-6, 1e-6, {}};
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) {
      const double across = -i * std::sin(angle) + j * std::cos(angle);
      const double along = i * std::cos(angle) + j * std::sin(angle);
      map.z.push_back(std::sin(2.0 * kPi * across / 13.0) * std::sin(2.0 * kPi * along / 90.0));
    }
  }
  CHECK(correlation_of(map).lay == Approx(angle).margin(3.0 * kPi / 180.0));
}

TEST_CASE("GroovesLongerThanThePatchGiveALowerBound") {
  HeightMap map{64, 128, 1e-6, 1e-6, {}};
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) map.z.push_back(std::sin(2.0 * kPi * j / 16.0));
  }
  const Correlation c = correlation_of(map);
  CHECK(c.along.at_least);
  CHECK_FALSE(c.across.at_least);
  CHECK(c.bounded());
}

TEST_CASE("TheLayOfGroovesLongerThanThePatchIsTheirDirection") {
  for (const double angle : {0.0, 30.0, 90.0, 160.0}) {
    HeightMap map{128, 128, 1e-6, 1e-6, {}};
    const double turn = angle * kPi / 180.0;
    for (int j = 0; j < map.ny; ++j) {
      for (int i = 0; i < map.nx; ++i) {
        const double across = -i * std::sin(turn) + j * std::cos(turn);
        map.z.push_back(std::sin(2.0 * kPi * across / 16.0));
      }
    }
    const double off = std::remainder(correlation_of(map).lay - turn, kPi);
    CHECK(std::abs(off) < 0.5 * kPi / 180.0);  // searched in whole degrees, these are among them
  }
}

TEST_CASE("ThereAreNoMoreIndependentHeightsThanPoints") {
  std::mt19937 random(7);
  std::normal_distribution<double> height(0.0, 1e-7);
  HeightMap map{64, 64, 1e-6, 1e-6, {}};
  for (int k = 0; k < map.nx * map.ny; ++k) map.z.push_back(height(random));
  const Correlation c = correlation_of(map);  // white noise: each point is one
  CHECK(c.independent <= 64.0 * 64.0);
  CHECK(c.independent > 0.5 * 64.0 * 64.0);
}

TEST_CASE("TheErrorOfRqIsItsScatterOverManyPatches") {
  // 60 patches of about 44 independent areas: relative scatter of Rq against 1/sqrt(2 N). The
  // scatter itself is known to 9 %, N (from patches this small) to about 30 %.
  constexpr int kPatches = 60;
  double sum = 0.0, squares = 0.0, told = 0.0;
  for (int k = 0; k < kPatches; ++k) {
    const HeightMap map =
        gaussian_surface({80, 80, 1.0, 1.0, 1.0, 8.0, 8.0, CorrelationShape::smooth,
                          100U + static_cast<unsigned>(k)});
    double m2 = 0.0;
    for (const double z : map.z) m2 += z * z / static_cast<double>(map.z.size());
    sum += std::sqrt(m2) / kPatches;
    squares += m2 / kPatches;
    told += correlation_of(map).error_of_Rq(3.0) / kPatches;
  }
  const double scatter = std::sqrt(squares - sum * sum) / sum;
  CHECK(told == Approx(scatter).epsilon(0.4));
}

TEST_CASE("TheErrorOfRqGrowsWithTheKurtosis") {
  // Flat patches with pits, one in ten areas of 8 x 8 points: the part that is pits scatters by the
  // root of their number. N is known to a factor of 1.5, the scatter of 60 patches to 9 %; Gaussian
  // heights of as many areas scatter 2.7 times less.
  constexpr int kPatches = 60, kSide = 80, kPit = 8, kAreas = kSide / kPit;
  std::mt19937 random(7);
  std::bernoulli_distribution pitted(0.1);
  double sum = 0.0, squares = 0.0, told = 0.0;
  for (int k = 0; k < kPatches; ++k) {
    HeightMap map{kSide, kSide, 1.0, 1.0, std::vector<double>(kSide * kSide, 0.0)};
    double mean = 0.0, m2 = 0.0, m4 = 0.0;
    for (int area = 0; area < kAreas * kAreas; ++area) {
      if (!pitted(random)) continue;
      const int x = kPit * (area % kAreas), y = kPit * (area / kAreas);
      for (int c = 0; c < kPit * kPit; ++c) map.z[map.index(x + c % kPit, y + c / kPit)] = -1.0;
      mean -= 1.0 / (kAreas * kAreas);
    }
    for (double& z : map.z) {
      z -= mean;
      m2 += z * z / (kSide * kSide);
      m4 += z * z * z * z / (kSide * kSide);
    }
    sum += std::sqrt(m2) / kPatches;
    squares += m2 / kPatches;
    told += correlation_of(map).error_of_Rq(m4 / (m2 * m2)) / kPatches;
  }
  const double scatter = std::sqrt(squares - sum * sum) / sum;
  CHECK(told == Approx(scatter).epsilon(0.4));
}

TEST_CASE("PatchSizesAndErrorsBelongTogether") {
  CHECK(independent_areas_for(0.1, 3.0) == Approx(50.0));
  CHECK(lengths_for(50.0) == Approx(10.6).epsilon(0.01));  // sqrt(2.2662 * 50)
}
