#include "thermal/film_energy.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/thermal/film_ring.hpp"

using namespace shellback;
using namespace shellback::thermal;
using namespace shellback::thermal::tests;

namespace {

/// A ring of cells that widen and narrow in turn: oil moves across the film, but the temperature
/// T(s) is the same everywhere. Heat is what the exact polynomial asks for.
struct Polynomial {
  static double T(double s) { return 300.0 + s * (40.0 + s * (-90.0 + s * (55.0 + s * 20.0))); }
  static double dT(double s) { return 40.0 + s * (-180.0 + s * (165.0 + s * 80.0)); }
  static double d2T(double s) { return -180.0 + s * (330.0 + s * 240.0); }
};

Ring manufactured_ring(int n) {
  Ring r(8, 1, n);
  const double cp = 2000.0;
  const double swing = 2e-5;  // [kg/s]
  for (int c = 0; c < r.grid.cells(); ++c) {
    const double up = c % 2 ? 1.0 : 0.0;
    r.problem.conductance[c] = 0.05;
    r.west_flow(c, [&](double s) { return 4e-5 + up * swing * (s - 0.5); });
    const double turn = c % 2 ? -1.0 : 1.0;  // outflow minus inflow of the cell: turn swing (s-1/2)
    for (int k = 0; k < n; ++k) {
      const double s = r.gl.s[k];
      const double V = -turn * swing * 0.5 * s * (s - 1.0);  // minus the integral of that
      r.problem.heat[r.at(c, k)] =
          r.gl.w[k] * (cp * V * Polynomial::dT(s) - 0.05 * Polynomial::d2T(s));
    }
  }
  r.set_walls(Polynomial::T(0.0), Polynomial::T(1.0));
  return r;
}

/// A film with two grooves and a line, random flows, heat and conductances.
Ring random_bearing(unsigned seed, double carry_over, double scatter) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Ring r(16, 5, 5);
  const FilmGrid& g = r.grid;
  for (const int i : {2, 3}) {
    for (const int j : {1, 2, 3}) r.problem.patch[g.index(i, j)] = 0;
  }
  for (const int j : {0, 1, 2, 3, 4}) r.problem.patch[g.index(9, j)] = 1;
  random_flows(r, 1e-4, scatter, engine);
  random_conduction(r, 0.05, engine);
  for (const int j : {1, 2}) {  // a line on two faces: the same mass leaves and enters
    const int c = g.index(6, j);
    r.problem.line[c] = 2;
    const std::size_t first = r.at(c, 0);
    const auto begin = r.problem.phi_flow.begin() + static_cast<std::ptrdiff_t>(first);
    r.problem.lines.push_back({c, 2, std::vector<double>(begin, begin + 5)});
  }
  r.problem.vessels = {{320.0, 2000.0, 2100.0, carry_over, 0.3},
                       {305.0, 1900.0, 2000.0, carry_over, 0.0},
                       {310.0, 1950.0, 1950.0, 0.5, 0.1}};
  for (double& cp : r.problem.cp) cp = 1900.0 + 200.0 * uniform(engine);
  for (int c = 0; c < g.cells(); ++c) {
    for (int k = 0; k < 5; ++k) {
      r.T[r.at(c, k)] = 300.0 + 20.0 * uniform(engine);  // walls keep it, the film forgets
      if (r.problem.patch[c] < 0) r.problem.heat[r.at(c, k)] = 0.4 * uniform(engine);
    }
  }
  return r;
}

/// A ring with one groove, strong random flows across each other and next to no conduction.
Ring wild_ring(int n, unsigned seed) {
  std::mt19937 engine(seed);
  Ring r(16, 5, n);
  for (const int j : {1, 2, 3}) r.problem.patch[r.grid.index(4, j)] = 0;
  random_flows(r, 1e-4, 1.5, engine);  // scatter above the mean: backflow as well
  random_conduction(r, 1e-4, engine);  // a two-thousandth of what the flow carries
  return r;
}

double mean_change(const FilmGrid& g, const Field& a, const Field& b) {
  double sum = 0.0;
  double area = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      sum += a[g.index(i, j)] - b[g.index(i, j)];
      area += g.area(i, j);
    }
  }
  return sum / area;
}

}  // namespace

TEST_CASE("PolynomialTemperaturesAreExact", "[film_energy]") {
  for (const int n : {7, 9, 12}) {  // degree of V times T is 6: n - 1 and above
    Ring r = manufactured_ring(n);
    FilmEnergy film = r.film();
    settle(film, r.T);
    double error = 0.0;
    for (int c = 0; c < r.grid.cells(); ++c) {
      for (int k = 0; k < n; ++k) {
        error = std::max(error, std::abs(r.T[r.at(c, k)] - Polynomial::T(r.gl.s[k])));
      }
    }
    CHECK(error < 1e-9);  // round-off of 300 K through D, whose entries reach n^2
  }
}

TEST_CASE("UniformTemperatureStaysUniform", "[film_energy]") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::mt19937 engine(seed);
    Ring r(12, 5, 6);
    for (const int j : {1, 2, 3}) r.problem.patch[r.grid.index(4, j)] = 0;
    random_flows(r, 1e-4, 1.5, engine);  // scatter above the mean: backflow as well
    random_conduction(r, 0.05, engine);
    const double warm = 350.0;
    r.problem.T_edge = warm;
    r.problem.vessels.push_back({warm, 2000.0, 2000.0, 1.0, 0.0});
    const double fed = 3e-5;  // into one cell, through the next one, and out of the third
    r.problem.fed = {{r.grid.index(8, 2), 0, fed}, {r.grid.index(10, 2), 0, -fed}};
    for (const int i : {9, 10}) {
      for (int k = 0; k < r.gl.n; ++k) r.problem.phi_flow[r.at(r.grid.index(i, 2), k)] += fed;
    }
    for (double& T : r.T) T = warm;
    FilmEnergy film = r.film();
    CHECK(film.backflow_nodes() > 0);
    double change = 0.0;
    for (int k = 0; k < 5; ++k) change = std::max(change, film.sweep(r.T));
    CHECK(change < 1e-10);  // round-off of 50 K of enthalpy against weak conduction
    const WallHeat q = film.wall_heat(r.T);
    for (int c = 0; c < r.grid.cells(); ++c)
      CHECK(std::abs(q.shell[c]) < 1e-11);  // of 10 W by flow
  }
}

TEST_CASE("StrongFlowAcrossTheFilmKeepsTemperaturesWithinSourcesAndWalls", "[film_energy]") {
  for (const int n : {5, 7, 9}) {
    for (const unsigned seed : {21u, 22u, 23u, 24u}) {
      Ring r = wild_ring(n, seed);
      const double low = 300.0, high = 340.0;
      r.problem.vessels.push_back({330.0, 2000.0, 2000.0, 1.0, 0.0});
      r.problem.T_edge = 310.0;
      r.set_walls(high, low);
      FilmEnergy film = r.film();
      settle(film, r.T);
      INFO(n << " nodes, seed " << seed << ", blended " << film.blended_columns());
      CHECK(film.blended_columns() > r.grid.cells() / 2);
      const auto [least, most] = std::minmax_element(r.T.begin(), r.T.end());
      CHECK(*least > low - 1e-9);
      CHECK(*most < high + 1e-9);
      const EnergyBalance b = film.balance(r.T);
      CHECK(std::abs(b.imbalance()) < 1e-12 * (b.carried_in + b.carried_out));
    }
  }
}

TEST_CASE("UniformTemperatureStaysUniformUnderUpwindFluxes", "[film_energy]") {
  for (const int n : {5, 7, 9}) {
    Ring r = wild_ring(n, 31);
    const double warm = 350.0;
    r.problem.T_edge = warm;
    r.problem.vessels.push_back({warm, 2000.0, 2000.0, 1.0, 0.0});
    for (double& T : r.T) T = warm;
    FilmEnergy film = r.film();
    CHECK(film.blended_columns() > r.grid.cells() / 2);
    double change = 0.0;
    for (int k = 0; k < 5; ++k) change = std::max(change, film.sweep(r.T));
    CHECK(change < 1e-9);  // round-off of 50 K of enthalpy, conduction being next to nothing
  }
}

TEST_CASE("HeatAndEnthalpyBalance", "[film_energy]") {
  for (const double carry_over : {1.0, 0.6, 0.0}) {
    for (const unsigned seed : {11u, 12u}) {
      Ring r = random_bearing(seed, carry_over, 0.3);
      FilmEnergy film = r.film();
      CHECK(settle(film, r.T) < 5000);
      const EnergyBalance b = film.balance(r.T);
      CHECK(b.heat > 10.0);
      // 80 cells of 2 kW/K flow and 20 K each carry 10 W: the sum of round-off
      CHECK(std::abs(b.imbalance()) < 1e-12 * (b.heat + b.carried_out));
    }
  }
}

TEST_CASE("HeatThatFallsAsOilThinsIsTheHeatOfThatTemperature", "[film_energy]") {
  Ring r = random_bearing(13, 0.6, 0.3);
  std::vector<double> T = r.T;
  r.problem.thinning = r.problem.heat;
  for (double& x : r.problem.thinning) x *= 0.03;  // as much of it for each kelvin
  FilmEnergy thins = r.film();
  settle(thins, T);
  const EnergyBalance b = thins.balance(T);
  CHECK(std::abs(b.imbalance()) < 1e-12 * (b.heat + b.carried_out));
  for (std::size_t k = 0; k < T.size(); ++k) {
    r.problem.heat[k] -= r.problem.thinning[k] * (T[k] - r.problem.T_reference);
  }
  r.problem.thinning.clear();
  FilmEnergy given = r.film();
  settle(given, r.T);
  double off = 0.0;
  for (std::size_t k = 0; k < T.size(); ++k) off = std::max(off, std::abs(T[k] - r.T[k]));
  CHECK(off < 1e-9);
}

TEST_CASE("SurplusLeavesThroughTheSupplyAsWarmAsItCame", "[film_energy]") {
  Ring r(16, 1, 5);
  for (int c = 0; c < 16; ++c) {  // groove 1 hands on a tenth of what reaches it
    const double flow = c >= 1 && c <= 8 ? 1e-4 : 1e-5;
    r.west_flow(c, [flow](double s) { return flow * (0.4 + 1.2 * s); });
    if (c == 0 || c == 8) continue;
    r.problem.conductance[c] = 0.02;
    for (int k = 0; k < 5; ++k) r.problem.heat[r.at(c, k)] = r.gl.w[k] * 0.5;
  }
  r.problem.patch[0] = 0;
  r.problem.patch[8] = 1;
  r.problem.vessels = {{310.0, 2000.0, 2000.0, 1.0, 0.0}, {250.0, 2000.0, 2000.0, 1.0, 0.0}};
  FilmEnergy film = r.film();
  settle(film, r.T);
  double heat = 0.0;
  for (int k = 0; k < 5; ++k) {
    heat += r.gl.w[k] * (0.4 + 1.2 * r.gl.s[k]) * (r.T[r.at(7, k)] - r.problem.T_reference);
  }
  CHECK(heat > 1.0);  // no oil of the supply's 250 K in it
  CHECK(std::abs(film.mix_temperatures()[1] - r.problem.T_reference - heat) < 1e-10);
  const EnergyBalance b = film.balance(r.T);
  CHECK(std::abs(b.imbalance()) < 1e-12 * b.heat);
}

TEST_CASE("ReversedJournalCarriesHeatTheOtherWay", "[film_energy]") {
  Ring a = random_bearing(21, 0.8, 0.2);
  const FilmGrid& g = a.grid;
  Ring b(16, 5, 5);  // mirrored in phi: cell i becomes nt - 1 - i, flows change sign
  b.problem = a.problem;
  b.problem.forward = false;
  b.problem.lines.clear();
  b.problem.line.assign(b.problem.line.size(), -1);
  const auto mirror = [&](int i) { return g.nt - 1 - i; };
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      const int from = g.index(i, j);
      const int to = g.index(mirror(i), j);
      b.problem.patch[to] = a.problem.patch[from];
      b.problem.conductance[to] = a.problem.conductance[from];
      const int east = g.index(g.next(mirror(i)), j);  // west face of i is the east face there
      if (a.problem.line[from] >= 0) {
        b.problem.line[east] = 2;
        b.problem.lines.push_back({east, 2, std::vector<double>(5)});
      }
      for (int k = 0; k < 5; ++k) {
        b.problem.phi_flow[b.at(east, k)] = -a.problem.phi_flow[a.at(from, k)];
        if (a.problem.line[from] >= 0) {
          b.problem.lines.back().flow[k] = -a.problem.phi_flow[a.at(from, k)];
        }
        b.problem.heat[b.at(to, k)] = a.problem.heat[a.at(from, k)];
        b.problem.cp[b.at(to, k)] = a.problem.cp[a.at(from, k)];
        b.T[b.at(to, k)] = a.T[a.at(from, k)];
      }
    }
    for (int j = 0; j <= g.nz; ++j) {
      for (int k = 0; k < 5; ++k) {
        b.problem.z_flow[b.z_face(mirror(i), j) + k] = a.problem.z_flow[a.z_face(i, j) + k];
      }
    }
  }
  FilmEnergy forward = a.film();
  FilmEnergy backward = b.film();
  settle(forward, a.T);
  settle(backward, b.T);
  double difference = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) {
      for (int k = 0; k < 5; ++k) {
        difference = std::max(difference, std::abs(a.T[a.at(g.index(i, j), k)] -
                                                   b.T[b.at(g.index(mirror(i), j), k)]));
      }
    }
  }
  CHECK(difference < 1e-9);  // both settled to 1e-12 per sweep
  CHECK(forward.backflow_nodes() == backward.backflow_nodes());
}

TEST_CASE("HeatConductedAcrossTheFilmIsFouriers", "[film_energy]") {
  Ring r(6, 3, 5);
  for (int c = 0; c < r.grid.cells(); ++c) {
    const double area = r.grid.area(c / 3, c % 3);
    r.problem.conductance[c] = 0.13 * area / 20e-6;
  }
  r.set_walls(320.0, 380.0);
  FilmEnergy film = r.film();
  settle(film, r.T);
  const WallHeat q = film.wall_heat(r.T);
  for (int c = 0; c < r.grid.cells(); ++c) {
    const double flux = 0.13 * 60.0 / 20e-6 * r.grid.area(c / 3, c % 3);  // k dT/h A
    CHECK(std::abs(q.shell[c] / flux - 1.0) < 1e-11);                     // round-off
    CHECK(std::abs(q.shaft[c] / flux + 1.0) < 1e-11);
  }
}

TEST_CASE("WallResponseIsTheSlopeOfTheWallHeat", "[film_energy]") {
  Ring r = random_bearing(31, 0.7, 0.2);
  FilmEnergy film = r.film();
  settle(film, r.T);
  const WallHeat before = film.wall_heat(r.T);
  const WallResponse response = film.wall_response(3000);
  const auto warmed = [&](int node) {
    std::vector<double> T = r.T;
    for (int c = 0; c < r.grid.cells(); ++c) T[r.at(c, node)] += 1.0;
    settle(film, T);
    return film.wall_heat(T);
  };
  const WallHeat by_shell = warmed(0);
  const WallHeat by_shaft = warmed(4);
  // The area of the film alone is what the response refers to; patches pass no heat.
  double film_area = 0.0;
  double whole = 0.0;
  for (int c = 0; c < r.grid.cells(); ++c) {
    const double area = r.grid.area(c / 5, c % 5);
    whole += area;
    if (r.problem.patch[c] < 0) film_area += area;
  }
  const double scale = whole / film_area;
  // linear problem: only sweeps that have settled separate the two
  const auto slope = [&](const Field& a, const Field& b) {
    return scale * mean_change(r.grid, a, b);
  };
  CHECK(response.shell == Approx(-slope(by_shell.shell, before.shell)).epsilon(1e-8));
  CHECK(response.back == Approx(slope(by_shell.shaft, before.shaft)).epsilon(1e-8));
  CHECK(response.across == Approx(slope(by_shaft.shell, before.shell)).epsilon(1e-8));
  CHECK(response.shaft == Approx(-slope(by_shaft.shaft, before.shaft)).epsilon(1e-8));
}

TEST_CASE("LocalWallResponseIsTheLargestOfOneColumn", "[film_energy]") {
  std::mt19937 engine(9);
  Ring r(10, 1, 5);
  for (int c = 0; c < 10; ++c) r.west_flow(c, [](double s) { return 1e-4 * s * (1.2 - s); });
  random_conduction(r, 0.05, engine);
  r.set_walls(320.0, 330.0);
  FilmEnergy film = r.film();
  settle(film, r.T);
  const WallHeat before = film.wall_heat(r.T);
  double most = 0.0;
  for (int c = 0; c < 10; ++c) {  // one sweep: the column follows, its upstream does not know yet
    std::vector<double> T = r.T;
    T[r.at(c, 0)] += 1.0;
    film.sweep(T);
    most = std::max(most, (before.shell[c] - film.wall_heat(T).shell[c]) / r.grid.area(c, 0));
  }
  CHECK(film.wall_response(3).shell_local == Approx(most).epsilon(1e-9));
}
