// Geometry of the gap against its definition.
#include <catch2/catch.hpp>

#include "core/make_grid.hpp"
#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

constexpr double kSlack = 1e-18;  // round-off of 1e-5 m

/// Distance between the shell and a journal circle of radius R - c about (x, y), along phi.
double true_gap(double radius, double c, double x, double y, double phi) {
  const double along = x * std::cos(phi) + y * std::sin(phi);
  const double across = -x * std::sin(phi) + y * std::cos(phi);
  const double r = radius - c;
  return radius - (along + std::sqrt(r * r - across * across));
}

Setup tilted_journal() {
  Setup s;
  s.nt = 40;
  s.nz = 9;
  s.position = {{8e-6, -5e-6, 3e-4, -2e-4}};
  return s;
}

}  // namespace

TEST_CASE("TheGapIsTheDistanceBetweenTwoCircles") {
  const Setup s = tilted_journal();
  const PosedFilm b = make_bearing(s);
  const FilmGrid& g = b.scene.grid;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      // Small rotations psi of the axis: displacement psi x (0, 0, z) = (psi_y z, -psi_x z).
      const double x = s.position.ex() + s.position.psi_y() * g.z[j];
      const double y = s.position.ey() - s.position.psi_x() * g.z[j];
      // The linear gap neglects e^2/(2 R) = 3e-9 m.
      CHECK(std::abs(b.gap.cell[g.index(i, j)] - true_gap(s.radius, s.clearance, x, y, g.phi[i])) <
            4e-9);
      CHECK(std::abs(b.gap.phi_face[g.index(i, j)] -
                     true_gap(s.radius, s.clearance, x, y, g.phi_face[i])) < 4e-9);
    }
    for (int j = 0; j <= g.nz; ++j) {
      const double x = s.position.ex() + s.position.psi_y() * g.z_face[j];
      const double y = s.position.ey() - s.position.psi_x() * g.z_face[j];
      CHECK(std::abs(b.gap.z_face[i * (g.nz + 1) + j] -
                     true_gap(s.radius, s.clearance, x, y, g.phi[i])) < 4e-9);
    }
  }
}

TEST_CASE("TheGapMovesWithThePositionAsItsSlopesSay") {
  const Setup s = tilted_journal();
  const PosedFilm b = make_bearing(s);
  const FilmGrid& g = b.scene.grid;
  for (int k = 0; k < 4; ++k) {
    Setup t = s;
    const double step = k < 2 ? 1e-6 : 1e-4;  // the gap is linear in the position
    t.position.q[k] += step;
    const PosedFilm moved = make_bearing(t);
    for (int i = 0; i < g.nt; ++i) {
      for (int j = 0; j < g.nz; ++j) {
        const double slope = gap_slope(k, std::cos(g.phi[i]), std::sin(g.phi[i]), g.z[j]);
        const double change = moved.gap.cell[g.index(i, j)] - b.gap.cell[g.index(i, j)];
        CHECK(std::abs(change - slope * step) < kSlack);
      }
    }
  }
}

TEST_CASE("StepsAreCellsOwnAndDisplacementsAreShared") {
  const Setup s = tilted_journal();
  const PosedFilm b = make_bearing(s);
  const FilmGrid& g = b.scene.grid;
  const Field step = random_field(g.cells(), 1, 0.0, 1e-6);
  const Field d = random_field(g.cells(), 2, 0.0, 1e-6);
  const Gap gap = film_gap(g, b.scene.angles, s.clearance, s.position, d, step);
  std::vector<double> phi, z;
  to_faces(g, d, phi, z);
  for (int k = 0; k < g.cells(); ++k) {
    CHECK(std::abs(gap.cell[k] - b.gap.cell[k] - d[k] - step[k]) < kSlack);
    CHECK(std::abs(gap.phi_face[k] - b.gap.phi_face[k] - phi[k]) < kSlack);
  }
  for (std::size_t f = 0; f < z.size(); ++f) {
    CHECK(std::abs(gap.z_face[f] - b.gap.z_face[f] - z[f]) < kSlack);
  }
}

TEST_CASE("FacesOfALinearFieldAreExactOnUnevenGrids") {
  for (const bool half : {false, true}) {
    for (const int nz : {1, 2, 9, 10}) {
      const GridEdges edges = nz > 2 ? GridEdges{0.004} : GridEdges{};
      const FilmGrid g = make_grid(0.02, 0.02, 23, nz, half, {1.0, 1.4, 3.0}, edges);
      // Linear in z (constant at the plane of symmetry) and, off the seam, in phi.
      const double a = half || nz == 1 ? 0.0 : 3e-4;
      Field f(static_cast<std::size_t>(g.cells()));
      for (int k = 0; k < g.cells(); ++k) f[k] = 2e-6 * g.phi[k / g.nz] + a * g.z[k % g.nz];
      std::vector<double> phi, z;
      to_faces(g, f, phi, z);
      for (int i = 0; i < g.nt; ++i) {
        for (int j = 0; j < g.nz && i > 0; ++j) {
          CHECK(std::abs(phi[g.index(i, j)] - 2e-6 * g.phi_face[i] - a * g.z[j]) < kSlack * 100);
        }
        for (int j = 0; j <= g.nz; ++j) {
          CHECK(std::abs(z[i * (g.nz + 1) + j] - 2e-6 * g.phi[i] - a * g.z_face[j]) < kSlack * 100);
        }
      }
    }
  }
}

TEST_CASE("TheSmallestGapIsFoundAtTheEdgeOfATiltedShaft") {
  Setup s = tilted_journal();
  s.nt = 360;
  s.position = {{-12e-6, 0.0, 0.0, -5e-4}};  // closes towards phi = 180 deg, z = +B/2
  const PosedFilm b = make_bearing(s);
  const SmallestGap least = smallest_gap(b.scene.grid, b.gap, b.step, b.scene.supply);
  CHECK(std::abs(least.h - (20e-6 - 12e-6 - 5e-4 * 0.01)) < 20e-6 * 1e-4);  // (half a degree)^2
  CHECK(std::abs(least.phi - kPi) <= kPi / 180.0);
  CHECK(least.z == b.scene.grid.z_face.back());
}

TEST_CASE("AStepThatWidensTheGapIsPartOfTheSmallestGap") {
  Setup s = tilted_journal();
  s.position = eccentric(12e-6, 1.0);
  const PosedFilm plain = make_bearing(s);
  s.profile = [](double, double) { return 3e-6; };
  const PosedFilm wide = make_bearing(s);
  const double a = smallest_gap(plain.scene.grid, plain.gap, plain.step, plain.scene.supply).h;
  const double b = smallest_gap(wide.scene.grid, wide.gap, wide.step, wide.scene.supply).h;
  CHECK(std::abs(b - a - 3e-6) < kSlack);
}

TEST_CASE("AtTheEdgeOfAPocketTheLandIsTheSmallestGap") {
  Setup s = tilted_journal();
  s.nt = 36;
  s.position = eccentric(12e-6, kPi);  // the smallest gap lies on a face
  for (const double side : {1.0, -1.0}) {
    s.profile = [side](double phi, double) { return side * (phi - kPi) > 0.0 ? 5e-6 : 0.0; };
    const PosedFilm b = make_bearing(s);
    const SmallestGap least = smallest_gap(b.scene.grid, b.gap, b.step, b.scene.supply);
    CHECK(std::abs(least.h - (20e-6 - 12e-6)) < 100.0 * kSlack);
    CHECK(least.phi == Approx(kPi).epsilon(1e-12));
  }
}

TEST_CASE("AGrooveIsNoFilmThatCouldClose") {
  // Lands pressed away from the shaft by 9 um leave a groove's ground where it was: deeper by a
  // millimetre, it is not the smallest film, and the land beside it is.
  Setup s = tilted_journal();
  SupplyPatch groove;
  groove.arc = 2.0 * kPi;
  groove.length = 0.25 * s.width;
  groove.depth = 1e-3;
  s.patches = {groove};
  s.position = eccentric(25e-6, kPi);  // 5 um beyond the clearance
  const PosedFilm b = make_bearing(s);
  const FilmGrid& g = b.scene.grid;
  Field pressed(g.cells(), 0.0);
  for (int k = 0; k < g.cells(); ++k) {
    if (b.scene.supply.cell[k] < 0) pressed[k] = 9e-6;
  }
  const Gap gap = film_gap(g, b.scene.angles, s.clearance, s.position, pressed, {});
  CHECK(*std::min_element(gap.cell.begin(), gap.cell.end()) < 0.0);
  const SmallestGap least = smallest_gap(g, gap, {}, b.scene.supply);
  CHECK(least.h == Approx(20e-6 - 25e-6 + 9e-6).epsilon(0.02));  // (4.5 deg)^2/2 of 25 um
  const Field h = nominal_depth(gap, b.scene.supply);
  for (int k = 0; k < g.cells(); ++k) {
    const bool film = b.scene.supply.cell[k] < 0;
    CHECK(h[k] == Approx(gap.cell[k] + (film ? 0.0 : 1e-3)).epsilon(1e-14));
  }
}

TEST_CASE("AnEdgeThatClosesSteeplyKeepsAGap") {
  // (1) of gap.hpp: the straight line up to half of the room; from there on value and slope go on,
  // and however steeply the line falls there is a gap.
  for (const double summits : {0.0, 2e-6}) {
    const double own = 1e-6, room = own + summits;
    CHECK(edge_gap(own, -0.49 * room, summits).h == own - 0.49 * room);
    CHECK(edge_gap(own, 3.0 * room, summits).h == own + 3.0 * room);
    for (const double line : {-0.3, -0.5001, -0.7, -1.0, -4.0, -1e3}) {
      const EdgeGap at = edge_gap(own, line * room, summits);
      CHECK(at.h + summits > 0.0);
      const double step = 1e-5 * room;
      const auto h = [&](double d_own, double d_line) {
        return edge_gap(own + d_own, line * room + d_line, summits).h;
      };
      CHECK(at.slope.own == Approx((h(step, 0.0) - h(-step, 0.0)) / (2.0 * step)).epsilon(1e-4));
      CHECK(at.slope.line == Approx((h(0.0, step) - h(0.0, -step)) / (2.0 * step)).epsilon(1e-4));
    }
    const double beside = 1e-9 * room;  // on either side of where the two meet
    CHECK(edge_gap(own, -0.5 * room - beside, summits).h ==
          Approx(edge_gap(own, -0.5 * room + beside, summits).h).margin(1e-8 * room));
    // Without room there is nothing to hold open; the value there is approached.
    CHECK(edge_gap(-summits, -room, summits).h == -summits);
    CHECK(edge_gap(1e-12 - summits, -room, summits).h == Approx(-summits).margin(1e-12));
  }
}

TEST_CASE("ATiltedRigidJournalMayCloseTheEdge") {
  // Only a displacement is continued to the edge: where a rigid journal is there is known.
  Setup s = tilted_journal();
  s.position = {{25e-6, 0.0, 0.0, 2e-3}};
  const PosedFilm b = make_bearing(s);
  CHECK(smallest_gap(b.scene.grid, b.gap, {}, b.scene.supply).h < 0.0);
  const Field d(b.scene.grid.cells(), 0.0);
  const Gap soft = film_gap(b.scene.grid, b.scene.angles, s.clearance, s.position, d, {});
  CHECK(soft.z_face == b.gap.z_face);
  CHECK(soft.edge.empty());
}
