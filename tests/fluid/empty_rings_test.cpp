/// Rings of film that are cavitated all round: told, and filled again.
#include "fluid/empty_rings.hpp"

#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

/// A full film but for the ring at one axial index.
FilmState empty_at(const PosedFilm& b, int ring) {
  FilmState s = cold_film(b.scene);
  for (int i = 0; i < b.scene.grid.nt; ++i) {
    const int k = b.scene.grid.index(i, ring);
    if (b.scene.supply.cell[k] >= 0) continue;
    s.full[k] = 0;
    s.theta[k] = 0.4;
    s.p[k] = b.scene.p_cavitation;
  }
  return s;
}

/// Derivative of the net outflow along a fill ratio that is uniform in the ring [kg/s].
double by_more_oil(const PosedFilm& b, const FilmState& s, int ring) {
  FilmCoefficients oil;
  b.oil(s, oil);
  FilmFlow flow;
  evaluate_flow(b.scene, b.gap, b.step, oil, s, flow);
  RingMatrix matrix;
  assemble_film(b.scene, flow, active_set_unknowns(s), matrix);
  std::vector<double> carried(s.p.size(), 0.0), changed;
  for (int i = 0; i < b.scene.grid.nt; ++i) {  // the same flow through every face of the ring
    const int k = b.scene.grid.index(i, ring);
    const int east = b.scene.grid.index(b.scene.grid.next(i), ring);
    carried[k] = 1.0 / flow.phi[east].d_theta;
  }
  matrix.multiply(carried, changed);
  return largest_magnitude(changed);
}

}  // namespace

TEST_CASE("OilOfARingThatIsCavitatedAllRoundOnlyGoesRound") {
  Setup setup;
  setup.position = {{8e-6, -4e-6, 0.0, 0.0}};
  const PosedFilm b = make_bearing(setup);
  const int last = b.scene.grid.nz - 1;
  FilmState s = empty_at(b, last);
  CHECK(empty_rings(b.scene, s) == std::vector<int>{last});
  // One unit of flow through every face leaves every balance as it is: the matrix is singular.
  CHECK(by_more_oil(b, s, last) < 1e-12);
  CHECK(refill_empty_rings(b.scene, s));
  CHECK(empty_rings(b.scene, s).empty());
  CHECK_FALSE(refill_empty_rings(b.scene, s));
  for (const double theta : s.theta) CHECK(theta == 1.0);
}

TEST_CASE("ARingWithAFullCellOrASupplyIsFed") {
  const PosedFilm b = make_bearing(Setup{});
  FilmState s = empty_at(b, 3);
  s.full[b.scene.grid.index(20, 3)] = 1;
  CHECK(empty_rings(b.scene, s).empty());
  Setup grooved;
  SupplyPatch groove;
  groove.phi = 1.5;
  groove.arc = 0.4;
  groove.length = 0.012;
  grooved.patches = {groove};
  const PosedFilm g = make_bearing(grooved);
  CHECK(empty_rings(g.scene, empty_at(g, g.scene.grid.nz / 2)).empty());
  CHECK(empty_rings(g.scene, empty_at(g, 0)).size() == 1);
}

TEST_CASE("OnlyASteadyFilmIsSingularByAnEmptyRing") {
  const PosedFilm b = make_bearing(Setup{});
  const FilmState s = empty_at(b, b.scene.grid.nz - 1);
  FilmScene scene = b.scene;
  CHECK(steady_ring_is_empty(scene, s));
  scene.storage.dt = 1e-4;
  scene.storage.before.assign(scene.grid.cells(), 1e-3);
  CHECK_FALSE(steady_ring_is_empty(scene, s));
}

TEST_CASE("AFilmWhoseMatrixIsSingularIsToldAsOne") {
  Setup setup;
  setup.position = {{8e-6, -4e-6, 0.0, 0.0}};
  const PosedFilm b = make_bearing(setup);
  const int ring = b.scene.grid.nz - 1;
  const auto film =
      solve_reynolds(b.scene, b.gap, b.step, b.oil, empty_at(b, ring), ReynoldsOptions{});
  REQUIRE_FALSE(film.good());
  const auto* why = film.verdict.as<ending::Plain>();
  REQUIRE(why != nullptr);
  CHECK(*why == ending::Plain::empty_ring);
  CHECK(film.verdict.place.z == b.scene.grid.z[ring]);
}
