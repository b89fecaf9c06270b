// The film does not know where +X points, which way is up, or in which units we count.
#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

constexpr double kDegree = kPi / 180.0;
/// Newton stops at residuals of 1e-12 of the flow or below; pressures feel them through the film's
/// conductance, of order nt nz: 1e-9.
constexpr double kSame = 1e-9;

Setup tilted_with_a_groove() {
  Setup s;
  s.nt = 72;
  s.nz = 12;
  s.position = {{2e-6, -12e-6, 2e-4, -1e-4}};
  s.p_cavitation = -5e4;
  s.barus = 1e-8;
  s.patches = {{.phi = 100.0 * kDegree,
                .z = 2.5e-3,
                .arc = 20.0 * kDegree,
                .length = 5e-3,
                .pressure = 3e5}};
  return s;
}

struct FoundFilm {
  PosedFilm bearing;
  FilmSolution value;
  Wrench force;
};

FoundFilm film_of(const Setup& s) {
  FoundFilm f{make_bearing(s), {}, {}};
  auto film = solve(f.bearing);
  REQUIRE(film.good());
  f.value = std::move(film.value);
  f.force = wrench(f.bearing.scene, f.value.state.p);
  return f;
}

/// The set-up turned about the bearing axis.
Setup turned(Setup s, double angle) {
  const double c = std::cos(angle), n = std::sin(angle);
  const auto q = s.position.q;
  s.position.q = {c * q[0] - n * q[1], n * q[0] + c * q[1], c * q[2] - n * q[3],
                  n * q[2] + c * q[3]};
  for (SupplyPatch& p : s.patches) p.phi += angle;
  if (s.profile) {
    s.profile = [profile = s.profile, angle](double phi, double z) {
      return profile(phi - angle, z);
    };
  }
  return s;
}

/// Force and moment must turn along; returns the largest deviation relative to the force.
double force_deviation(const FoundFilm& a, const FoundFilm& b, double angle, double width) {
  const double c = std::cos(angle), n = std::sin(angle);
  const Wrench f = a.force, g = b.force;
  const double force = std::hypot(f[0], f[1]);
  const double x = std::abs(c * f[0] - n * f[1] - g[0]), y = std::abs(n * f[0] + c * f[1] - g[1]);
  const double mx = std::abs(c * f[2] - n * f[3] - g[2]) / width;
  const double my = std::abs(n * f[2] + c * f[3] - g[3]) / width;
  return std::max({x, y, mx, my}) / force;
}

double value_at(const FilmGrid& g, const Field& f, double phi, int j) {
  for (int i = 0; i < g.nt; ++i) {
    if (std::abs(std::remainder(g.phi[i] - phi, 2.0 * kPi)) < 1e-9) return f[g.index(i, j)];
  }
  return std::nan("");
}

}  // namespace

TEST_CASE("TurningByWholeCellsChangesNothing") {
  Setup s = tilted_with_a_groove();
  s.profile = [](double phi, double z) { return 2e-6 * (1.0 + std::sin(3.0 * phi + 300.0 * z)); };
  const FoundFilm a = film_of(s);
  const double peak = largest_magnitude(a.value.state.p);
  for (const int cells : {1, 18, 41}) {
    const double angle = 2.0 * kPi * cells / s.nt;
    const FoundFilm b = film_of(turned(s, angle));
    CHECK(force_deviation(a, b, angle, s.width) < kSame);
    const FilmGrid& g = a.bearing.scene.grid;
    double worst = 0.0, emptier = 0.0;
    for (int i = 0; i < g.nt; ++i) {
      for (int j = 0; j < g.nz; ++j) {
        const int k = g.index(i, j);
        const double at = g.phi[i] + angle;
        const double p = value_at(b.bearing.scene.grid, b.value.state.p, at, j);
        const double theta = value_at(b.bearing.scene.grid, b.value.state.theta, at, j);
        worst = std::max(worst, std::abs(p - a.value.state.p[k]));
        emptier = std::max(emptier, std::abs(theta - a.value.state.theta[k]));
        REQUIRE(std::isfinite(p));
      }
    }
    CHECK(worst < kSame * peak);
    CHECK(emptier < kSame);
  }
}

TEST_CASE("TurningByAnyAngleChangesNoMoreThanTheGrid") {
  // Without features on faces the grid stays where it is and the film moves across it.
  Setup s = tilted_with_a_groove();
  s.patches = {{.arc = 2.0 * kPi, .length = 2.0 * s.width / s.nz, .pressure = 3e5}};
  double last = 0.0;
  for (const int nt : {72, 144, 288}) {
    s.nt = nt;
    const FoundFilm a = film_of(s);
    double worst = 0.0;
    for (const double part : {0.21, 0.5, 0.77}) {
      const double angle = 1.0 + part * 2.0 * kPi / nt;
      worst = std::max(worst, force_deviation(a, film_of(turned(s, angle)), angle, s.width));
    }
    CHECK(worst < 10.0 * std::pow(2.0 * kPi / nt, 2));  // second order, fronts included
    if (last > 0.0) CHECK(worst < 0.6 * last);
    last = worst;
  }
}

TEST_CASE("AMirroredBearingThatRunsBackwardsHasTheMirroredFilm") {
  // phi -> -phi: Y changes sign, rotations about X too.
  const Setup s = tilted_with_a_groove();
  Setup m = s;
  m.speed = -s.speed;
  m.position.q = {s.position.ex(), -s.position.ey(), -s.position.psi_x(), s.position.psi_y()};
  m.patches[0].phi = -s.patches[0].phi;
  const FoundFilm a = film_of(s), b = film_of(m);
  const double force = std::hypot(a.force[0], a.force[1]);
  CHECK(std::abs(a.force[0] - b.force[0]) < kSame * force);
  CHECK(std::abs(a.force[1] + b.force[1]) < kSame * force);
  CHECK(std::abs(a.force[2] + b.force[2]) < kSame * force * s.width);
  CHECK(std::abs(a.force[3] - b.force[3]) < kSame * force * s.width);
  const FilmGrid& g = a.bearing.scene.grid;
  const double peak = largest_magnitude(a.value.state.p);
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int k = g.index(i, j);
      const FilmGrid& h = b.bearing.scene.grid;
      CHECK(std::abs(value_at(h, b.value.state.p, -g.phi[i], j) - a.value.state.p[k]) <
            kSame * peak);
      CHECK(std::abs(value_at(h, b.value.state.theta, -g.phi[i], j) - a.value.state.theta[k]) <
            kSame);
    }
  }
}

TEST_CASE("ABearingTurnedEndForEndHasTheFilmTurnedEndForEnd") {
  // z -> -z: rotations about X and Y change sign.
  const Setup s = tilted_with_a_groove();
  Setup m = s;
  m.position.q = {s.position.ex(), s.position.ey(), -s.position.psi_x(), -s.position.psi_y()};
  m.patches[0].z = -s.patches[0].z;
  const FoundFilm a = film_of(s), b = film_of(m);
  const FilmGrid& g = a.bearing.scene.grid;
  const double peak = largest_magnitude(a.value.state.p);
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const double p = b.value.state.p[g.index(i, g.nz - 1 - j)];
      CHECK(std::abs(p - a.value.state.p[g.index(i, j)]) < kSame * peak);
    }
  }
}

TEST_CASE("HalfABearingCarriesHalfTheFilm") {
  Setup s = tilted_with_a_groove();
  s.position = eccentric(12e-6, 5.0);
  s.rough = rough_pair({0.4e-6, 3.0}, {0.3e-6, 1.0});
  for (const int nz : {10, 15, 20, 25}) {
    CAPTURE(nz);
    // A groove as long as a whole number of even cells that lies symmetric in the grid.
    const int covered = nz % 2 == 0 ? 4 : 5;
    s.patches = {{.phi = 1.7, .arc = 0.4, .length = s.width * covered / nz, .pressure = 3e5}};
    s.nz = nz;
    s.half = false;
    const FoundFilm full = film_of(s);
    s.half = true;
    const FoundFilm half = film_of(s);
    const Field p = mirror_to_full(half.bearing.scene.grid, half.value.state.p);
    const Field theta = mirror_to_full(half.bearing.scene.grid, half.value.state.theta);
    // The same discrete equations: only the order of the elimination differs.
    CHECK(largest_difference(p, full.value.state.p) < 1e-10 * largest_magnitude(p));
    CHECK(largest_difference(theta, full.value.state.theta) < 1e-10);
    for (const int k : {0, 1}) {
      CHECK(std::abs(half.force[k] - full.force[k]) < 1e-10 * std::abs(full.force[1]));
    }
    const double a = oil_flows(half.bearing.scene, half.value.flow).side;
    const double b = oil_flows(full.bearing.scene, full.value.flow).side;
    CHECK(std::abs(a - b) < 1e-10 * std::abs(b));
    // A symmetric film does not tilt the shaft.
    CHECK(std::abs(full.force[2]) < 1e-10 * s.width * std::abs(full.force[1]));
  }
}

TEST_CASE("PressureScalesWithViscosityAndSpeed") {
  Setup s = tilted_with_a_groove();
  s.barus = 0.0;
  const FoundFilm a = film_of(s);
  Setup t = s;
  t.viscosity *= 7.0;
  t.speed *= 3.0;
  t.p_cavitation *= 21.0;
  t.patches[0].pressure *= 21.0;
  const FoundFilm b = film_of(t);
  const double peak = largest_magnitude(b.value.state.p);
  for (std::size_t k = 0; k < a.value.state.p.size(); ++k) {
    CHECK(std::abs(21.0 * a.value.state.p[k] - b.value.state.p[k]) < kSame * peak);
    CHECK(std::abs(a.value.state.theta[k] - b.value.state.theta[k]) < kSame);
  }
}

TEST_CASE("OnlyTheProportionsOfTheBearingMatter") {
  // All lengths times 5, the speed too: p ~ eta U R/c^2 and the flow ~ rho U c B.
  Setup s = tilted_with_a_groove();
  Setup t = s;
  t.radius *= 5.0;
  t.width *= 5.0;
  t.clearance *= 5.0;
  t.speed *= 5.0;
  for (const int k : {0, 1}) t.position.q[k] *= 5.0;
  t.patches[0].z *= 5.0;
  t.patches[0].length *= 5.0;
  const FoundFilm a = film_of(s), b = film_of(t);
  CHECK(largest_difference(a.value.state.p, b.value.state.p) <
        kSame * largest_magnitude(a.value.state.p));
  const double side = oil_flows(a.bearing.scene, a.value.flow).side;
  const double large = oil_flows(b.bearing.scene, b.value.flow).side;
  CHECK(std::abs(large / side / 125.0 - 1.0) < 1e-7);  // a difference of outflow and inflow
}

TEST_CASE("TheZeroOfPressureIsFree") {
  // Isoviscous film: a constant added to all given pressures is added to the film's.
  Setup s = tilted_with_a_groove();
  s.barus = 0.0;
  const FoundFilm a = film_of(s);
  Setup t = s;
  const double shift = 1e5;
  t.p_edge += shift;
  t.p_cavitation += shift;
  t.patches[0].pressure += shift;
  const FoundFilm b = film_of(t);
  for (std::size_t k = 0; k < a.value.state.p.size(); ++k) {
    CHECK(std::abs(a.value.state.p[k] + shift - b.value.state.p[k]) <
          kSame * largest_magnitude(a.value.state.p));
  }
}
