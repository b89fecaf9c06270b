/// Steady temperature of the shaft: exact series, limits, balance.
#include "thermal/shaft_conduction.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/contract.hpp"
#include "core/make_grid.hpp"
#include "tests/thermal/sample_shaft.hpp"

using namespace shellback;
using namespace shellback::thermal;
using namespace shellback::thermal::tests;

namespace {

/// I1(x) / I0(x).
double bessel_ratio(double x) {
  if (x > 300.0) return 1.0 - 0.5 / x - 0.125 / (x * x);  // asymptotic, next term 1e-8
  return std::cyl_bessel_i(1.0, x) / std::cyl_bessel_i(0.0, x);
}

/// Rise of the surface, mean over the cells, of a cylinder of half-length L with convection h all
/// over its surface and insulated tips, heated by q over the film: T = sum a_n cos(k_n z) /
/// (k k_n I1(k_n R) / I0(k_n R) + h), k_n = n pi / L, a_n the cosines of the flux (textbook).
std::vector<double> heated_part(const FilmGrid& grid, const ShaftBody& s, double L, double q) {
  std::vector<double> rise(grid.nz, 0.0);
  const double b = 0.5 * grid.width;
  for (int n = 0; n < 4000; ++n) {  // terms fall with n^-3
    const double k = n * kPi / L;
    const double a = n == 0 ? q * b / L : 2.0 * q * std::sin(k * b) / (n * kPi);
    const double by = s.conductivity * k * bessel_ratio(k * grid.radius) + s.heat_transfer;
    const std::vector<double> c = cosine(grid, k);
    for (int j = 0; j < grid.nz; ++j) rise[j] += a * c[j] / by;
  }
  return rise;
}

/// Mean error against that series on meshes halved `times` times, by the largest rise.
double error_of_the_heated_part(int times) {
  ShaftBody s = kSteelShaft;
  s.heat_transfer = 2e3;
  const FilmGrid coarse = make_grid(kShaftRadius, 0.03, 8, 6, true);
  const RevolutionMesh first = shaft_mesh(coarse, 0.03);
  RadialRows rows{first.r_face, first.layer};
  std::vector<double> z = first.z_face;
  for (int i = 0; i < times; ++i) {
    rows = halved(rows);
    z = halved(z);
  }
  const FilmGrid grid = make_grid(kShaftRadius, 0.03, 8, 6 << times, true);
  const ShaftConduction shaft(make_revolution_mesh(rows.face, rows.layer, z, true), grid, s);
  const std::vector<double> ambient(grid.nz, s.ambient);
  const auto t = shaft.solve(std::vector<double>(grid.nz, 1e5), s.heat_transfer, ambient);
  const std::vector<double> exact = heated_part(grid, s, 0.045, 1e5);
  double error = 0.0;
  for (int j = 0; j < grid.nz; ++j) {
    error += std::abs(t.temperature[j] - s.ambient - exact[j]) / exact[0] / grid.nz;
  }
  return error;
}

}  // namespace

TEST_CASE("HeatIntoTheShaftLeavesThroughItsOverhangs", "[shaft_conduction]") {
  for (const bool half : {true, false}) {
    for (const double g : {0.0, 3e3}) {
      const auto grid = shaft_grid(half);
      const auto s =
          shaft_on(grid).solve(uneven_flux(grid.nz), g, std::vector<double>(grid.nz, 350.0));
      CHECK(s.heat_in > 0.0);
      CHECK(s.heat_in == Approx(s.heat_out).epsilon(1e-11));  // round-off of the elimination
    }
  }
}

TEST_CASE("ShaftHeatedOverPartOfItsLengthFollowsTheSeries", "[shaft_conduction]") {
  const double e0 = error_of_the_heated_part(0), e1 = error_of_the_heated_part(1),
               e2 = error_of_the_heated_part(2);
  CAPTURE(e0, e1, e2);
  CHECK(e0 < 2e-3);  // six cells on half the width
  // Second order in the mean; in the cell beside the film's edge, where the flux jumps and the
  // gradient is logarithmic, first.
  CHECK(std::log2(e0 / e1) == Approx(2.0).margin(0.3));
  CHECK(std::log2(e1 / e2) == Approx(2.0).margin(0.3));
}

TEST_CASE("NarrowShaftVariesSeveralTimesAsMuchAsAFin", "[shaft_conduction]") {
  // q cos(2 pi z / B) into a shaft without overhang: q I0(x) / (k K I1(x)) at the surface, K = 2 pi
  // / B, x = K R; the fin has 2 q / (k R K^2). At B/D = 0.36 that is 4.6 times the fin.
  const double B = 0.36 * 2.0 * kShaftRadius, K = 2.0 * kPi / B, q = 1e5;
  const FilmGrid grid = make_grid(kShaftRadius, B, 8, 40, true);
  std::vector<double> flux = cosine(grid, K);
  for (double& x : flux) x *= q;
  const double k = kSteelShaft.conductivity, x = K * kShaftRadius;
  const double exact = q / (k * K * bessel_ratio(x)), fin = 2.0 * q / (k * kShaftRadius * K * K);
  CHECK(exact / fin == Approx(4.6).epsilon(0.01));
  const double g = 1e3, mean = 360.0;  // the film sets the mean, and takes g of each variation
  const auto t = shaft_on(grid, kSteelShaft, 0.0)
                     .solve(flux, g, std::vector<double>(grid.nz, mean))
                     .temperature;
  const double damped = q / (k * K * bessel_ratio(x) + g);
  for (int j = 0; j < grid.nz; ++j) {
    CHECK(t[j] - mean ==
          Approx(damped * flux[j] / q).margin(2.5e-3 * damped));  // (K dz)^2/12 = 2.1e-3
  }
}

TEST_CASE("UniformHeatingFollowsTheParabola", "[shaft_conduction]") {
  // far from its ends a long cylinder has T = q / (k R) (r^2 / 2 - z^2) + constant, as the fin has
  const double R = 0.002, B = 0.08, q = 2e4;
  const auto grid = make_grid(R, B, 8, 60, true);
  const auto t =
      shaft_on(grid).solve(std::vector<double>(grid.nz, q), 0.0, std::vector<double>(grid.nz, 0.0));
  const double per_z2 = q / (kSteelShaft.conductivity * R);
  const auto z2 = [&](int j) { return grid.z[j] * grid.z[j] + grid.dz[j] * grid.dz[j] / 12.0; };
  for (int j = 0; grid.z[j] < 0.5 * B - 5.0 * R; ++j) {  // what the ends do dies out with 3.8 z/R
    CHECK(t.temperature[0] - t.temperature[j] ==
          Approx(per_z2 * (z2(j) - z2(0))).margin(1e-6 * per_z2 * B * B));
  }
}

TEST_CASE("SlenderShaftIsTheFinOfTheTextbooks", "[shaft_conduction]") {
  const double R = 1e-3, L = 0.06;
  const auto grid = make_grid(R, 0.02, 8, 20, true);
  for (const double h : {1.0, 0.01}) {
    ShaftBody s = kSteelShaft;
    s.heat_transfer = h;
    const ShaftConduction shaft = shaft_on(grid, s, L);
    const double m = std::sqrt(2.0 * h / (s.conductivity * R));
    const double fin = s.conductivity * kPi * R * R * m * std::tanh(m * L);
    // heat narrows to the section within a radius of the edge: m R of the fin's resistance
    CHECK(shaft.conductance() == Approx(2.0 * fin).epsilon(m * R));
    const auto t =
        shaft.solve(std::vector<double>(grid.nz, 100.0), 0.0, std::vector<double>(grid.nz, 0.0));
    const auto& mesh = shaft.mesh();
    const double edge = t.heat_out / (2.0 * fin);  // of the fin, by its heat
    CHECK(t.nodal[mesh.line_nodes() - 1] == Approx(edge / std::cosh(m * L)).epsilon(m * R));
  }
}

TEST_CASE("HalfShaftIsAsWarmAsTheFullOne", "[shaft_conduction]") {
  const auto half = make_grid(0.024, 0.02, 40, 15, true), full = full_grid(half);
  const auto q = cosine(full, 60.0), q_half = cosine(half, 60.0);
  const auto f = shaft_on(full).solve(q, 0.0, std::vector<double>(full.nz, 0.0));
  const auto h = shaft_on(half).solve(q_half, 0.0, std::vector<double>(half.nz, 0.0));
  for (int j = 0; j < half.nz; ++j) {
    CHECK(h.temperature[j] == Approx(f.temperature[full.nz - half.nz + j]).epsilon(1e-12));
  }
  CHECK(h.heat_in == Approx(f.heat_in).epsilon(1e-11));
}

TEST_CASE("FilmConductanceOnlySteadiesTheShaft", "[shaft_conduction]") {
  const auto grid = shaft_grid(true);
  const auto q = uneven_flux(grid.nz);
  const ShaftConduction shaft = shaft_on(grid);
  const auto direct = shaft.solve(q, 0.0, std::vector<double>(grid.nz, 0.0));
  const auto again = shaft.solve(q, 5e3, direct.temperature);
  for (int j = 0; j < grid.nz; ++j) {
    CHECK(again.temperature[j] == Approx(direct.temperature[j]).epsilon(1e-12));
  }
  CHECK(std::abs(shaft.imbalance(q, direct.temperature)) < 1e-10 * direct.heat_in);
}

TEST_CASE("InsulatedShaftTakesTheFilmsTemperature", "[shaft_conduction]") {
  const auto grid = make_grid(0.024, 0.02, 40, 15, false);
  ShaftBody insulated = kSteelShaft;
  for (const bool bare : {false, true}) {  // no overhang; one that gives off nothing
    insulated.heat_transfer = bare ? 0.0 : 80.0;
    const ShaftConduction shaft = shaft_on(grid, insulated, bare ? 0.05 : 0.0);
    const double g = 4e3, film = 365.0, old = 340.0;  // q = g (film - old)
    const auto s =
        shaft.solve(std::vector<double>(15, g * (film - old)), g, std::vector<double>(15, old));
    for (const double t : s.temperature) CHECK(t == Approx(film).epsilon(1e-12));
    CHECK(s.nodal.maxCoeff() == Approx(film - insulated.ambient).epsilon(1e-11));
    CHECK(s.heat_in == Approx(0.0).margin(1e-8));  // of 300 W offered, round-off
    CHECK(s.heat_out == 0.0);
    const std::vector<double> uneven = uneven_flux(15);
    const auto warm = shaft.solve(uneven, g, std::vector<double>(15, old));
    CHECK(std::abs(warm.heat_in) < 1e-8);
    CHECK_THROWS_AS(shaft.solve(uneven, 0.0, std::vector<double>(15, old)), InputError);
  }
}

TEST_CASE("ShaftThatCanHardlyLoseHeatIsNearlyTheInsulatedOne", "[shaft_conduction]") {
  const auto grid = make_grid(0.024, 0.02, 40, 15, false);
  const double g = 4e3, old = 340.0;
  ShaftBody body = kSteelShaft;
  body.heat_transfer = 0.0;
  const auto solved = [&] {
    return shaft_on(grid, body, 0.05).solve(uneven_flux(15), g, std::vector<double>(15, old));
  };
  const ShaftTemperature sealed = solved();
  for (const double h : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
    body.heat_transfer = h;
    const ShaftTemperature s = solved();
    // both overhangs' surface at the mean temperature: 30 mW/K per W/(m2 K) against g A of 12 W/K
    for (int j = 0; j < 15; ++j) {
      CHECK(s.temperature[j] == Approx(sealed.temperature[j]).margin(1e-9 + 0.5 * h));
    }
    CHECK(s.heat_in == Approx(s.heat_out).margin(1e-9));  // round-off of 600 W offered
  }
}

TEST_CASE("ShaftOfImpossibleDataIsRefused", "[shaft_conduction]") {
  const auto grid = shaft_grid(true);
  CHECK_THROWS_AS(shaft_on(grid, {0.0, 80.0, 300.0, 3.6e6}), InputError);
  CHECK_THROWS_AS(shaft_on(grid, {50.0, -1.0, 300.0, 3.6e6}), InputError);
}
