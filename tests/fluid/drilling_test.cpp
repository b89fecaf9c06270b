// Mouths of drillings, which no cell belongs to, against holes of the shell and closed forms.
#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

constexpr double kDiameter = 5e-3;  // 4 by 3 cells of the coarse grid [m]

/// A bearing whose one supply is a hole, or a drilling that stands at the same place.
struct Fed {
  PosedFilm bearing;
  FilmSolution film;
};

Setup with_hole(int nt, double phi, bool moving) {
  Setup s;
  s.nt = nt;
  s.nz = nt / 5;
  s.fit_grid = false;
  s.position = eccentric(0.6 * s.clearance, 0.0);
  s.patches = {{.phi = phi,
                .arc = kDiameter / s.radius,
                .length = kDiameter,
                .round = true,
                .pressure = 2e5,
                .moving = moving}};
  return s;
}

Fed fed(const Setup& s) {
  Fed f;
  f.bearing = make_bearing(s);
  Field conductance = f.bearing.gap.cell;
  for (double& h : conductance) h = s.density * h * h * h / (12.0 * s.viscosity);
  if (s.patches[0].moving) {
    place_mouths(f.bearing.scene.grid, conductance, f.bearing.scene.supply);
  }
  Outcome<FilmSolution> solved = solve(f.bearing);
  INFO(to_string(solved.verdict.status));
  REQUIRE(solved.good());
  f.film = std::move(solved.value);
  return f;
}

double supplied(const Fed& f) { return oil_flows(f.bearing.scene, f.film.flow).supply; }

}  // namespace

TEST_CASE("AMouthThatStandsStillFeedsAsAHoleOfTheShell") {
  // The same links end on the same edge; what is left is a thousandth of a link.
  const double hole = supplied(fed(with_hole(200, kPi, false)));
  const double mouth = supplied(fed(with_hole(200, kPi, true)));
  CHECK(mouth == Approx(hole).epsilon(3e-3));
}

TEST_CASE("TheFlowOfAMouthDoesNotJumpAsItMoves") {
  // Moved by a cell in twentieths: a hole on the cells whose middles it takes jumps by several per
  // cent; the fine grid knows the flow within half a per cent and says how it changes on the way.
  const double cell = 2.0 * kPi / 100.0;
  double before = NAN;
  for (int k = 0; k <= 20; ++k) {
    const double phi = kPi + cell * k / 20.0;
    const double flow = supplied(fed(with_hole(100, phi, true)));
    CAPTURE(k, flow);
    if (k > 0) CHECK(flow == Approx(before).epsilon(0.01));
    if (k % 7 == 0) CHECK(flow == Approx(supplied(fed(with_hole(200, phi, true)))).epsilon(0.02));
    before = flow;
  }
}

TEST_CASE("AMouthBalancesItsOil") {
  // In the cavitated film, too, which it fills.
  for (const double phi : {0.4, 1.5, kPi, 5.0}) {
    const Fed f = fed(with_hole(100, phi, true));
    const OilFlows flows = oil_flows(f.bearing.scene, f.film.flow);
    CHECK(flows.supply == Approx(flows.side).epsilon(1e-8));
    CHECK(flows.patch[0] == flows.supply);
  }
}

TEST_CASE("AMouthOverAHoleOfTheShellFeedsNothing") {
  Setup s = with_hole(100, kPi, true);
  SupplyPatch hole = s.patches[0];
  hole.moving = false;
  hole.arc *= 2.0;
  hole.length *= 2.0;
  s.patches.push_back(hole);
  const Fed f = fed(s);
  CHECK(f.bearing.scene.supply.mouths.empty());
  CHECK(oil_flows(f.bearing.scene, f.film.flow).patch[0] == 0.0);
}

TEST_CASE("OfMouthsSideBySideNoneIsAskedWhichComesFirst") {
  // Two of 2 mm, 0.2 mm apart along the axis: on coarse grids each is taken as wide as a cell, and
  // they reach over the same unknowns. The first of a case took them (flows 21 times apart).
  for (const int nt : {40, 60, 100, 200}) {
    double flow[2][2] = {};
    for (const bool first : {true, false}) {
      Setup s = with_hole(nt, kPi, true);
      s.patches[0].length = 2e-3;
      s.patches[0].arc = 2e-3 / s.radius;
      s.patches.push_back(s.patches[0]);
      s.patches[first ? 0 : 1].z = 1.1e-3;
      s.patches[first ? 1 : 0].z = -1.1e-3;
      s.patches[first ? 1 : 0].pressure *= 10.0;
      const Fed f = fed(s);
      const OilFlows flows = oil_flows(f.bearing.scene, f.film.flow);
      flow[first][0] = flows.patch[first ? 0 : 1];
      flow[first][1] = flows.patch[first ? 1 : 0];
    }
    CAPTURE(nt, flow[0][0], flow[0][1]);
    // The sums are taken in another order: digits of an ill-conditioned balance.
    CHECK(flow[0][0] == Approx(flow[1][0]).epsilon(1e-6));
    CHECK(flow[0][1] == Approx(flow[1][1]).epsilon(1e-6));
    CHECK(flow[0][1] > 0.0);
  }
}

TEST_CASE("AMouthFinerThanTheGridIsAsWideAsACell") {
  Setup s = with_hole(20, kPi, true);
  s.patches[0].length = 1e-4;
  for (int k = 0; k < 10; ++k) {  // wherever it stands, it feeds
    s.patches[0].phi = kPi + 2.0 * kPi / 20.0 * k / 10.0;
    CHECK(supplied(fed(s)) > 0.0);
  }
}
