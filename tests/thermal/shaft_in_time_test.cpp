/// Heat capacity of the shaft and its overhangs: closed forms, balance, limits.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "thermal/shaft_fin.hpp"

using namespace shellback;
using namespace shellback::thermal;

namespace {

const ShaftFin kSteelShaft{50.0, 0.06, 80.0, 330.0, 3.6e6};
constexpr double kR = 0.024;

std::vector<double> uneven_flux(int nz) {
  std::vector<double> q(nz);
  for (int j = 0; j < nz; ++j) q[j] = 2e4 * (1.0 + 0.7 * std::sin(1.3 * j));
  return q;
}

/// A bearing so narrow that the shaft is one rod 0 < x < L, heated at x = 0 by `heat` [W] from
/// ambient temperature on: rise at x = 0 after `steps` steps of implicit Euler to the time t, by
/// the series of cos(i pi x / L), whose modes decay with a (m^2 + (i pi / L)^2).
double heated_rod(const ShaftFin& s, double heat, double t, int steps) {
  const double a = s.conductivity / s.capacity, m2 = 2.0 * s.heat_transfer / (s.conductivity * kR);
  const double per_length = heat / (s.conductivity * kPi * kR * kR);  // [K/m]
  double T = 0.0;
  for (int i = 0; i < 20000; ++i) {  // the steady tail is left out: 1 / (pi^2 20000) of L
    const double b2 = m2 + std::pow(i * kPi / s.overhang, 2);
    const double part = (i == 0 ? 1.0 : 2.0) * per_length / (s.overhang * b2);
    T += part * (1.0 - std::pow(1.0 + a * b2 * t / steps, -steps));
  }
  return T;
}

double heated_by_the_fin(ShaftFin s, double heat, double t, int steps, int spaces) {
  const double width = 1e-9;  // [m]
  s.spaces = spaces;
  const auto grid = make_grid(kR, 2.0 * width, 8, 1, true);
  const std::vector<double> q(1, heat / (2.0 * kPi * kR * width));
  ShaftStep step{t / steps, uniform_shaft(grid, s, s.ambient)};
  for (int i = 0; i < steps; ++i) step.before = solve_shaft(grid, s, q, 0.0, {0.0}, step).state();
  return step.before.cells[0] - s.ambient;
}

}  // namespace

TEST_CASE("OverhangWithoutStorageIsTheClosedFormOfTheFin", "[shaft_in_time]") {
  for (const double h : {1e-3, 80.0, 1e6}) {  // m L from 0.003 to 100
    for (const int spaces : {1, 16, 64}) {
      ShaftFin s = kSteelShaft;
      s.heat_transfer = h;
      s.spaces = spaces;
      const auto grid = make_grid(kR, 0.02, 40, 15, false, {}, {4e-3});
      const auto t =
          solve_shaft(grid, s, uneven_flux(grid.nz), 3e3, std::vector<double>(grid.nz, 350.0));
      const double edge = t.high.front() - s.ambient,
                   m = std::sqrt(2.0 * h / (s.conductivity * kR));
      const double lost = fin_conductance(kR, s) * (edge + t.low.front() - s.ambient);
      CHECK(t.heat_out == Approx(lost).epsilon(1e-13));
      CHECK(t.high.back() - s.ambient ==
            Approx(edge / std::cosh(m * s.overhang)).margin(1e-12 * s.ambient));
    }
  }
}

TEST_CASE("HeatIntoTheShaftLeavesOrIsStored", "[shaft_in_time]") {
  for (const bool half : {true, false}) {
    for (const double length : {0.0, 0.06}) {
      ShaftFin s = kSteelShaft;
      s.overhang = length;
      const auto grid = make_grid(kR, 0.02, 40, 15, half, {}, {4e-3});
      const auto q = uneven_flux(grid.nz);
      const std::vector<double> old(grid.nz, 350.0);
      ShaftStep step{0.2, uniform_shaft(grid, s, 300.0)};
      for (int i = 0; i < 4; ++i) {
        const auto t = solve_shaft(grid, s, q, 3e3, old, step);
        CHECK(std::abs(t.stored) > 10.0);
        CHECK(std::abs(t.heat_in - t.heat_out - t.stored) < 1e-12 * std::abs(t.heat_in));
        std::vector<double> met = q;  // flux at the temperatures that were found
        for (int j = 0; j < grid.nz; ++j) met[j] -= 3e3 * (t.temperature[j] - old[j]);
        CHECK(std::abs(shaft_imbalance(grid, s, met, t.temperature, step)) <
              1e-11 * std::abs(t.heat_in));
        step.before = t.state();
      }
    }
  }
}

TEST_CASE("RodCoolsWithItsTimeConstant", "[shaft_in_time]") {
  // uniform, convection all along, insulated ends: rho c R / (2 h), whatever it conducts
  const auto grid = make_grid(kR, 2e-9, 8, 1, true);
  const double tau = kSteelShaft.capacity * kR / (2.0 * kSteelShaft.heat_transfer);
  std::vector<double> error;
  for (const int steps : {8, 16, 32}) {
    ShaftStep step{tau / steps, uniform_shaft(grid, kSteelShaft, kSteelShaft.ambient + 40.0)};
    for (int i = 0; i < steps; ++i) {
      step.before = solve_shaft(grid, kSteelShaft, {0.0}, 0.0, {0.0}, step).state();
    }
    for (const double T : step.before.high) {
      CHECK(T - kSteelShaft.ambient ==
            Approx(40.0 * std::pow(1.0 + 1.0 / steps, -steps)).epsilon(1e-3));  // m d = 0.04
    }
    error.push_back(step.before.cells[0] - kSteelShaft.ambient - 40.0 * std::exp(-1.0));
  }
  CHECK(std::log2(error[0] / error[1]) == Approx(1.0).margin(0.15));
  CHECK(std::log2(error[1] / error[2]) == Approx(1.0).margin(0.15));
}

TEST_CASE("HeatedOverhangFollowsTheSeries", "[shaft_in_time]") {
  const double t = 60.0;  // L^2 / a = 260 s
  const double exact = heated_rod(kSteelShaft, 50.0, t, 6);
  std::vector<double> error;
  for (const int spaces : {8, 16, 32}) {
    error.push_back(std::abs(heated_by_the_fin(kSteelShaft, 50.0, t, 6, spaces) - exact) / exact);
  }
  CHECK(error[1] < 3e-3);  // the default
  CHECK(std::log2(error[0] / error[1]) == Approx(2.0).margin(0.15));
  CHECK(std::log2(error[1] / error[2]) == Approx(2.0).margin(0.15));
}

TEST_CASE("LongMarchOfTheShaftEndsSteady", "[shaft_in_time]") {
  const auto grid = make_grid(kR, 0.02, 40, 15, true);
  const auto q = uneven_flux(grid.nz);
  const std::vector<double> old(grid.nz, 360.0);
  for (const double g : {0.0, 4e3}) {
    const auto steady = solve_shaft(grid, kSteelShaft, q, g, old);
    ShaftStep step{1e5, uniform_shaft(grid, kSteelShaft, 290.0)};
    ShaftTemperature t;
    for (int i = 0; i < 15; ++i) {
      t = solve_shaft(grid, kSteelShaft, q, g, old, step);
      step.before = t.state();
    }
    for (int j = 0; j < grid.nz; ++j) {
      CHECK(t.temperature[j] == Approx(steady.temperature[j]).epsilon(1e-12));
    }
    CHECK(t.high.back() == Approx(steady.high.back()).epsilon(1e-12));
    CHECK(std::abs(t.stored) < 1e-10 * t.heat_in);
  }
}

TEST_CASE("ShaftThatLosesNothingStoresAllHeat", "[shaft_in_time]") {
  // the film's heat is in the steel, overhang included, whose surface is insulated
  ShaftFin s = kSteelShaft;
  s.heat_transfer = 0.0;
  const auto grid = make_grid(kR, 0.02, 40, 15, true);
  const std::vector<double> q(grid.nz, 1e4);
  ShaftStep step{1e4, uniform_shaft(grid, s, 300.0)};
  const auto t = solve_shaft(grid, s, q, 0.0, std::vector<double>(grid.nz, 300.0), step);
  const double heat = 1e4 * 2.0 * kPi * kR * 0.02 * step.dt;  // [J]
  const double capacity = s.capacity * kPi * kR * kR * (0.02 + 2.0 * s.overhang);
  CHECK(t.heat_out == 0.0);
  CHECK(t.stored == Approx(heat / step.dt).epsilon(1e-12));
  // uniform but for what a step of 40 diffusion times leaves: q / k over the length
  CHECK(t.high.back() - 300.0 == Approx(heat / capacity).epsilon(2e-2));
  CHECK(shaft_conductance(grid, s, 1e9) == Approx(capacity / 1e9).epsilon(1e-5));
}

TEST_CASE("HalfShaftIsAsWarmAsTheFullOneInTime", "[shaft_in_time]") {
  const auto half = make_grid(kR, 0.02, 40, 15, true), full = full_grid(half);
  std::vector<double> q(full.nz);
  for (int j = 0; j < full.nz; ++j) q[j] = 1e4 * std::cos(60.0 * full.z[j]);
  const std::vector<double> q_half(q.end() - half.nz, q.end());
  const auto f = solve_shaft(full, kSteelShaft, q, 0.0, std::vector<double>(full.nz, 0.0),
                             {3.0, uniform_shaft(full, kSteelShaft, 310.0)});
  const auto h = solve_shaft(half, kSteelShaft, q_half, 0.0, std::vector<double>(half.nz, 0.0),
                             {3.0, uniform_shaft(half, kSteelShaft, 310.0)});
  for (int j = 0; j < half.nz; ++j) {
    CHECK(h.temperature[j] == Approx(f.temperature[full.nz - half.nz + j]).epsilon(1e-12));
  }
  CHECK(h.stored == Approx(f.stored).epsilon(1e-12));
  CHECK(shaft_conductance(half, kSteelShaft, 3.0) ==
        Approx(shaft_conductance(full, kSteelShaft, 3.0)).epsilon(1e-12));
}

TEST_CASE("ShaftWithoutCapacityIsRefusedInTime", "[shaft_in_time]") {
  const auto grid = make_grid(kR, 0.02, 8, 3, true);
  ShaftFin s = kSteelShaft;
  s.capacity = 0.0;
  const std::vector<double> q(grid.nz, 1.0), old(grid.nz, 300.0);
  CHECK_THROWS_AS(solve_shaft(grid, s, q, 1.0, old, {1.0, uniform_shaft(grid, s, 300.0)}),
                  InputError);
}
