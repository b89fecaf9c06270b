// Fronts of oil that wander in a cavitated film: what is carried out of a cell.
#include "fluid/fill_front.hpp"

#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;

namespace {

/// A concentric journal whose film is cavitated all round: its oil goes round with half the
/// journal's speed. So wide that nothing flows sideways.
PosedFilm ring(int cells, double speed = 10.0) {
  Setup s;
  s.width = 1e3;
  s.half = true;
  s.nt = cells;
  s.nz = 2;
  s.speed = speed;
  return make_bearing(s);
}

using Profile = std::function<double(double phi)>;

FilmState filled(const FilmGrid& g, const Profile& theta) {
  FilmState film{Field(g.cells(), 0.0), Field(g.cells()), std::vector<char>(g.cells(), 0)};
  for (int k = 0; k < g.cells(); ++k) film.theta[k] = theta(g.phi[k / g.nz]);
  return film;
}

/// Flows of the film in a step in time, which begins with what the film holds.
FilmFlow flow_of(PosedFilm b, const FilmState& film) {
  FilmCoefficients oil;
  b.oil(film, oil);
  if (!b.scene.storage.finite()) {
    b.scene.storage.dt = 1.0;
    b.scene.storage.before = oil_content(b.scene, b.gap, oil, film);
  }
  FilmFlow flow;
  evaluate_flow(b.scene, b.gap, b.step, oil, film, flow);
  return flow;
}

/// A band of nine tenths of oil, over oil of a fifth.
double band(double phi) {
  const double turned = phi - 2.0 * kPi * std::floor(phi / (2.0 * kPi));
  return turned > 0.4 && turned < 1.8 ? 0.9 : 0.2;
}

/// Mean of |theta - exact| after the band has gone half round.
double error_half_round(int cells, bool sharpened) {
  constexpr double kCellsPerStep = 0.05;  // backward Euler widens a front, too: little
  PosedFilm b = ring(cells);
  const FilmGrid& g = b.scene.grid;
  const double per_step = kCellsPerStep * 2.0 * kPi / cells;
  const int steps = static_cast<int>(std::lround(kPi / per_step));
  const double dt = 2.0 * per_step * g.radius / b.scene.speed;
  FilmState film = filled(g, band);
  for (int n = 0; n < steps; ++n) {
    FilmCoefficients oil;
    b.oil(film, oil);
    b.scene.storage = {dt, oil_content(b.scene, b.gap, oil, film)};
    if (sharpened) b.scene.storage.front = fill_fronts(b.scene, film, flow_of(b, film));
    const auto found = solve_reynolds(b.scene, b.gap, b.step, b.oil, film, {.tolerance = 1e-10});
    REQUIRE(found.good());
    film = found.value.state;
  }
  double error = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    const double theta = film.theta[g.index(i, 0)];
    CHECK(theta > 0.2 - 1e-6);
    CHECK(theta < 0.9 + 1e-6);
    error += std::abs(theta - band(g.phi[i] - steps * per_step)) / g.nt;
  }
  return error;
}

}  // namespace

TEST_CASE("WhatIsCarriedLiesBetweenNothingAndFullFilmAndRisesWithTheFill", "[front]") {
  for (const double front : {-0.5, -0.3, 0.0, 0.4, 1.0}) {
    CHECK(carried_fill(0.0, front).value == 0.0);
    CHECK(carried_fill(1.0, front).value == 1.0);
    for (double theta = 0.05; theta < 1.0; theta += 0.05) {
      const CarriedFill c = carried_fill(theta, front);
      INFO("theta " << theta << ", f " << front);
      CHECK(c.value >= 0.0);
      CHECK(c.value <= 1.0);
      CHECK(c.slope >= 0.5);
      CHECK(c.slope <= 2.0);
      constexpr double kStep = 1e-4;  // its square times the third derivative: 2e-8 and less
      const double difference =
          (carried_fill(theta + kStep, front).value - carried_fill(theta - kStep, front).value) /
          (2.0 * kStep);
      CHECK(c.slope == Approx(difference).epsilon(1e-7));
    }
  }
}

TEST_CASE("SmoothOilIsCarriedWithSecondOrder", "[front]") {
  const Profile wave = [](double phi) { return 0.5 + 0.2 * std::sin(phi); };
  const auto error = [&](int cells) {
    const PosedFilm b = ring(cells);
    const FilmGrid& g = b.scene.grid;
    const FilmState film = filled(g, wave);
    const Field front = fill_fronts(b.scene, film, flow_of(b, film));
    double mean = 0.0;
    for (int i = 0; i < g.nt; ++i) {
      const int k = g.index(i, 0);
      mean +=
          std::abs(carried_fill(film.theta[k], front[k]).value - wave(g.phi_face[i + 1])) / g.nt;
    }
    return mean;
  };
  // Van Leer's limiter is of first order in a few cells at the two extremes, which is of second
  // order in the mean.
  CHECK(std::log2(error(100) / error(200)) == Approx(2.0).margin(0.15));
}

TEST_CASE("AFrontThatWandersHalfRoundStaysSharp", "[front]") {
  const double coarse = error_half_round(60, true), fine = error_half_round(120, true);
  // Fronts of a limiter of second order widen with the third root of their way: order 2/3. With
  // each cell's own fill ratio it is the square root.
  CHECK(std::log2(coarse / fine) > 0.6);
  CHECK(coarse < 0.5 * error_half_round(60, false));
}

TEST_CASE("OilIsCarriedAsItIsWhateverTheGap", "[front]") {
  // The same oil everywhere, in a gap that changes: its flow is the same everywhere, at the mean
  // speed of the surfaces [textbook].
  constexpr double kOil = 0.3;  // of the film at its smallest gap
  const auto error = [&](int cells, bool with_fronts) {
    Setup setup;
    setup.half = true;
    setup.nt = cells;
    setup.nz = 2;
    setup.position = eccentric(0.8 * setup.clearance, 1.0);
    PosedFilm b = make_bearing(setup);
    const FilmGrid& g = b.scene.grid;
    const double height = kOil * 0.2 * setup.clearance;
    FilmState film = filled(g, [](double) { return 1.0; });
    for (int k = 0; k < g.cells(); ++k) film.theta[k] = height / b.gap.cell[k];
    if (with_fronts) b.scene.storage.front = fill_fronts(b.scene, film, flow_of(b, film));
    const FilmFlow flow = flow_of(b, film);
    const double expected = setup.density * height * 0.5 * setup.speed * g.dz[0];
    double worst = 0.0;
    for (int k = 0; k < g.cells(); ++k) {
      worst = std::max(worst, std::abs(flow.phi[k].carried / expected - 1.0));
    }
    return worst;
  };
  CHECK(std::log2(error(48, true) / error(96, true)) == Approx(2.0).margin(0.15));
  CHECK(std::log2(error(48, false) / error(96, false)) == Approx(1.0).margin(0.15));
}

TEST_CASE("AJournalThatTurnsBackHasTheMirroredFronts", "[front]") {
  const PosedFilm ahead = ring(48), back = ring(48, -10.0);
  const FilmGrid& g = ahead.scene.grid;
  const auto theta = [](double phi) { return 0.5 + 0.3 * std::sin(phi) + 0.1 * std::cos(2 * phi); };
  const FilmState film = filled(g, theta);
  const FilmState mirrored = filled(g, [&](double phi) { return theta(2.0 * kPi - phi); });
  const Field a = fill_fronts(ahead.scene, film, flow_of(ahead, film));
  const Field b = fill_fronts(back.scene, mirrored, flow_of(back, mirrored));
  double largest = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    CHECK(b[g.index(g.nt - 1 - i, 0)] == Approx(a[g.index(i, 0)]).epsilon(1e-9).margin(1e-12));
    largest = std::max(largest, std::abs(a[g.index(i, 0)]));
  }
  CHECK(largest > 0.05);
}
