/// Heat between the oil of supplies and the walls: closed forms, balance, limits.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/thermal/film_ring.hpp"

using namespace shellback;
using namespace shellback::thermal;
using namespace shellback::thermal::tests;

namespace {

constexpr double kIn = 320.0, kWall = 380.0, kFlow = 2e-4, kCp = 2000.0;

/// A ring of `count` grooves and, between them, film that neither conducts nor heats: oil enters
/// the first at kIn and passes from each to the next. All grooves together take `units` of
/// h A / (m cp) of the walls.
Ring grooves_in_a_row(int count, double units) {
  Ring r(2 * count, 1, 5);
  const double area = 2.0 * r.grid.area(0, 0);  // shell and shaft
  for (int c = 0; c < r.grid.cells(); ++c) {
    r.west_flow(c, [](double s) { return 6.0 * kFlow * s * (1.0 - s); });
    if (c % 2 != 0) continue;
    r.problem.patch[c] = c / 2;
    SupplyVessel v{kIn, kCp, kCp, c == 0 ? 0.0 : 1.0, 0.0};
    v.heat_transfer = units * kFlow * kCp / (count * area);
    r.problem.vessels.push_back(v);
  }
  r.set_walls(kWall, kWall);
  return r;
}

double leaves(Ring& r) {
  FilmEnergy film = r.film();
  settle(film, r.T);
  return film.mix_temperatures().back();
}

}  // namespace

TEST_CASE("AGrooveApproachesItsWalls", "[film_vessels]") {
  for (const double units : {0.3, 2.0, 20.0}) {
    Ring one = grooves_in_a_row(2, 2.0 * units);  // the last of two; the first counts apart
    const double first = kWall + (kIn - kWall) / (1.0 + units);
    CHECK(leaves(one) == Approx(kWall + (first - kWall) / (1.0 + units)).epsilon(1e-12));
  }
}

TEST_CASE("ALongGrooveApproachesItsWallsExponentially", "[film_vessels]") {
  // cut into N vessels: (1 + x/N)^-N = exp(-x) (1 + x^2/(2 N) + ...)
  const double x = 1.5;
  std::vector<double> error;
  for (const int count : {16, 32, 64}) {
    Ring r = grooves_in_a_row(count, x);
    const double left = (leaves(r) - kWall) / (kIn - kWall);
    CHECK(left == Approx(std::pow(1.0 + x / count, -count)).epsilon(1e-11));
    error.push_back(left - std::exp(-x));
  }
  CHECK(std::log2(error[0] / error[1]) == Approx(1.0).margin(0.15));
  CHECK(std::log2(error[1] / error[2]) == Approx(1.0).margin(0.15));
}

TEST_CASE("OilDrawnOffAlongAGrooveLeavesAsFromOneVessel", "[film_vessels]") {
  // m = m0 (1 - x): m0 cp (1 - x) T' = -h A (T - T_wall), T - T_wall = (1 - x)^N of the first
  for (const double N : {0.2, 1.0, 5.0}) {
    double mean = 0.0;
    constexpr int kParts = 4000;
    for (int i = 0; i < kParts; ++i) mean += std::pow(1.0 - (i + 0.5) / kParts, N) / kParts;
    CHECK(mean == Approx(1.0 / (1.0 + N)).epsilon(1e-5));  // midpoint rule, second order
  }
}

TEST_CASE("ASupplyIsAsWarmAsTheHeatOfItsOwnOilMakesIt", "[film_vessels]") {
  // O cp (T - T_fed) + h A (T - T_wall) = q exp(-b (T - T_sheared)): by bisection.
  for (const double sheared : {0.5, 20.0, 3e3}) {
    for (const double T_sheared : {240.0, kIn, 400.0}) {
      Ring r = grooves_in_a_row(2, 0.4);
      const double hA = 0.4 * kFlow * kCp / 2.0;
      SupplyVessel& first = r.problem.vessels[0];
      first.heat = 0.3 + sheared;
      first.sheared = sheared;
      first.T_sheared = T_sheared;
      first.thinning = 0.09;
      FilmEnergy film = r.film();
      settle(film, r.T);
      double low = 100.0, high = 1e4;
      while (high - low > 1e-10) {
        const double T = 0.5 * (low + high);
        const double made = 0.3 + sheared * std::exp(-0.09 * (T - T_sheared));
        (kFlow * kCp * (T - kIn) + hA * (T - kWall) < made ? low : high) = T;
      }
      CHECK(film.mix_temperatures()[0] == Approx(low).epsilon(1e-11));
      const EnergyBalance b = film.balance(r.T);
      CHECK(b.heat == Approx(first.heat + film.heat_of_thinning()).epsilon(1e-12));
      CHECK(std::abs(b.imbalance()) < 1e-9 * (std::abs(b.carried_in) + b.heat));
    }
  }
}

TEST_CASE("WallsOfGroovesReceiveWhatTheOilLoses", "[film_vessels]") {
  for (const double units : {0.0, 0.7, 5.0}) {
    Ring r = grooves_in_a_row(3, units);
    r.set_walls(350.0, 345.0);
    FilmEnergy film = r.film();
    settle(film, r.T);
    const EnergyBalance b = film.balance(r.T);
    const double carried = kFlow * kCp * (film.mix_temperatures().back() - kIn);
    CHECK(-(b.to_shell + b.to_shaft) == Approx(carried).margin(1e-10));
    CHECK(std::abs(b.imbalance()) < 1e-12 * (b.carried_in + b.carried_out));
    const WallHeat q = film.wall_heat(r.T);
    const double mixed = film.mix_temperatures()[1], A = r.grid.area(2, 0);
    const double h = r.problem.vessels[1].heat_transfer;
    CHECK(q.shell[2] == Approx(h * A * (mixed - 350.0)).margin(1e-12));
    CHECK(q.shaft[2] == Approx(h * A * (mixed - 345.0)).margin(1e-12));
    if (units > 0.0) CHECK(r.T[r.at(2, 0)] == 350.0);  // walls stay, the oil between is mixed
    CHECK(r.T[r.at(2, 2)] == mixed);
  }
}

TEST_CASE("GroovesWithoutFlowTakeTheirWallsTemperature", "[film_vessels]") {
  Ring r(8, 1, 5);
  r.problem.patch[3] = 0;
  r.problem.vessels = {{kIn, kCp, kCp, 1.0, 0.0}};
  r.problem.vessels[0].heat_transfer = 400.0;
  for (double& K : r.problem.conductance) K = 0.01;
  r.set_walls(350.0, 340.0);
  FilmEnergy film = r.film();
  settle(film, r.T);
  CHECK(film.mix_temperatures()[0] == Approx(345.0).epsilon(1e-13));
}

TEST_CASE("AYieldingShellWarmsByTheHeatOfTheGroove", "[film_vessels]") {
  Ring r = grooves_in_a_row(2, 1.0);
  const double Z = 3e-4;
  Field free(static_cast<std::size_t>(r.grid.cells()), 360.0);
  r.problem.shell = YieldingShell{Z, free, Field(free.size(), 0.0)};
  // it yields only by heat: with it, storage and film apart
  for (double& K : r.problem.conductance) K = 1e-3;
  FilmEnergy film = r.film();
  settle(film, r.T);
  const WallHeat q = film.wall_heat(r.T);
  for (const int c : {0, 2}) {
    CHECK(r.T[r.at(c, 0)] == Approx(360.0 + Z * q.shell[c] / r.grid.area(c, 0)).epsilon(1e-12));
  }
  CHECK(std::abs(q.shell[2]) > 1e-3);  // [W]
  const EnergyBalance b = film.balance(r.T);
  CHECK(std::abs(b.imbalance()) < 1e-11 * (b.carried_in + b.carried_out));
}
