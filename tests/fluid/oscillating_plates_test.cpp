// Parallel plates that swing against each other: the front of the cavitated film.
//
// In x from 0 to 1 d/dx(h^3 dp/dx) = 2 d(theta h)/dt, p = 0.025 at both ends, p_cav = 0,
// h = 0.375 + 0.125 cos(4 pi t). Where the film has ruptured it is full up to the front a(t):
//   opening:    a = sqrt(2 p_b h^3/(2 dh/dt))                                              (1)
//   closing:    h (1 - theta) da/dt = (h^3/2) [p_b/a - (2 dh/dt/h^3) a/2]                   (2)
// with theta = h(t_rupture(x))/h(t) beyond it; the file has the solution of (1)-(2). After Ausas,
// Jai and Buscaglia 2009.
#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"
#include "tests/read_csv.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;
using shellback::test::CsvRow;
using shellback::test::read_csv;

namespace {

constexpr double kEdge = 0.025;  // p at the ends
double gap_at(double t) { return 0.375 + 0.125 * std::cos(4.0 * kPi * t); }

/// The plates as the developed surface of a bearing that does not turn, whose circumference is 1 m
/// and on which a line of the pressure p_b lies where x = 0 and 1; so wide that nothing flows out
/// sideways. Clearance h in m, density 1 kg/m3, and a viscosity with which d/dx(h^3/2 dp/dx) is
/// d(theta h)/dt.
PosedFilm plates(double t, int cells) {
  Setup s;
  s.radius = 0.5 / kPi;
  s.width = 1e6;
  s.clearance = gap_at(t);
  s.viscosity = 1.0 / 6.0;
  s.density = 1.0;
  s.speed = 0.0;
  s.half = true;
  s.nt = cells;
  s.nz = 2;
  s.patches = {line_supply(s, 0.0, kEdge)};
  return make_bearing(s);
}

/// Cells that are full from x = 0 on.
int full_cells(const FilmState& film) {
  int full = 0;
  while (full < static_cast<int>(film.full.size()) && film.full[full]) ++full;
  return full;
}

}  // namespace

TEST_CASE("TheFrontBetweenSwingingPlatesIsWithinACell", "[squeeze]") {
  constexpr int kCells = 400;  // from end to end
  constexpr double kCell = 1.0 / kCells;
  constexpr double kStep = 2.5e-4;  // in which the front goes half a cell, closing at t = 0.7
  const auto rows = read_csv("validation/data/jfo_squeeze_parallel_exact.csv");
  double t = 0.24;  // before the film ruptures
  PosedFilm before = plates(t, kCells);
  FilmState film = cold_film(before.scene);
  std::size_t next = 0;
  int seen = 0;
  while (next < rows.size()) {
    const double ends = t + kStep;
    PosedFilm b = plates(ends, kCells);
    FilmCoefficients oil;
    before.oil(film, oil);
    b.scene.storage = {kStep, oil_content(before.scene, before.gap, oil, film)};
    const auto found = solve_reynolds(b.scene, b.gap, b.step, b.oil, film, {.tolerance = 1e-9});
    INFO("t " << ends << ": " << to_string(found.verdict.status));
    REQUIRE(found.good());
    film = found.value.state;
    before = std::move(b);
    t = ends;
    for (; next < rows.size() && rows[next].at("t") <= t + 0.5 * kStep; ++next) {
      const double a = rows[next].at("a");
      const int full = full_cells(film);
      INFO("t " << t << ": " << full << " cells are full, the front lies at " << a);
      if (a < 0.5) {
        CHECK(std::abs((full + 0.5) * kCell - a) < kCell);
      } else {
        CHECK(full == kCells);  // before it ruptures, and when it has filled again
      }
      ++seen;
    }
  }
  CHECK(seen > 20);
}
