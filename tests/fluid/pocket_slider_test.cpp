// Mass-conserving cavitation against an exact solution: a slider with a pocket, wide and unrolled.
//
// The slider of 10 mm lies on a ring of 2 pi R = 12.5 mm, which has no curvature in the film
// equation; the rest of the ring is a supply at ambient pressure. A pocket that is a step of the
// gap, land and pocket cells with their mean gap, so that the linear wedge is met to second order.
#include "tests/analytic/pocket_slider.hpp"

#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"
#include "tests/observed_order.hpp"
#include "tests/read_csv.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;
using analytic::PocketSlider;

namespace {

const PocketSlider kExact{};
constexpr double kFlow = 5.229635e-7;  // validation 5.1 [m2/s]
constexpr double kPeak = 9.80882e6;    // validation 5.1 [Pa]

struct Slider {
  PosedFilm bearing;
  Outcome<FilmSolution> film;
  double flow_per_width = 0.0;  ///< [m2/s]
  double spread = 0.0;          ///< largest deviation of a face's flow from the mean, relative
};

/// `cells` over the slider, a multiple of 10; the wedge is a smooth displacement and the pocket a
/// step, unless `steps_only`: then the step of each cell is its whole deviation.
Slider solve_slider(int cells, bool steps_only) {
  Setup s;
  const double circumference = 1.25 * kExact.length;
  s.radius = circumference / (2.0 * kPi);
  s.width = 1000.0 * s.radius;  // side flow below 1e-6 of the flow along
  s.clearance = kExact.h_out;
  s.viscosity = kExact.eta;
  s.speed = kExact.speed;
  s.p_edge = kExact.p_ambient;
  s.edges = SideEdges::dry;
  s.nt = cells * 5 / 4;
  s.nz = 1;
  const double arc = 0.2 * 2.0 * kPi;
  // The supply ends where the slider begins, at phi = 0.
  s.patches = {{.phi = -0.5 * arc, .arc = arc, .length = s.width, .pressure = kExact.p_ambient}};
  const auto x_of = [&s](double phi) {
    return s.radius * (phi - 2.0 * kPi * std::floor(phi / (2.0 * kPi)));
  };
  const auto wedge = [](double x) {
    return x < kExact.length ? kExact.gap(x, false) - kExact.h_out : 0.0;
  };
  s.profile = [&](double phi, double) {
    const double x = x_of(phi);
    return (kExact.in_pocket(x) ? kExact.depth : 0.0) + (steps_only ? wedge(x) : 0.0);
  };
  Slider out{make_bearing(s), {}};
  PosedFilm& b = out.bearing;
  if (!steps_only) {  // the wedge exactly on the faces
    const FilmGrid& g = b.scene.grid;
    for (int i = 0; i < g.nt; ++i) {
      b.gap.phi_face[i] += wedge(x_of(g.phi_face[i] + 1e-12));
      b.gap.cell[i] += wedge(x_of(g.phi[i]));
    }
  }
  out.film = solve(b);
  REQUIRE(out.film.good());
  int faces = 0;
  for (int pass = 0; pass < 2; ++pass) {
    for (int i = 0; i < s.nt; ++i) {
      const FaceFlow& f = out.film.value.flow.phi[i];
      if (f.m == 0.0) continue;
      const double q = f.m / (s.density * s.width);
      if (pass == 0) {
        out.flow_per_width += q;
        ++faces;
      } else {
        out.spread = std::max(out.spread, std::abs(q / out.flow_per_width - 1.0));
      }
    }
    if (pass == 0) out.flow_per_width /= faces;
  }
  return out;
}

double x_of_face(const Slider& s, int i) {
  const FilmGrid& g = s.bearing.scene.grid;
  const double turn = 2.0 * kPi, phi = g.phi_face[i] + 1e-12;
  return g.radius * (phi - turn * std::floor(phi / turn));
}

/// West face of the first full cell after the empty ones.
double reformation(const Slider& s) {
  const FilmState& v = s.film.value.state;
  for (int i = 0; i < s.bearing.scene.grid.nt; ++i) {
    const int west = s.bearing.scene.grid.previous(i);
    if (v.theta[west] < 1.0 && v.theta[i] == 1.0) return x_of_face(s, i);
  }
  return -1.0;
}

}  // namespace

TEST_CASE("TheClosedFormOfThePocketSliderIsThePublishedOne") {
  CHECK(std::abs(kExact.flow() / kFlow - 1.0) < 1e-6);  // seven printed digits
  CHECK(std::abs(kExact.reformation() - 3.61126e-3) < 1e-8);
  for (const auto& row :
       shellback::test::read_csv("validation/data/pocket_slider_fowell_exact.csv")) {
    const double p = kExact.pressure(row.at("x_m"));
    CHECK(std::abs(p - row.at("p_Pa")) < 1e-5 * kPeak);  // six printed digits
  }
}

TEST_CASE("ThePocketSliderCarriesTheExactFlow") {
  for (const bool steps_only : {false, true}) {
    for (const int cells : {100, 200, 400}) {
      CAPTURE(steps_only, cells);
      const Slider s = solve_slider(cells, steps_only);
      CHECK(std::abs(s.flow_per_width / kFlow - 1.0) < 1e-3);  // design 6
      // Mass: the sides are dry and at ambient; what they let out where p is higher is 1e-6 of
      // the flow along, (R/B)^2.
      CHECK(s.spread < 1e-5);
    }
  }
}

TEST_CASE("ThePocketSliderBuildsUpTheExactPressure") {
  const Slider s = solve_slider(400, false);
  const FilmGrid& g = s.bearing.scene.grid;
  double peak = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    const double x = 0.5 * (x_of_face(s, i) + x_of_face(s, i) + g.radius * g.dphi[i]);
    if (s.bearing.scene.supply.cell[i] >= 0) continue;
    const double p = s.film.value.state.p[i];
    peak = std::max(peak, p);
    // The reformation front lies anywhere in its cell: one cell's share of the rise in the pocket.
    CHECK(std::abs(p - kExact.pressure(x)) < 0.01 * kPeak);
  }
  CHECK(std::abs(peak / kPeak - 1.0) < 1e-2);
}

TEST_CASE("TheFilmReformsInTheCellOfTheExactFront") {
  for (const int cells : {50, 100, 200, 400, 800}) {
    CAPTURE(cells);
    const double cell = kExact.length / cells;
    CHECK(std::abs(reformation(solve_slider(cells, false)) - kExact.reformation()) <= 1.01 * cell);
  }
}

TEST_CASE("TheFlowOfThePocketSliderConvergesWithTheGrid") {
  // First order: the film ruptures on the step, the unknown of the first empty cell lies half a
  // cell behind it. The front moves by whole cells, so that single grids scatter a little.
  double worst_coarse = 0.0, worst_fine = 0.0;
  for (const int k : {0, 1, 2, 3}) {
    const double coarse = solve_slider(50 + 10 * k, false).flow_per_width;
    const double fine = solve_slider(16 * (50 + 10 * k), false).flow_per_width;
    worst_coarse = std::max(worst_coarse, std::abs(coarse / kExact.flow() - 1.0));
    worst_fine = std::max(worst_fine, std::abs(fine / kExact.flow() - 1.0));
  }
  CHECK(shellback::test::order_of_errors(worst_coarse, worst_fine, 16.0) > 0.95);
}
