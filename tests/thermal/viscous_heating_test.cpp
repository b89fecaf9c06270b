/// Films that heat themselves: exact solutions with eta = eta0 exp(-beta (T - T0)).
#include <catch2/catch.hpp>

#include "tests/observed_order.hpp"
#include "tests/read_csv.hpp"
#include "tests/thermal/film_ring.hpp"

using namespace shellback;
using namespace shellback::thermal;
using namespace shellback::thermal::tests;
using shellback::test::observed_order;
using shellback::test::read_csv;
using shellback::test::richardson;

namespace {

constexpr double kT0 = 300.0;   // [K]
constexpr double kEta0 = 0.02;  // [Pa s]
constexpr double kBeta = 0.04;  // [1/K]
constexpr double kGap = 20e-6;  // [m]
constexpr double kK = 0.13;     // conductivity [W/(m K)]

struct Couette {
  double rise;    ///< beta (T_max - T0) [-]
  double stress;  ///< tau h/(eta0 U) [-]
};

/// A uniform ring between walls at T0 or with the moving wall insulated, by repeated substitution
/// of viscosity and sweeps.
Couette heated_couette(double nahme, int n, bool insulated) {
  Ring r(6, 1, n, kT0);
  const double U = std::sqrt(nahme * kK / (kBeta * kEta0));
  const double area = r.grid.area(0, 0);
  const double flow = 3e-5;  // weak enough for the ring to forget its start in some sweeps [kg/s]
  for (int c = 0; c < r.grid.cells(); ++c) {
    r.problem.conductance[c] = kK * area / kGap;
    r.west_flow(c, [flow](double s) { return flow * s; });
  }
  double tau = 0.0;
  for (int turn = 0; turn < 200; ++turn) {
    for (int c = 0; c < r.grid.cells(); ++c) {
      double fluidity = 0.0;
      for (int k = 0; k < n; ++k) {
        fluidity += r.gl.w[k] * std::exp(kBeta * (r.T[r.at(c, k)] - kT0)) / kEta0;
      }
      tau = U / (kGap * fluidity);
      for (int k = 0; k < n; ++k) {
        const double f = std::exp(kBeta * (r.T[r.at(c, k)] - kT0)) / kEta0;
        // half of the change only: at large Nahme numbers substitution overshoots
        double& heat = r.problem.heat[r.at(c, k)];
        heat += 0.5 * (r.gl.w[k] * area * kGap * tau * tau * f - heat);
      }
    }
    FilmEnergy film = r.film();
    settle(film, r.T, 1e-11);
    if (!insulated) continue;
    const double q = film.wall_heat(r.T).shaft[0] / area;
    const double dT = q / film.wall_response(200).shaft;
    r.set_walls(kT0, r.T[r.at(0, n - 1)] + dT);
    settle(film, r.T, 1e-11);
  }
  double hottest = kT0;
  for (const double T : r.T) hottest = std::max(hottest, T);
  return {kBeta * (hottest - kT0), tau * kGap / (kEta0 * U)};
}

}  // namespace

TEST_CASE("CouetteFilmHeatsItselfAsNahmeSays", "[viscous_heating]") {
  for (const auto& row : read_csv("validation/data/couette_nahme_exact.csv")) {
    const double na = row.at("Na");
    if (na > 20.0) continue;  // needs more nodes than the film takes
    INFO("Na " << na);
    const Couette v = heated_couette(na, 15, false);
    CHECK(std::abs(v.rise - std::log1p(na / 8.0)) < 1e-6);
    const double root = std::sqrt(na / 8.0);
    CHECK(std::abs(v.stress - std::asinh(root) / (root * std::sqrt(1.0 + root * root))) < 1e-6);
    CHECK(std::abs(v.rise / row.at("betadTmax_isothermal_walls") - 1.0) < 1e-5);  // six digits
    CHECK(std::abs(v.stress / row.at("tau_ratio_isothermal_walls") - 1.0) < 1e-5);
  }
}

TEST_CASE("CouetteFilmWithOneInsulatedWallIsTwiceAsThick", "[viscous_heating]") {
  for (const auto& row : read_csv("validation/data/couette_nahme_exact.csv")) {
    const double na = row.at("Na");
    if (na > 5.0) continue;  // its half profile is as steep as that of four times the number
    INFO("Na " << na);
    const Couette v = heated_couette(na, 15, true);
    CHECK(std::abs(v.rise - std::log1p(na / 2.0)) < 1e-6);
    CHECK(std::abs(v.rise / row.at("betadTmax_one_adiabatic") - 1.0) < 1e-5);
    CHECK(std::abs(v.stress / row.at("tau_ratio_one_adiabatic") - 1.0) < 1e-5);
  }
}

TEST_CASE("HeatedCouetteConvergesSpectrally", "[viscous_heating]") {
  const double exact = std::log1p(10.0 / 8.0);
  double before = INFINITY;
  for (const int n : {5, 7, 9, 11, 13}) {
    const double error = std::abs(heated_couette(10.0, n, false).rise - exact);
    INFO("n " << n << ", error " << error);
    CHECK(error < 0.3 * before);  // geometric: a power of n falls ever more slowly
    before = error;
  }
  CHECK(before < 1e-5);
}

namespace {

/// Outlet temperature rise times beta of an adiabatic parallel film fed along a line, moving as a
/// plug; nodes of the walls take the film's temperature.
double adiabatic_outlet(int nt, double duty) {
  Ring r(nt, 1, 5, kT0);
  const double length = 2.0 * kPi * r.grid.radius;
  const double flow = 1e-3;  // [kg/s]
  // duty = 2 beta eta0 U L/(rho cp h^2) with heat eta U^2/h per area and flow rho U h B/2
  const double heat = duty * flow * 2000.0 / (kBeta * length * r.grid.width);  // [W/m2] at T0
  for (int c = 0; c < nt; ++c) r.west_flow(c, [flow](double) { return flow; });
  r.problem.line[0] = 0;
  r.problem.lines.push_back({0, 0, std::vector<double>(5, flow)});
  r.problem.vessels.push_back({kT0, 2000.0, 2000.0, 0.0, 0.0});  // nothing carried over
  for (int turn = 0; turn < 200; ++turn) {
    for (int c = 0; c < nt; ++c) {
      for (int k = 0; k < 5; ++k) {
        r.problem.heat[r.at(c, k)] =
            r.gl.w[k] * heat * r.grid.area(c, 0) * std::exp(-kBeta * (r.T[r.at(c, k)] - kT0));
      }
    }
    FilmEnergy film = r.film();
    film.sweep(r.T);
    double change = 0.0;
    for (int c = 0; c < nt; ++c) {
      const double middle = r.T[r.at(c, 2)];
      change = std::max(change, std::abs(middle - r.T[r.at(c, 0)]));
      r.T[r.at(c, 0)] = r.T[r.at(c, 4)] = middle;
    }
    if (change < 1e-12) break;
  }
  return kBeta * (r.T[r.at(nt - 1, 2)] - kT0);
}

}  // namespace

TEST_CASE("AdiabaticFilmHeatsUpWithTheLogarithmOfItsLength", "[viscous_heating]") {
  const double duty = 3.0;  // exp(beta dT) = 1 + duty at the outlet
  const double a = adiabatic_outlet(50, duty);
  const double b = adiabatic_outlet(100, duty);
  const double c = adiabatic_outlet(200, duty);
  CHECK(std::abs(observed_order(a, b, c) - 1.0) < 0.15);  // first-order upwind
  // what the leading error leaves: (1/200)^2 of the rise
  CHECK(std::abs(richardson(b, c, 1.0) - std::log(1.0 + duty)) < 1e-4);
}
