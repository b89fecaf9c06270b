// Analytic limits: very wide, very narrow, barely eccentric.
#include <catch2/catch.hpp>

#include "tests/analytic/journal_film.hpp"
#include "tests/fluid/film_scenes.hpp"
#include "tests/observed_order.hpp"
#include "tests/read_csv.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;
using shellback::test::order_of_errors;

namespace {

/// One axial cell in a bearing a thousand times wider than its radius: side flow takes 1e-6.
Setup wide(double eps, int nt) {
  Setup s;
  s.width = 1000.0 * s.radius;
  s.position = eccentric(eps * s.clearance, 0.0);
  s.nt = nt;
  s.nz = 1;
  return s;
}

Setup full_film(double eps, int nt) {
  Setup s = wide(eps, nt);
  s.patches = {line_supply(s, kPi)};
  s.p_cavitation = -1e12;  // never reached
  return s;
}

struct SommerfeldErrors {
  double load, attitude, pressure;
};

SommerfeldErrors sommerfeld_errors(double eps, int nt) {
  const Setup s = full_film(eps, nt);
  const PosedFilm b = make_bearing(s);
  const auto film = solve(b);
  REQUIRE(film.good());
  const auto c = characteristics(s, b, film.value, CavitatedShear::filled);
  const double scale = s.viscosity * s.speed * s.radius / (s.clearance * s.clearance);
  double worst = 0.0, peak = 0.0;
  for (int i = 0; i < nt; ++i) {
    const double exact = analytic::sommerfeld_pressure(eps, b.scene.grid.phi[i] - kPi);
    worst = std::max(worst, std::abs(film.value.state.p[i] / scale - exact));
    peak = std::max(peak, std::abs(exact));
  }
  const double load = 1.0 / (2.0 * kPi * c.sommerfeld);
  return {std::abs(load / analytic::sommerfeld_load(eps) - 1.0), std::abs(c.attitude - 90.0),
          worst / peak};
}

}  // namespace

TEST_CASE("AnEndlesslyWideFullFilmIsSommerfelds") {
  for (const double eps : {0.1, 0.5, 0.8}) {
    CAPTURE(eps);
    const SommerfeldErrors e = sommerfeld_errors(eps, 400);
    // Cell size over the length of the narrow gap: (2 pi/400)^2/(1 - eps) is 1e-3 at eps = 0.8.
    CHECK(e.load < 1e-3);
    CHECK(e.pressure < 2e-3);
    CHECK(e.attitude < 1e-4);  // symmetry of the grid; the sides take 1e-6
  }
}

TEST_CASE("TheFullFilmConvergesWithSecondOrder") {
  for (const double eps : {0.2, 0.6, 0.8}) {
    CAPTURE(eps);
    const SommerfeldErrors a = sommerfeld_errors(eps, 100), b = sommerfeld_errors(eps, 200);
    // design 6: within 0.15 of the scheme's order, against the exact solution.
    CHECK(std::abs(order_of_errors(a.load, b.load) - 2.0) < 0.15);
    CHECK(std::abs(order_of_errors(a.pressure, b.pressure) - 2.0) < 0.15);
  }
}

TEST_CASE("AnEndlesslyWideCavitatedFilmFollowsTheQuadrature") {
  for (const auto& row :
       shellback::test::read_csv("validation/data/long_bearing_reynolds_bc.csv")) {
    const double eps = row.at("eps");
    Setup s = wide(eps, 800);
    s.patches = {line_supply(s, kPi)};
    const PosedFilm b = make_bearing(s);
    const auto film = solve(b);
    REQUIRE(film.good());
    const auto c = characteristics(s, b, film.value, CavitatedShear::full);
    CAPTURE(eps);
    // Quadrature to 1e-10, six digits printed; the grid resolves the narrow gap by
    // sqrt(1 - eps)/0.008 cells, the rupture to one cell: 0.3 % and 0.1 deg.
    CHECK(std::abs(c.sommerfeld / row.at("own_S") - 1.0) < 3e-3);
    CHECK(std::abs(c.attitude - row.at("own_phi_deg")) < 0.1);
    CHECK(std::abs(c.friction / row.at("own_f") - 1.0) < 3e-3);
    CHECK(std::abs(c.inlet_flow / row.at("own_Q") - 1.0) < 3e-3);
    CHECK(std::abs(c.p_ratio / row.at("own_P_over_pmax") - 1.0) < 3e-3);
    // Rupture: the first empty cell after the start of the film.
    int i = 0;
    while (film.value.state.p[i] > 0.0) ++i;
    const double rupture = (b.scene.grid.phi_face[i] - b.scene.grid.phi_face[0]) * 180.0 / kPi;
    CHECK(std::abs(rupture - row.at("own_theta_rupture_deg")) < 360.0 / s.nt);
  }
}

TEST_CASE("AVeryNarrowBearingIsOcvirks") {
  for (const double eps : {0.2, 0.5, 0.8}) {
    CAPTURE(eps);
    double last = 0.0;
    for (const double ratio : {1.0 / 32.0, 1.0 / 64.0}) {
      Setup s;
      s.width = 2.0 * s.radius * ratio;
      s.position = eccentric(eps * s.clearance, 0.0);
      s.patches = {line_supply(s, kPi)};
      s.half = true;
      s.nt = 400;
      s.nz = 81;
      const PosedFilm b = make_bearing(s);
      const auto film = solve(b);
      REQUIRE(film.good());
      const auto c = characteristics(s, b, film.value, CavitatedShear::full);
      const double load = ratio * ratio * analytic::ocvirk_load(eps);
      const double error = std::abs(1.0 / (2.0 * kPi * c.sommerfeld) / load - 1.0);
      // Ocvirk leaves out circumferential pressure flow: an error of order (B/D)^2/(1 - eps),
      // 5 % at B/D = 1/8, eps = 0.8 (validation 3.3), a sixteenth of it at 1/32. The grid adds
      // 1.5/nz^2, the error of half-cell differences in a parabola: 2e-4.
      CHECK(error < 6e-3);
      if (last > 0.0) CHECK(error < 0.5 * last + 3e-4);
      CHECK(std::abs(c.attitude - analytic::ocvirk_attitude(eps) * 180.0 / kPi) < 0.3);
      last = error;
    }
  }
}

TEST_CASE("AConcentricFilmCarriesTheEdgePressure") {
  Setup s;
  s.p_edge = 2e5;
  s.patches = {{.phi = 1.0, .arc = 0.5, .length = 0.01, .pressure = 2e5}};
  const auto film = solve(make_bearing(s));
  REQUIRE(film.good());
  for (const double p : film.value.state.p) CHECK(std::abs(p - 2e5) < 1e-6);  // round-off of 2e5
}

TEST_CASE("PressureFlowBetweenGrooveAndEdgeIsHagenPoiseuilles") {
  // Concentric, so that motion makes no pressure; groove all round: two plane slots of length (B -
  // b)/2 and width 2 pi R.
  Setup s;
  s.nz = 21;
  const double groove = s.width / 3.0, supply = 4e5;
  s.patches = {{.arc = 2.0 * kPi, .length = groove, .pressure = supply}};
  for (const bool half : {false, true}) {
    s.half = half;
    const PosedFilm b = make_bearing(s);
    const auto film = solve(b);
    REQUIRE(film.good());
    const double slot = (s.width - groove) / 2.0;
    const double exact = 2.0 * s.density * 2.0 * kPi * s.radius * std::pow(s.clearance, 3) *
                         supply / (12.0 * s.viscosity * slot);
    CHECK(std::abs(oil_flows(b.scene, film.value.flow).side / exact - 1.0) < 1e-12);  // linear p
  }
}

TEST_CASE("PressureFlowOfBarusOilIsExact") {
  // The same with alpha p = 2: the flow is that of q = (1 - exp(-alpha p))/alpha, also on a grid.
  Setup s;
  s.nz = 9;
  s.barus = 5e-6;
  const double groove = s.width / 3.0, supply = 4e5;
  s.patches = {{.arc = 2.0 * kPi, .length = groove, .pressure = supply}};
  const PosedFilm b = make_bearing(s);
  const auto film = solve(b);
  REQUIRE(film.good());
  const double q = -std::expm1(-s.barus * supply) / s.barus;
  const double exact = 2.0 * s.density * 2.0 * kPi * s.radius * std::pow(s.clearance, 3) * q /
                       (12.0 * s.viscosity * (s.width - groove) / 2.0);
  CHECK(std::abs(oil_flows(b.scene, film.value.flow).side / exact - 1.0) < 1e-12);
}
