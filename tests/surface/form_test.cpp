#include "surface/form.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "core/contract.hpp"
#include "surface/gaussian_surface.hpp"
#include "surface/holes.hpp"

using namespace shellback;
using namespace shellback::surface;

namespace {

constexpr double kHole = std::numeric_limits<double>::quiet_NaN();

/// 2 um + 3e-3 x - 1e-3 y + 40 1/m x^2/2, x and y from the middle.
HeightMap curved_plane() {
  HeightMap map{60, 40, 1e-6, 2e-6, {}};
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) {
      const double x = (i + 0.5) * map.dx - 0.5 * map.length();
      const double y = (j + 0.5) * map.dy - 0.5 * map.width();
      map.z.push_back(2e-6 + 3e-3 * x - 1e-3 * y + 20.0 * x * x);
    }
  }
  return map;
}

}  // namespace

TEST_CASE("FormAndTiltAreFoundAndLeaveNothing") {
  const Levelled left = remove_form(curved_plane(), 2);
  CHECK(left.form.slope_x == Approx(3e-3).epsilon(1e-9));
  CHECK(left.form.slope_y == Approx(-1e-3).epsilon(1e-9));
  CHECK(left.form.curvature_x == Approx(40.0).epsilon(1e-9));
  CHECK(std::abs(left.form.curvature_y) < 1e-6);
  // 20 x^2 over half the length of 59 pitches between the outermost points.
  CHECK(left.form.peak_to_valley == Approx(20.0 * (29.5 * 29.5 - 0.25) * 1e-12).epsilon(1e-6));
  for (const double z : left.map.z) CHECK(std::abs(z) < 1e-18);
}

TEST_CASE("WhatIsRemovedDoesNotDependOnTheFormThatWasThere") {
  // Least squares is linear: form added before is taken away again.
  const HeightMap rough = gaussian_surface({60, 40, 1e-6, 2e-6, 1e-7, 5e-6, 5e-6});
  HeightMap bent = rough;
  const HeightMap form = curved_plane();
  for (std::size_t c = 0; c < bent.z.size(); ++c) bent.z[c] += form.z[c];
  const HeightMap a = remove_form(rough, 2).map, b = remove_form(bent, 2).map;
  for (std::size_t c = 0; c < a.z.size(); ++c) CHECK(std::abs(a.z[c] - b.z[c]) < 1e-16);
}

TEST_CASE("HolesDoNotSpoilTheForm") {
  HeightMap map = curved_plane();
  for (const std::size_t c : {0U, 77U, 1500U}) map.z[c] = kHole;
  const Levelled left = remove_form(map, 2);
  CHECK(left.form.slope_x == Approx(3e-3).epsilon(1e-9));
  CHECK(std::isnan(left.map.z[77]));
  CHECK_THROWS_AS(remove_form(map, 9), InputError);
  HeightMap empty = map;
  for (double& z : empty.z) z = kHole;
  CHECK_THROWS_AS(remove_form(empty, 2), InputError);
}

TEST_CASE("FilledHolesAreHarmonic") {
  // A plane is harmonic: a hole in it is filled exactly. Elsewhere the filled heights stay between
  // those around.
  HeightMap plane{20, 16, 1e-6, 3e-6, {}};
  for (int j = 0; j < plane.ny; ++j) {
    for (int i = 0; i < plane.nx; ++i) plane.z.push_back(1e-8 * i - 3e-8 * j);
  }
  HeightMap holed = plane;
  for (int j = 5; j < 9; ++j) {
    for (int i = 7; i < 15; ++i) holed.z[holed.index(i, j)] = kHole;
  }
  const Holes holes = holes_of(holed);
  CHECK(holes.count == 32);
  CHECK((holes.i == 7 && holes.j == 5));
  const HeightMap filled = fill_laplace(holed);
  for (std::size_t c = 0; c < plane.z.size(); ++c) {
    CHECK(std::abs(filled.z[c] - plane.z[c]) < 1e-20);
  }
  CHECK(holes_of(filled).count == 0);
}

TEST_CASE("AMapWithoutHeightsIsNotFilled") {
  CHECK_THROWS_AS(fill_laplace({2, 2, 1.0, 1.0, std::vector<double>(4, kHole)}), InputError);
}
