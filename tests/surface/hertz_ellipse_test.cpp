#include "surface/hertz_ellipse.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "surface/contact_curve.hpp"

using namespace shellback;
using namespace shellback::surface;

namespace {

/// Sinking of a half space of E* = 1 at (x, y) under the pressure sqrt(1 - x^2 - y^2/b^2) on the
/// ellipse with half axes 1 and b: Boussinesq's integral in polar coordinates around the point, its
/// radial part, over the chord, in closed form.
double sinking(double x, double y, double b) {
  constexpr int kRays = 20000;  // the integrand is periodic and smooth: exact for b >= 0.01
  double sum = 0.0;
  for (int k = 0; k < kRays; ++k) {
    const double c = std::cos(kPi * k / kRays), s = std::sin(kPi * k / kRays);
    const double square = c * c + s * s / (b * b);
    const double linear = x * c + y * s / (b * b);
    const double here = 1.0 - x * x - y * y / (b * b);
    sum += 0.5 * kPi * (here + linear * linear / square) / std::sqrt(square);
  }
  return sum / kRays;
}

}  // namespace

TEST_CASE("APressedEllipseIsThatOfBoussinesqsIntegral") {
  for (const double b : {0.999, 0.7, 0.2, 0.03}) {
    const double deep = sinking(0.0, 0.0, b);
    const double x = 0.5, y = 0.5 * b;  // the surface is a paraboloid within the ellipse
    const double kx = 2.0 * (deep - sinking(x, 0.0, b)) / (x * x);
    const double ky = 2.0 * (deep - sinking(0.0, y, b)) / (y * y);
    const double force = 2.0 / 3.0 * kPi * b;
    INFO("b/a = " << b << ", curvatures " << ky / kx);
    CHECK(4.0 / 3.0 * hertz_factor(kx, ky) * std::pow(deep, 1.5) == Approx(force).epsilon(2e-6));
    CHECK(hertz_factor(ky, kx) == hertz_factor(kx, ky));
  }
  CHECK(hertz_factor(4.0, 4.0) == Approx(0.5).epsilon(1e-9));  // sphere: root of the radius
  CHECK(sphere_alike(4.0, 4.0) == Approx(0.25).epsilon(1e-9));
}

TEST_CASE("SummitsWithALayPressAsTheSphereThatStandsForThem") {
  // Alike but for their heights, all along one direction, whichever: the sum over pairs is the
  // formula. 2000 quantiles of the heights: 1 % at the summits' mean and one deviation above.
  const auto curve = [](double turned, const Curvature& k) {
    const double c = std::cos(turned), s = std::sin(turned);
    const Curvature at{k.xx * c * c + k.yy * s * s, k.xx * s * s + k.yy * c * c,
                       (k.xx - k.yy) * c * s};
    std::vector<Summit> summits;
    for (int n = 0; n < 2000; ++n) {
      const double q = (n + 0.5) / 2000.0;
      double low = -8.0, high = 8.0;
      for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(-middle / std::sqrt(2.0)) < q ? low : high) = middle;
      }
      summits.push_back({0.2e-6 * low, at});
    }
    const HeightMap map{402, 402, 1e-6, 1e-6, std::vector<double>(402 * 402, 0.0)};
    const SummitStatistics one = statistics_of(summits, map);
    return contact_curve(map, summits, one, {0.0, 0.28e-6});
  };
  const Curvature sharp{9.0 / 90e-6, 1.0 / 90e-6, 0.0};
  const double angle = 0.7;
  const auto rows = curve(0.0, sharp), turned = curve(angle, sharp),
             across = curve(0.5 * kPi, sharp);
  // Face to face the lays of two surfaces like one another are mirrored: turned by an angle on
  // each they cross at twice that, and the curvature xy of the two cancels.
  const double c = std::cos(angle), s = std::sin(angle);
  const double xx = 2.0 * (sharp.xx * c * c + sharp.yy * s * s);
  const double yy = 2.0 * (sharp.xx * s * s + sharp.yy * c * c);
  const double crossed = std::sqrt(xx * yy / (4.0 * sharp.determinant())) * hertz_factor(xx, yy) /
                         hertz_factor(2.0 * sharp.xx, 2.0 * sharp.yy);
  for (int k = 0; k < 2; ++k) {
    CHECK(rows[k].pair_summits == Approx(rows[k].pair_formula).epsilon(0.01));
    CHECK(across[k].pair_summits == Approx(rows[k].pair_summits).epsilon(1e-9));
    CHECK(turned[k].pair_summits == Approx(crossed * rows[k].pair_summits).epsilon(1e-9));
    CHECK(turned[k].plane_summits == Approx(rows[k].plane_summits).epsilon(1e-9));
  }
  // Spheres of the mean curvature are too soft, by the factors of a pressed ellipse of 9 to 1.
  const double mean = 5.0 / 90e-6;
  const auto round = curve(0.0, {mean, mean, 0.0});
  CHECK(rows[0].plane_summits / round[0].plane_summits ==
        Approx(hertz_factor(sharp.xx, sharp.yy) * std::sqrt(mean)).epsilon(1e-9));
  CHECK(rows[0].pair_summits > 2.0 * round[0].pair_summits);
}
