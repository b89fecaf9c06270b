#include "thermal/shaft_fin.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

using namespace shellback;
using namespace shellback::thermal;

namespace {
const ShaftFin kSteelShaft{50.0, 0.06, 80.0, 330.0};

std::vector<double> uneven_flux(int nz) {
  std::vector<double> q(nz);
  for (int j = 0; j < nz; ++j) q[j] = 2e4 * (1.0 + 0.7 * std::sin(1.3 * j));
  return q;
}
}  // namespace

TEST_CASE("HeatIntoTheShaftLeavesThroughItsOverhangs", "[shaft_fin]") {
  for (const bool half : {true, false}) {
    for (const double g : {0.0, 3e3}) {
      const auto grid = make_grid(0.024, 0.02, 40, 15, half, {}, {4e-3});
      const auto s = solve_shaft(grid, kSteelShaft, uneven_flux(grid.nz), g,
                                 std::vector<double>(grid.nz, 350.0));
      CHECK(s.heat_in > 0.0);
      CHECK(s.heat_in == Approx(s.heat_out).epsilon(1e-11));  // round-off: kA/dz over fin, 1e3
    }
  }
}

TEST_CASE("UniformHeatingFollowsTheParabola", "[shaft_fin]") {
  const double R = 0.024, B = 0.06, q = 2e4;
  const auto grid = make_grid(R, B, 40, 41, false);
  const auto s =
      solve_shaft(grid, kSteelShaft, std::vector<double>(41, q), 0.0, std::vector<double>(41, 0.0));
  const double fin = fin_conductance(R, kSteelShaft);
  const double edge = kSteelShaft.ambient + q * kPi * R * B / fin;  // half the heat to each side
  // mid-width over edge: q 2 pi R (B/2)^2 / (2 k pi R^2); second order, (1/41)^2 / 4 of the sag
  const double sag = q * B * B / (4.0 * kSteelShaft.conductivity * R);
  CHECK(std::abs(s.temperature[20] - edge - sag) < 1e-3 * sag);
  CHECK(s.temperature[0] == Approx(s.temperature[40]).epsilon(1e-13));
}

TEST_CASE("FinConductanceHasItsLimits", "[shaft_fin]") {
  const double R = 0.02;
  ShaftFin fin{50.0, 1e-4, 80.0, 300.0};  // short: the whole surface at base temperature
  CHECK(fin_conductance(R, fin) == Approx(80.0 * 2.0 * kPi * R * 1e-4).epsilon(1e-4));
  fin.overhang = 100.0;  // long: k A m
  const double m = std::sqrt(2.0 * 80.0 / (50.0 * R));
  CHECK(fin_conductance(R, fin) == Approx(50.0 * kPi * R * R * m).epsilon(1e-12));
}

TEST_CASE("HalfShaftIsAsWarmAsTheFullOne", "[shaft_fin]") {
  const auto half = make_grid(0.024, 0.02, 40, 15, true), full = full_grid(half);
  std::vector<double> q(full.nz);
  for (int j = 0; j < full.nz; ++j) q[j] = 1e4 * std::cos(60.0 * full.z[j]);
  const std::vector<double> q_half(q.begin() + 7, q.end());
  const auto f = solve_shaft(full, kSteelShaft, q, 0.0, std::vector<double>(full.nz, 0.0));
  const auto h = solve_shaft(half, kSteelShaft, q_half, 0.0, std::vector<double>(half.nz, 0.0));
  for (int j = 0; j < half.nz; ++j) {
    CHECK(h.temperature[j] == Approx(f.temperature[7 + j]).epsilon(1e-12));
  }
  CHECK(h.heat_in == Approx(f.heat_in).epsilon(1e-12));
}

TEST_CASE("FilmConductanceOnlySteadiesTheShaft", "[shaft_fin]") {
  const auto grid = make_grid(0.024, 0.02, 40, 15, true);
  const auto q = uneven_flux(grid.nz);
  const auto direct = solve_shaft(grid, kSteelShaft, q, 0.0, std::vector<double>(grid.nz, 0.0));
  const auto again = solve_shaft(grid, kSteelShaft, q, 5e3, direct.temperature);
  for (int j = 0; j < grid.nz; ++j) {
    CHECK(again.temperature[j] == Approx(direct.temperature[j]).epsilon(1e-12));
  }
}

TEST_CASE("InsulatedShaftTakesTheFilmsTemperature", "[shaft_fin]") {
  const auto grid = make_grid(0.024, 0.02, 40, 15, false);
  const ShaftFin insulated{50.0, 0.0, 0.0, 300.0};
  const double g = 4e3, film = 365.0, old = 340.0;  // q = g (film - old)
  const auto s = solve_shaft(grid, insulated, std::vector<double>(15, g * (film - old)), g,
                             std::vector<double>(15, old));
  for (const double t : s.temperature) CHECK(t == Approx(film).epsilon(1e-12));
  CHECK(s.heat_in == Approx(0.0).margin(1e-8));  // of 300 W offered, round-off
  CHECK_THROWS_AS(
      solve_shaft(grid, insulated, std::vector<double>(15, 1.0), 0.0, std::vector<double>(15, old)),
      InputError);
}
