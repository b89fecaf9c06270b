/// Heat capacity of the shaft and its overhangs: closed forms, balance, limits.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/contract.hpp"
#include "core/make_grid.hpp"
#include "tests/thermal/sample_shaft.hpp"

using namespace shellback;
using namespace shellback::thermal;
using namespace shellback::thermal::tests;

namespace {

/// Nodal temperatures after `steps` steps of dt under the flux q.
Eigen::VectorXd march(const ShaftConduction& shaft, Eigen::VectorXd nodal, int steps,
                      const std::vector<double>& q) {
  const std::vector<double> old(q.size(), 0.0);
  for (int i = 0; i < steps; ++i) {
    const ShaftHistory before = shaft.history(nodal);
    nodal = shaft.solve(q, 0.0, old, &before).nodal;
  }
  return nodal;
}

/// Zero number i >= 1 of J1 [textbook: (i + 1/4) pi and Newton's steps].
double zero_of_j1(int i) {
  double x = (i + 0.25) * kPi;
  for (int k = 0; k < 20; ++k) {
    const double j1 = std::cyl_bessel_j(1.0, x);
    x -= j1 / (std::cyl_bessel_j(0.0, x) - j1 / x);
  }
  return x;
}

/// Rise of the surface of a long cylinder heated by q from `steps` steps of implicit Euler to the
/// time t: 2 q t / (rho c R) + q R / k (1/4 - 2 sum f_i / b_i^2), J1(b_i) = 0, f_i the decay of
/// exp(-a b_i^2 t / R^2) as the steps have it (Carslaw and Jaeger, textbook).
double heated_cylinder(const ShaftBody& s, double R, double q, double t, int steps) {
  const double a = s.conductivity / s.capacity;
  double sum = 0.25;
  for (int i = 1; i < 400; ++i) {
    const double b = zero_of_j1(i), x = a * b * b * t / (R * R * steps);
    sum -= 2.0 * std::pow(1.0 + x, -steps) / (b * b);
  }
  return 2.0 * q * t / (s.capacity * R) + q * R / s.conductivity * sum;
}

}  // namespace

TEST_CASE("SurfaceOfAHeatedShaftFollowsTheSeries", "[shaft_in_time]") {
  const FilmGrid grid = make_grid(kShaftRadius, 0.03, 8, 6, true);
  const std::vector<double> q(grid.nz, 1e5);
  for (const double t : {0.5, 5.0, 50.0}) {  // R^2 / a = 41 s
    const ShaftConduction shaft = shaft_on(grid, kSteelShaft, 0.0).over(t / 5);
    const Eigen::VectorXd T = march(shaft, shaft.uniform(kSteelShaft.ambient), 5, q);
    const double exact = heated_cylinder(kSteelShaft, kShaftRadius, 1e5, t, 5);
    for (const double x : shaft.at(T).temperature) {
      CHECK(x - kSteelShaft.ambient == Approx(exact).epsilon(3e-3));  // surface row 2.5 mm
    }
  }
}

TEST_CASE("HeatIntoTheShaftLeavesOrIsStored", "[shaft_in_time]") {
  for (const bool half : {true, false}) {
    for (const double length : {0.0, 0.06}) {
      const auto grid = shaft_grid(half);
      const auto q = uneven_flux(grid.nz);
      const std::vector<double> old(grid.nz, 350.0);
      const ShaftConduction shaft = shaft_on(grid, kSteelShaft, length).over(0.2);
      Eigen::VectorXd before = shaft.uniform(300.0);
      for (int i = 0; i < 4; ++i) {
        const ShaftHistory past = shaft.history(before);
        const auto t = shaft.solve(q, 3e3, old, &past);
        CHECK(std::abs(t.stored) > 10.0);
        // round-off of what the shaft holds over a step
        CHECK(std::abs(t.heat_in - t.heat_out - t.stored) < 1e-11 * std::abs(t.heat_in));
        std::vector<double> met = q;  // flux at the temperatures that were found
        for (int j = 0; j < grid.nz; ++j) met[j] -= 3e3 * (t.temperature[j] - old[j]);
        CHECK(std::abs(shaft.imbalance(met, t.temperature, &past)) < 1e-10 * std::abs(t.heat_in));
        before = t.nodal;
      }
    }
  }
}

TEST_CASE("RodCoolsWithItsTimeConstant", "[shaft_in_time]") {
  // slender, convection all along, insulated ends: rho c R / (2 h), whatever it conducts
  const double R = 1e-3, tau = kSteelShaft.capacity * R / (2.0 * kSteelShaft.heat_transfer);
  const auto grid = make_grid(R, 2e-5, 8, 1, true);
  std::vector<double> error;
  for (const int steps : {8, 16, 32}) {
    const ShaftConduction shaft = shaft_on(grid).over(tau / steps);
    const Eigen::VectorXd T = march(shaft, shaft.uniform(kSteelShaft.ambient + 40.0), steps, {0.0});
    const double exact = 40.0 * std::pow(1.0 + 1.0 / steps, -steps);
    // Biot's number h R / k = 1.6e-3; what the film covers does not cool: 10 um of the 18 mm,
    // sqrt(a tau), from which heat comes there, times 2
    CHECK(T.minCoeff() == Approx(exact).epsilon(2e-3));
    CHECK(T.maxCoeff() == Approx(exact).epsilon(2e-3));
    error.push_back(T.mean() - 40.0 * std::exp(-1.0));
  }
  CHECK(std::log2(error[0] / error[1]) == Approx(1.0).margin(0.15));
  CHECK(std::log2(error[1] / error[2]) == Approx(1.0).margin(0.15));
}

TEST_CASE("TipOfAHeatedRodFollowsTheSeries", "[shaft_in_time]") {
  // a slender rod heated at z = 0: cosines whose modes decay with a (m^2 + (i pi / L)^2)
  const double R = 1e-3, L = kShaftOverhang, width = 1e-4, t = 60.0, heat = 0.1;
  const ShaftBody& s = kSteelShaft;
  const double a = s.conductivity / s.capacity, m2 = 2.0 * s.heat_transfer / (s.conductivity * R);
  double exact = 0.0;
  const int steps = 6;
  for (int i = 0; i < 2000; ++i) {
    const double b2 = m2 + std::pow(i * kPi / L, 2);
    const double part = (i == 0  ? 1.0
                         : i % 2 ? -2.0
                                 : 2.0) *
                        heat / (s.conductivity * kPi * R * R * L * b2);
    exact += part * (1.0 - std::pow(1.0 + a * b2 * t / steps, -steps));
  }
  const auto grid = make_grid(R, width, 8, 1, true);
  const ShaftConduction shaft = shaft_on(grid).over(t / steps);
  const std::vector<double> q(1, heat / (kPi * R * width));
  const Eigen::VectorXd T = march(shaft, shaft.uniform(s.ambient), steps, q);
  // elements that double away from the film, 30 mm at the tip, where m d = 1.7
  CHECK(T[shaft.mesh().line_nodes() - 1] == Approx(exact).epsilon(2e-2));
}

TEST_CASE("LongMarchOfTheShaftEndsSteady", "[shaft_in_time]") {
  const auto grid = shaft_grid(true);
  const auto q = uneven_flux(grid.nz);
  const std::vector<double> old(grid.nz, 360.0);
  const ShaftConduction steady = shaft_on(grid), shaft = steady.over(1e5);
  for (const double g : {0.0, 4e3}) {
    const auto end = steady.solve(q, g, old);
    ShaftTemperature t = shaft.at(shaft.uniform(290.0));
    for (int i = 0; i < 15; ++i) {
      const ShaftHistory past = shaft.history(t.nodal);
      t = shaft.solve(q, g, old, &past);
    }
    CHECK((t.nodal - end.nodal).cwiseAbs().maxCoeff() < 1e-9);  // [K]
    CHECK(std::abs(t.stored) < 1e-10 * t.heat_in);
  }
}

TEST_CASE("ShaftThatLosesNothingStoresAllHeat", "[shaft_in_time]") {
  // the film's heat is in the steel, overhang included, whose surface is insulated
  ShaftBody s = kSteelShaft;
  s.heat_transfer = 0.0;
  const auto grid = shaft_grid(true);
  const double dt = 1e4;
  const ShaftConduction shaft = shaft_on(grid, s).over(dt);
  const ShaftHistory past = shaft.history(shaft.uniform(300.0));
  const auto t = shaft.solve(std::vector<double>(grid.nz, 1e4), 0.0,
                             std::vector<double>(grid.nz, 300.0), &past);
  const double heat = 1e4 * 2.0 * kPi * kShaftRadius * kShaftWidth * dt;  // [J]
  const double capacity =
      s.capacity * kPi * kShaftRadius * kShaftRadius * (kShaftWidth + 2.0 * kShaftOverhang);
  CHECK(t.heat_out == 0.0);
  // round-off grows with the diffusion times in a step
  CHECK(t.stored == Approx(heat / dt).epsilon(1e-10));
  const ShaftConduction quick = shaft_on(grid, s).over(1e-2 * dt);
  const ShaftHistory before = quick.history(quick.uniform(300.0));
  const auto soon = quick.solve(std::vector<double>(grid.nz, 1e4), 0.0,
                                std::vector<double>(grid.nz, 300.0), &before);
  CHECK(soon.stored == Approx(heat / dt).epsilon(1e-11));
  // uniform but for what a step of 40 diffusion times leaves: q / k over the length
  CHECK(t.nodal.minCoeff() + s.ambient - 300.0 == Approx(heat / capacity).epsilon(2e-2));
  CHECK(shaft_on(grid, s).over(1e9).conductance() == Approx(capacity / 1e9).epsilon(1e-5));
}

TEST_CASE("HalfShaftIsAsWarmAsTheFullOneInTime", "[shaft_in_time]") {
  const auto half = make_grid(kShaftRadius, 0.02, 40, 15, true), full = full_grid(half);
  const auto solve = [](const FilmGrid& grid) {
    const ShaftConduction shaft = shaft_on(grid).over(3.0);
    const ShaftHistory past = shaft.history(shaft.uniform(310.0));
    return shaft.solve(cosine(grid, 60.0), 0.0, std::vector<double>(grid.nz, 0.0), &past);
  };
  const auto f = solve(full), h = solve(half);
  for (int j = 0; j < half.nz; ++j) {
    CHECK(h.temperature[j] == Approx(f.temperature[full.nz - half.nz + j]).epsilon(1e-12));
  }
  CHECK(h.stored == Approx(f.stored).epsilon(1e-11));
  CHECK(shaft_on(half).over(3.0).conductance() ==
        Approx(shaft_on(full).over(3.0).conductance()).epsilon(1e-10));
}

TEST_CASE("ShaftWithoutCapacityIsRefusedInTime", "[shaft_in_time]") {
  ShaftBody s = kSteelShaft;
  CHECK_THROWS_AS(shaft_on(shaft_grid(true), s).over(0.0), InputError);
  s.capacity = 0.0;
  CHECK_THROWS_AS(shaft_on(shaft_grid(true), s).over(1.0), InputError);
}
