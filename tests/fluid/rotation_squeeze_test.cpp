// A journal that turns and is squeezed at once: Butenschoen's sum of the two, and its error.
//
// Butenschoen 1976 adds the force of the journal's rotation, at its attitude, and that of the
// squeeze along the line of centres. Of films with cavitation the sum is an upper bound: pressures
// that solve (1) p >= 0, A p >= b, p (A p - b) = 0 are the least of all with p >= 0, A p >= b (A an
// M-matrix), and the sum of two that solve it for b1 and b2 is one of these for b1 + b2.
#include <catch2/catch.hpp>

#include "tests/fluid/film_scenes.hpp"
#include "tests/observed_order.hpp"
#include "tests/read_csv.hpp"

using namespace shellback;
using namespace shellback::fluid;
using namespace shellback::fluid::tests;
using shellback::test::CsvRow;
using shellback::test::read_csv;
using shellback::test::richardson;

namespace {

constexpr double kTurning = 100.0;  // omega [rad/s]
constexpr double kRatio = 0.25;     // B/D, in both tables

/// So along and across the line of centres, So = F psi^2/(B D eta omega): on a journal at eps on
/// the +X axis, towards the middle, and the way round that its attitude turns.
using Load = std::array<double, 2>;

Load sum(const Load& a, const Load& b) { return {a[0] + b[0], a[1] + b[1]}; }

/// The film of a journal that turns with `turning` omega and moves out with `rate` omega c, full a
/// moment ago: nothing tells oil that is conserved from the tables' condition there.
FilmSolution moving_film(double eps, double turning, double rate, int nt, int nz,
                         PosedFilm* made = nullptr) {
  Setup s;
  s.width = 2.0 * s.radius * kRatio;
  s.position = eccentric(eps * s.clearance, 0.0);
  s.speed = turning * kTurning * s.radius;
  s.half = true;
  s.nt = nt;
  s.nz = nz;
  PosedFilm b = make_bearing(s);
  // In a step the journal turns and moves by a thousandth of a radian and of the clearance, or
  // less.
  const double dt = 1e-3 / kTurning;
  JournalPosition from = s.position;
  from.q[0] -= dt * rate * kTurning * s.clearance;
  const Gap gap = film_gap(b.scene.grid, b.scene.angles, s.clearance, from, {}, b.step);
  FilmCoefficients oil;
  const FilmState before = cold_film(b.scene);
  b.oil(before, oil);
  b.scene.storage = {dt, oil_content(b.scene, gap, oil, before)};
  const auto film = solve(b, {.tolerance = 1e-10});
  INFO(to_string(film.verdict.status));
  REQUIRE(film.good());
  if (made != nullptr) *made = b;
  return film.value;
}

Load load_on_grid(double eps, double turning, double rate, int nt, int nz) {
  PosedFilm b;
  const FilmSolution v = moving_film(eps, turning, rate, nt, nz, &b);
  const Setup s;
  const double psi = s.clearance / s.radius;
  const double D = 2.0 * s.radius;
  const double unit = kRatio * D * D * s.viscosity * kTurning / (psi * psi);
  const Wrench w = wrench(b.scene, v.state.p);
  return {-w[0] / unit, w[1] / unit};
}
Load load(double eps, double turning, double rate) {
  const Load a = load_on_grid(eps, turning, rate, 120, 16);
  const Load b = load_on_grid(eps, turning, rate, 240, 32);
  return {richardson(a[0], b[0]), richardson(a[1], b[1])};
}

/// Butenschoen's sum, from his tables.
Load butenschoen(double eps, double rate) {
  Load total{};
  for (const CsvRow& row : read_csv("validation/data/butenschoen_1976_rotation.csv")) {
    if (row.at("eps") != eps || row.at("B_over_D") != kRatio) continue;
    const double beta = row.at("own_beta_deg") * kPi / 180.0;
    total = {row.at("own_So") * std::cos(beta), row.at("own_So") * std::sin(beta)};
  }
  REQUIRE(total[0] > 0.0);
  const double along = rate < 0.0 ? -eps : eps;  // away from the near wall: the table's eps < 0
  for (const CsvRow& row : read_csv("validation/data/butenschoen_1976_squeeze.csv")) {
    if (row.at("eps") == along && row.at("B_over_D") == kRatio) total[0] += row.at("own_So") * rate;
  }
  return total;
}

/// So over (B/D)^2 of the short bearing's half film [-]: 2 int w/(1 - eps cos phi)^3 (cos, -sin)
/// dphi over where the gap closes, w = rate cos phi - turning eps sin phi/2 > 0, phi from the
/// nearest gap.
Load short_film(double eps, double turning, double rate) {
  constexpr int kPoints = 7200;
  Load So{};
  for (int k = 0; k < kPoints; ++k) {
    const double phi = 2.0 * kPi * (k + 0.5) / kPoints;
    const double closing = rate * std::cos(phi) - 0.5 * turning * eps * std::sin(phi);
    if (closing <= 0.0) continue;
    const double p = 2.0 * closing / std::pow(1.0 - eps * std::cos(phi), 3) * 2.0 * kPi / kPoints;
    So[0] += p * std::cos(phi);
    So[1] -= p * std::sin(phi);
  }
  return So;
}

}  // namespace

TEST_CASE("ATurningJournalThatIsSqueezedCarriesAsButenschoensSumLessItsError", "[squeeze]") {
  // The sum's error is large: 10 to 23 % of the load of a journal that comes nearer, up to 90 % of
  // one that goes away. At B/D = 1/4 it is that of the short bearing, whose film is known in closed
  // form, but for the part of the load by which finite bearings differ: less than a hundredth.
  for (const double eps : {0.3, 0.6, 0.8}) {
    for (const double rate : {-0.3, -0.1, -0.02, 0.0, 0.02, 0.1, 0.3}) {  // over omega
      const Load own = load(eps, 1.0, rate);
      const Load table = butenschoen(eps, rate);
      const Load shorter = short_film(eps, 1.0, rate);
      const Load shorter_sum = sum(short_film(eps, 1.0, 0.0), short_film(eps, 0.0, rate));
      const double T = std::hypot(table[0], table[1]);
      const double S = std::hypot(shorter_sum[0], shorter_sum[1]);
      const Load error{(own[0] - table[0]) / T, (own[1] - table[1]) / T};
      const Load known{(shorter[0] - shorter_sum[0]) / S, (shorter[1] - shorter_sum[1]) / S};
      INFO("eps " << eps << ", rate " << rate << ": the sum is off by "
                  << std::hypot(error[0], error[1]) << ", of the short bearing by "
                  << std::hypot(known[0], known[1]));
      CHECK(std::hypot(error[0] - known[0], error[1] - known[1]) < 0.01);
      if (rate == 0.0) CHECK(std::hypot(error[0], error[1]) < 5e-3);  // the table itself: design 6
    }
  }
}

TEST_CASE("NowhereIsThePressureAboveTheSumOfRotationAndSqueeze", "[squeeze]") {
  for (const double eps : {0.3, 0.8}) {
    for (const double rate : {-0.3, -0.05, 0.05, 0.3}) {
      const FilmSolution turns = moving_film(eps, 1.0, 0.0, 120, 16);
      const FilmSolution squeezed = moving_film(eps, 0.0, rate, 120, 16);
      const FilmSolution both = moving_film(eps, 1.0, rate, 120, 16);
      double most = 0.0;
      double above = 0.0;
      for (std::size_t k = 0; k < both.state.p.size(); ++k) {
        most = std::max(most, both.state.p[k]);
        above = std::max(above, both.state.p[k] - turns.state.p[k] - squeezed.state.p[k]);
      }
      INFO("eps " << eps << ", rate " << rate << ": above by " << above / most);
      CHECK(above < 1e-4 * most);  // what the oil held back in the one step may make
    }
  }
}
