// Which cells and faces a groove or a hole covers.
#include <catch2/catch.hpp>

#include "core/contract.hpp"
#include "core/make_grid.hpp"
#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

double covered_area(const FilmGrid& g, const SupplyMap& map, int patch) {
  double area = 0.0;
  for (int k = 0; k < g.cells(); ++k) {
    if (map.cell[k] == patch) area += g.multiplicity() * g.area(k);
  }
  return area;
}

FilmGrid fitted(const std::vector<SupplyPatch>& patches, int nt, int nz, bool half = false) {
  return make_grid(0.02, 0.02, nt, nz, half, phi_edges(patches), z_edges(patches));
}

}  // namespace

TEST_CASE("AGrooveCoversItsAreaExactly") {
  for (const bool half : {false, true}) {
    for (const double phi : {0.0, 1.3, 6.2}) {
      const std::vector<SupplyPatch> groove{{.phi = phi, .arc = 0.37, .length = 0.0083}};
      const FilmGrid g = fitted(groove, 50, 13, half);
      const double area = 0.02 * 0.37 * 0.0083;
      CHECK(std::abs(covered_area(g, map_supplies(g, groove), 0) / area - 1.0) < 1e-12);
    }
  }
}

TEST_CASE("GroovesAllRoundAndAcrossCoverTheirAreas") {
  const std::vector<SupplyPatch> round{{.phi = 1.0, .arc = 2.0 * kPi, .length = 0.004}};
  const FilmGrid g = fitted(round, 50, 15);
  CHECK(std::abs(covered_area(g, map_supplies(g, round), 0) / (0.02 * 2.0 * kPi * 0.004) - 1.0) <
        1e-12);
  const std::vector<SupplyPatch> across{{.phi = 1.0, .arc = 0.3, .length = 0.02}};
  const FilmGrid f = fitted(across, 50, 15);
  CHECK(std::abs(covered_area(f, map_supplies(f, across), 0) / (0.02 * 0.3 * 0.02) - 1.0) < 1e-12);
}

TEST_CASE("AHoleCoversTheAreaOfItsCircleMoreAndMoreClosely") {
  const double diameter = 0.006;
  const std::vector<SupplyPatch> hole{
      {.phi = 6.2, .z = 1e-3, .arc = diameter / 0.02, .length = diameter, .round = true}};
  const double area = kPi * diameter * diameter / 4.0;
  for (const int refined : {1, 4}) {
    const FilmGrid g = fitted(hole, 200 * refined, 30 * refined);
    const double covered = covered_area(g, map_supplies(g, hole), 0);
    // The rim runs through about four cells per cell of the diameter, each right to +-1/2 and
    // with random sign: 4/n for n = 9.5 cells across, a quarter of it on the fine grid.
    CHECK(std::abs(covered / area - 1.0) < 0.15 / refined);
  }
}

TEST_CASE("AHoleFinerThanTheGridIsOneCell") {
  for (const bool half : {false, true}) {
    const FilmGrid g = make_grid(0.02, 0.02, 20, 5, half);
    const SupplyPatch hole{.phi = -0.2, .arc = 0.001, .length = 2e-5, .round = true};
    const SupplyMap map = map_supplies(g, {hole});
    int cells = 0;
    for (int k = 0; k < g.cells(); ++k) {
      if (map.cell[k] < 0) continue;
      ++cells;
      CHECK(std::abs(std::remainder(g.phi[k / g.nz] - hole.phi, 2.0 * kPi)) <= kPi / 20.0);
      CHECK(std::abs(g.z[k % g.nz]) <= 0.002);
    }
    CHECK(cells == 1);
  }
}

TEST_CASE("AGrooveFinerThanTheGridCoversItsAreaExactly") {
  const SupplyPatch ring{.phi = 1.0, .arc = 2.0 * kPi, .length = 5e-5};
  const SupplyPatch slit{.phi = 1.0, .z = 1e-3, .arc = 0.01, .length = 0.012};
  for (const SupplyPatch& groove : {ring, slit}) {
    for (const int nz : {10, 12, 13, 16}) {
      for (const bool half : {false, groove.z == 0.0}) {
        const FilmGrid g = fitted({groove}, 50, nz, half);
        const double area = 0.02 * groove.arc * groove.length;
        CHECK(std::abs(covered_area(g, map_supplies(g, {groove}), 0) / area - 1.0) < 1e-9);
      }
    }
  }
}

TEST_CASE("AGrooveWhoseEdgesAreMergedIsAWholeRowOfCells") {
  // On a grid that knows nothing of it: all round, at the row or column nearest to it.
  const FilmGrid g = make_grid(0.02, 0.02, 50, 12, false);
  const std::vector<SupplyPatch> ring{{.phi = 1.0, .arc = 2.0 * kPi, .length = 5e-5}};
  CHECK(covered_area(g, map_supplies(g, ring), 0) ==
        Approx(0.02 * 2.0 * kPi * 0.02 / 12).epsilon(1e-12));
  const std::vector<SupplyPatch> slit{{.phi = 1.0, .arc = 0.001, .length = 0.02}};
  CHECK(covered_area(g, map_supplies(g, slit), 0) ==
        Approx(0.02 * 2.0 * kPi * 0.02 / 50).epsilon(1e-12));
}

TEST_CASE("ARingFeedsTwoLandsOnEveryGrid") {
  // The journal in the middle: Q = 2 pi D c^3 p/(12 eta l).
  for (const int nz : {8, 10, 13, 16, 24}) {
    Setup s;
    s.patches = {{.phi = 1.0, .arc = 2.0 * kPi, .length = 1e-4, .pressure = 2e5}};
    s.nz = nz;
    const PosedFilm b = make_bearing(s);
    const auto film = solve(b);
    REQUIRE(film.verdict.good());
    const double land = 0.5 * (s.width - s.patches[0].length);
    const double flow = s.density * 2.0 * 2.0 * kPi * s.radius * std::pow(s.clearance, 3) * 2e5 /
                        (12.0 * s.viscosity * land);
    INFO(nz << " cells");
    CHECK(oil_flows(b.scene, film.value.flow).side == Approx(flow).epsilon(1e-9));
  }
}

TEST_CASE("ALineLiesOnTheFaceAtItsAngle") {
  Setup s;
  for (const double phi : {0.0, 2.5, -0.7}) {
    const std::vector<SupplyPatch> line{line_supply(s, phi)};
    const FilmGrid g = fitted(line, 36, 6);
    const SupplyMap map = map_supplies(g, line);
    CHECK(map.has_lines);
    int faces = 0;
    for (int k = 0; k < g.cells(); ++k) {
      CHECK(map.cell[k] == -1);
      if (map.line[k] < 0) continue;
      ++faces;
      CHECK(std::abs(std::remainder(g.phi_face[k / g.nz] - phi, 2.0 * kPi)) < 1e-12);
    }
    CHECK(faces == g.nz);
  }
}

TEST_CASE("OverlappingSuppliesAreRefused") {
  const SupplyPatch a{.phi = 1.0, .arc = 0.4, .length = 0.01};
  SupplyPatch b = a;
  b.phi = 1.3;
  const FilmGrid g = fitted({a, b}, 60, 9);
  CHECK_THROWS_AS(map_supplies(g, {a, b}), InputError);
  b.phi = 1.5;
  const FilmGrid apart = fitted({a, b}, 60, 9);
  CHECK_NOTHROW(map_supplies(apart, {a, b}));
}

TEST_CASE("TheSupplyKeepsItsPressure") {
  Setup s;
  s.position = eccentric(12e-6, 1.0);
  s.patches = {{.phi = 2.0, .arc = 0.4, .length = 0.01, .pressure = 3e5}};
  const PosedFilm b = make_bearing(s);
  const auto film = solve(b);
  REQUIRE(film.good());
  int cells = 0;
  for (int k = 0; k < b.scene.grid.cells(); ++k) {
    if (b.scene.supply.cell[k] < 0) continue;
    ++cells;
    CHECK(film.value.state.p[k] == 3e5);
    CHECK(film.value.state.theta[k] == 1.0);
  }
  CHECK(cells > 0);
}

TEST_CASE("ALineBetweenTheMiddlesOfRowsFeedsTheNearestOne") {
  // Its edges may be merged with those of a groove beside it: it was then nowhere.
  const FilmGrid g = fitted({}, 48, 8);
  const double middle = 0.5 * (g.z[3] + g.z[4]) + 0.1 * (g.z[4] - g.z[3]);
  const std::vector<SupplyPatch> line{{.phi = 1.0, .z = middle, .arc = 0.0, .length = 1e-5}};
  const SupplyMap map = map_supplies(g, line);
  int cells = 0;
  for (int k = 0; k < g.cells(); ++k) cells += map.line[k] == 0 ? 1 : 0;
  CHECK(cells == 1);
  CHECK(map.has_lines);
}
