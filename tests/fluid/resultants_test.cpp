// Forces, moments and shear stresses against their definitions.
#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

Setup fine() {
  Setup s;
  s.nt = 90;
  s.nz = 40;
  return s;
}

template <class F>
Field sampled(const FilmGrid& g, F f) {
  Field out(static_cast<std::size_t>(g.cells()));
  for (int k = 0; k < g.cells(); ++k) out[k] = f(g.phi[k / g.nz], g.z[k % g.nz]);
  return out;
}

FilmState full_film(const Field& p) {
  return {p, Field(p.size(), 1.0), std::vector<char>(p.size(), 1)};
}

}  // namespace

TEST_CASE("PressurePushesTheJournalAwayFromIt") {
  // p = P cos(phi - a): F = -P R B pi (cos a, sin a), to round-off on an even grid.
  const double a = 0.8, P = 1e6;
  for (const bool half : {false, true}) {
    Setup s = fine();
    s.half = half;
    const PosedFilm b = make_bearing(s);
    const auto f = wrench(
        b.scene, sampled(b.scene.grid, [&](double phi, double) { return P * std::cos(phi - a); }));
    const double exact = P * s.radius * s.width * kPi;
    CHECK(std::abs(f[0] + exact * std::cos(a)) < 1e-12 * exact);
    CHECK(std::abs(f[1] + exact * std::sin(a)) < 1e-12 * exact);
    CHECK(std::abs(f[2]) + std::abs(f[3]) < 1e-12 * exact * s.width);
  }
}

TEST_CASE("PressureOutOfTheMiddleTiltsTheJournal") {
  // Moments are r x F: p = P cos(phi - a) z/B gives F(z) = -P R pi (cos a, sin a) z/B per length
  // and M = int z (-F_y, F_x) dz, with int z^2/B dz = B^2/12 (midpoints: B^2/12 (1 - 1/nz^2)).
  const Setup s = fine();
  const PosedFilm b = make_bearing(s);
  const double a = 0.8, P = 1e6;
  const auto f = wrench(b.scene, sampled(b.scene.grid, [&](double phi, double z) {
                          return P * std::cos(phi - a) * z / s.width;
                        }));
  const double exact = P * s.radius * kPi * s.width * s.width / 12.0 * (1.0 - 1.0 / (s.nz * s.nz));
  CHECK(std::abs(f[2] - exact * std::sin(a)) < 1e-12 * exact);
  CHECK(std::abs(f[3] + exact * std::cos(a)) < 1e-12 * exact);
}

TEST_CASE("TheWeightsOfTheWrenchAreTheSlopesOfTheGap") {
  // Virtual work: force times displacement = int p dh dA.
  Setup s = fine();
  s.position = {{3e-6, 2e-6, 1e-4, 1e-4}};
  const PosedFilm b = make_bearing(s);
  const FilmGrid& g = b.scene.grid;
  const Field p = random_field(g.cells(), 4, 0.0, 1e7);
  const Wrench f = wrench(b.scene, p);
  for (int k = 0; k < 4; ++k) {
    Setup t = s;
    const double step = k < 2 ? 1e-6 : 1e-4;
    t.position.q[k] += step;
    const PosedFilm moved = make_bearing(t);
    double work = 0.0;
    for (int c = 0; c < g.cells(); ++c) {
      work += p[c] * (moved.gap.cell[c] - b.gap.cell[c]) * g.area(c);
    }
    const double scale = 1e7 * s.radius * s.width * step * (k < 2 ? 1.0 : s.width);
    CHECK(std::abs(f[k] * step - work) < 1e-10 * scale);  // h has 1e-16 of 2e-5 over 1e-6
  }
}

TEST_CASE("TheShearStressOfAConcentricFilmIsPetroffs") {
  Setup s = fine();
  const PosedFilm b = make_bearing(s);
  const auto n = static_cast<std::size_t>(b.scene.grid.cells());
  const FilmState state = full_film(Field(n, 0.0));
  const ShearStress tau = shear_stress(b.scene, b.gap.cell, Field(n, 1.0 / s.viscosity),
                                       Field(n, 0.5), state, Field(n, 0.0), CavitatedShear::filled);
  const double exact =
      s.viscosity * s.speed / s.clearance * 2.0 * kPi * s.radius * s.width * s.radius;
  CHECK(std::abs(torque(b.scene, tau.journal) / exact - 1.0) < 1e-12);
  CHECK(std::abs(torque(b.scene, tau.shell) / exact - 1.0) < 1e-12);
}

TEST_CASE("StressesOfBothSurfacesBalanceThePressureGradient") {
  // Momentum of the film: tau_journal - tau_shell = hT dp/dx, rough or smooth, at any chi.
  for (const RoughPair& pair : {RoughPair{}, rough_pair({0.8e-6, 3.0}, {0.5e-6, 0.6})}) {
    Setup s = fine();
    s.rough = pair;
    s.position = eccentric(17e-6, 2.0);
    const PosedFilm b = make_bearing(s);
    const int n = b.scene.grid.cells();
    const FilmState state = full_film(Field(static_cast<std::size_t>(n), 0.0));
    const Field g0 = random_field(n, 1, 50.0, 200.0), chi = random_field(n, 2, 0.3, 0.7);
    const Field gradient = random_field(n, 3, -1e9, 1e9);
    const ShearStress tau =
        shear_stress(b.scene, b.gap.cell, g0, chi, state, gradient, CavitatedShear::filled);
    for (int k = 0; k < n; ++k) {
      const double exact = gap_flow(pair, b.gap.cell[k]).average_gap * gradient[k];
      CHECK(std::abs(tau.journal[k] - tau.shell[k] - exact) <
            1e-12 * std::abs(tau.journal[k]) + 1e-6);
    }
  }
}

TEST_CASE("AnEmptyFilmBrakesByItsFillRatio") {
  Setup s = fine();
  const PosedFilm b = make_bearing(s);
  const auto n = static_cast<std::size_t>(b.scene.grid.cells());
  FilmState state = full_film(Field(n, 0.0));
  state.theta.assign(n, 0.3);
  const auto braking = [&](CavitatedShear rule) {
    return torque(b.scene, shear_stress(b.scene, b.gap.cell, Field(n, 1.0 / s.viscosity),
                                        Field(n, 0.5), state, Field(n, 0.0), rule)
                               .journal);
  };
  CHECK(std::abs(braking(CavitatedShear::filled) / braking(CavitatedShear::full) - 0.3) < 1e-12);
}

TEST_CASE("WhatEntersBehindALineIsAsFullAsTheLine") {
  Setup s = fine();
  s.patches = {{.phi = 1.0, .length = s.width}};  // no arc: a line
  PosedFilm b = make_bearing(s);
  b.scene.supply.patches[0].fill = 0.7;  // a vessel that is empty
  const auto n = static_cast<std::size_t>(b.scene.grid.cells());
  FilmState state = full_film(Field(n, 0.0));
  state.theta.assign(n, 0.3);
  const Field fill = cell_fill(b.scene, state);
  int behind = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const bool fed = b.scene.supply.line[k] >= 0;
    behind += fed ? 1 : 0;
    CHECK(fill[k] == Approx(fed ? 0.5 : 0.3).epsilon(1e-12));  // mean of what enters and leaves
  }
  CHECK(behind == s.nz);
}

TEST_CASE("GradientsOfASmoothPressureAreExactToSecondOrder") {
  for (const bool half : {false, true}) {
    double last_x = 0.0, last_z = 0.0;
    for (const int refined : {1, 2}) {
      Setup s = fine();
      s.half = half;
      s.nt *= refined;
      s.nz *= refined;
      const PosedFilm b = make_bearing(s);
      const FilmGrid& g = b.scene.grid;
      const double k = kPi / s.width, P = 1e6;
      const FilmState state = full_film(sampled(
          g, [&](double phi, double z) { return P * (1.0 + std::sin(phi)) * std::cos(k * z); }));
      const Field x = pressure_gradient_x(b.scene, state), z = pressure_gradient_z(b.scene, state);
      double worst_x = 0.0, worst_z = 0.0;
      for (int c = 0; c < g.cells(); ++c) {
        const double phi = g.phi[c / g.nz], at = g.z[c % g.nz];
        worst_x =
            std::max(worst_x, std::abs(x[c] - P * std::cos(phi) * std::cos(k * at) / s.radius));
        worst_z =
            std::max(worst_z, std::abs(z[c] + k * P * (1.0 + std::sin(phi)) * std::sin(k * at)));
      }
      CHECK(worst_x < P / s.radius * std::pow(2.0 * kPi / s.nt, 2));
      CHECK(worst_z < 2.0 * P * k * std::pow(kPi / s.nz, 2));
      if (refined == 2) {
        CHECK(worst_x < 0.3 * last_x);
        CHECK(worst_z < 0.3 * last_z);
      }
      last_x = worst_x;
      last_z = worst_z;
    }
  }
}

TEST_CASE("GradientsSumToThePressureDifferenceBetweenSupplies") {
  // Along the ring from line to line: int dp/dx dx = p_2 - p_1, whatever lies between.
  Setup s = fine();
  s.patches = {line_supply(s, 1.0, 3e5), line_supply(s, 4.0, 1e5)};
  const PosedFilm b = make_bearing(s);
  const FilmGrid& g = b.scene.grid;
  const FilmState state = full_film(random_field(g.cells(), 8, 0.0, 1e6));
  const Field x = pressure_gradient_x(b.scene, state);
  for (int j = 0; j < g.nz; ++j) {
    double rise = 0.0;
    for (int i = 0; i < g.nt; ++i) {
      const double phi = std::fmod(g.phi[i], 2.0 * kPi);
      if (phi > 1.0 && phi < 4.0) rise += x[g.index(i, j)] * g.radius * g.dphi[i];
    }
    CHECK(std::abs(rise + 2e5) < 1e-8);  // round-off of 1e6
  }
}
