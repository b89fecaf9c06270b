/// Heat capacity of shell and housing: closed forms, balance, limits.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/make_grid.hpp"
#include "tests/thermal/sample_shell.hpp"

using namespace shellback;
using namespace shellback::thermal;
using namespace shellback::thermal::tests;

namespace {

const std::vector<double> kCapacity{2.4e6, 3.6e6};  // [J/(m3 K)]

/// Wall a < r < b of one material, heated by cos(n phi) from the bore, its outer surface held cold:
/// eigenfunctions J_n(beta r) Y_n(beta b) - Y_n(beta r) J_n(beta b) without flux at a.
struct Wall {
  int n;
  double a = kRadius, b = kRadius + 13e-3, k = 50.0, rho_c = 3.6e6;

  [[nodiscard]] double steady(double r) const {  // for unit flux at the bore
    if (n == 0) return a / k * std::log(b / r);
    const auto f = [&](double x) { return std::pow(x / b, n) - std::pow(b / x, n); };
    return -a / (k * n) * f(r) / (std::pow(a / b, n) + std::pow(b / a, n));
  }
  [[nodiscard]] double mode(double beta, double r) const {
    return std::cyl_bessel_j(n, beta * r) * std::cyl_neumann(n, beta * b) -
           std::cyl_neumann(n, beta * r) * std::cyl_bessel_j(n, beta * b);
  }
  [[nodiscard]] double slope_at_bore(double beta) const {  // x C_n' = n C_n - x C_{n+1}
    const double x = beta * a;
    return n * mode(beta, a) - x * (std::cyl_bessel_j(n + 1, x) * std::cyl_neumann(n, beta * b) -
                                    std::cyl_neumann(n + 1, x) * std::cyl_bessel_j(n, beta * b));
  }
  [[nodiscard]] std::vector<double> roots(int count) const {
    std::vector<double> found;
    const double step = 0.03 * kPi / (b - a);
    for (double low = 0.5 * step; static_cast<int>(found.size()) < count; low += step) {
      double x = low, y = low + step;
      const bool rising = slope_at_bore(x) < 0.0;
      if (rising == (slope_at_bore(y) < 0.0)) continue;
      for (int i = 0; i < 60; ++i) {
        const double m = 0.5 * (x + y);
        ((slope_at_bore(m) < 0.0) == rising ? x : y) = m;
      }
      found.push_back(0.5 * (x + y));
    }
    return found;
  }
  /// Part of a mode in the steady state, at the bore (Simpson's rule).
  [[nodiscard]] double part(double beta) const {
    constexpr int kCuts = 2000;
    double over = 0.0, under = 0.0;
    for (int i = 0; i <= kCuts; ++i) {
      const double r = a + (b - a) * i / kCuts, f = mode(beta, r);
      const double w = (i == 0 || i == kCuts ? 1.0 : i % 2 ? 4.0 : 2.0) * r;
      over += w * steady(r) * f;
      under += w * f * f;
    }
    return over / under * mode(beta, a);
  }
  /// Bore temperature after the time t: exactly, or as implicit Euler's `steps` have it.
  [[nodiscard]] double bore(double t, int steps = 0) const {
    double T = steady(a);
    for (const double beta : roots(40)) {
      const double x = k / rho_c * beta * beta * t;
      T -= part(beta) * (steps == 0 ? std::exp(-x) : std::pow(1.0 + x / steps, -steps));
    }
    return T;
  }
};

ShellConduction steady_wall(const Wall& w, int halvings) {
  const auto grid = make_grid(w.a, kWidth, 64, 3, true);
  auto rows = rows_outwards(w.a, {w.b - w.a}, 0.25 * (w.b - w.a));
  for (int i = 0; i < halvings; ++i) rows = halved(rows);
  const auto mesh = make_revolution_mesh(rows.face, rows.layer, {0.0, 0.5 * kWidth}, true);
  return {mesh, grid, {w.k}, {BackKind::prescribed, 0.0, 0.0, mesh.rows}, Harmonics(grid, w.n)};
}

/// Bore temperature after `steps` steps to the time t, found by the discrete wall.
double marched(const Wall& w, double t, int steps, int halvings) {
  const auto shell = steady_wall(w, halvings).over(t / steps, {w.rho_c});
  const int column = w.n == 0 ? 0 : 2 * w.n - 1;
  Eigen::MatrixXd T = shell.uniform_temperatures(0.0);
  Eigen::MatrixXd flux = Eigen::MatrixXd::Zero(shell.surface()[0].cols(), T.cols());
  flux.col(column).setOnes();
  for (int i = 0; i < steps; ++i) {
    const auto history = shell.history(T);
    T = shell.nodal_temperatures(flux, &history);
  }
  return T(0, column);
}

}  // namespace

TEST_CASE("HeatedWallFollowsTheSeries", "[shell_in_time]") {
  for (const int n : {0, 2}) {
    const Wall wall{n};
    const double t = 2.0;  // of the slowest mode's 4.9 s (n = 0)
    const double exact = wall.bore(t);
    std::vector<double> error;
    for (const int steps : {20, 40, 80}) {
      error.push_back(std::abs(marched(wall, t, steps, 2) - exact) / exact);
    }
    CHECK(error.back() < 3e-3);
    CHECK(std::log2(error[0] / error[1]) == Approx(1.0).margin(0.15));
    CHECK(std::log2(error[1] / error[2]) == Approx(1.0).margin(0.15));
  }
}

TEST_CASE("WallInTimeConvergesInSpaceLikeTheSteadyOne", "[shell_in_time]") {
  for (const int n : {0, 2}) {
    const Wall wall{n};
    const double exact = wall.bore(2.0, 4);  // the same steps of time, no mesh
    std::vector<double> error;
    for (const int halvings : {0, 1, 2}) {
      error.push_back(std::abs(marched(wall, 2.0, 4, halvings) - exact) / exact);
    }
    CHECK(error.back() < 1e-5);
    // energy of a field of order 2, as in BoreTemperatureConvergesWithFourthOrder
    CHECK(std::log2(error[0] / error[1]) > 3.5);
    CHECK(std::log2(error[1] / error[2]) > 3.5);
  }
}

TEST_CASE("HeatIntoTheBoreLeavesOrIsStored", "[shell_in_time]") {
  for (const bool half : {true, false}) {
    const auto s = shell(half, 0, {0.4, 0.62, 3.3});
    for (const auto& boundary : {kConvective, kPrescribed}) {
      const auto c = conduction(s, boundary, 0, 12).over(0.3, kCapacity);
      const Field q = random_flux(s.grid, 5), old(s.grid.cells(), 380.0);
      Eigen::MatrixXd T = c.uniform_temperatures(15.0);
      for (int step = 0; step < 5; ++step) {
        const auto past = c.history(T);
        const auto t = c.solve(q, {1e4, 2e4}, old, 350.0, true, &past);
        double offered = 0.0;
        for (int i = 0; i < s.grid.nt; ++i) {
          for (int j = 0; j < s.grid.nz; ++j) {
            const int k = s.grid.index(i, j);
            offered +=
                s.grid.multiplicity() * s.grid.area(i, j) * (q[k] - 1e4 * (t.surface[k] - old[k]));
          }
        }
        const double scale = 100.0;  // [W], the size of the flows
        CHECK(std::abs(t.heat_in - offered) < 1e-11 * scale);
        CHECK(std::abs(t.heat_back + t.heat_ends + t.stored - t.heat_in) < 1e-12 * scale);
        CHECK(std::abs(t.stored) > 1e-2);
        T = c.nodal_temperatures(t.flux, &past);
        const auto again = c.at(T, 350.0);
        for (std::size_t k = 0; k < q.size(); ++k) {
          CHECK(again.surface[k] == Approx(t.surface[k]).epsilon(1e-13));
        }
      }
    }
  }
}

TEST_CASE("UniformShellStoresItsCapacity", "[shell_in_time]") {
  // one step without flux, so long that all heat is out: stored = -rho c V dT / dt
  const auto s = shell(true);
  const double dt = 1e9, rise = 12.0;
  const auto c = conduction(s, kConvective, 1, 3).over(dt, kCapacity);
  const auto past = c.history(c.uniform_temperatures(rise));
  double capacity = 0.0, r = kRadius;
  for (std::size_t i = 0; i < kThickness.size(); ++i) {
    const double outer = r + kThickness[i];
    capacity += kCapacity[i] * kPi * (outer * outer - r * r) * kWidth;
    r = outer;
  }
  CHECK(past.stored == Approx(-capacity * rise / dt).epsilon(1e-6));  // 1e-6: what is still in
  CHECK(past.heat_back + past.heat_ends == Approx(-past.stored).epsilon(1e-12));
}

TEST_CASE("LongMarchOfTheShellEndsSteady", "[shell_in_time]") {
  const auto s = shell(false, 0, {0.4, 0.62, 3.3});
  const Field q = random_flux(s.grid, 3), old(s.grid.cells(), 370.0);
  for (const auto& boundary : {kConvective, kPrescribed}) {
    const auto steady = conduction(s, boundary, 0, 12);
    const auto end = steady.solve(q, 5e3, old, 350.0);
    const auto c = steady.over(200.0, kCapacity);  // the slowest mode: 90 s
    Eigen::MatrixXd T = c.uniform_temperatures(-30.0);
    ShellTemperature t;
    for (int step = 0; step < 40; ++step) {
      const auto past = c.history(T);
      t = c.solve(q, {5e3, 5e3}, old, 350.0, true, &past);
      T = c.nodal_temperatures(t.flux, &past);
    }
    for (std::size_t k = 0; k < q.size(); ++k) {
      CHECK(t.surface[k] == Approx(end.surface[k]).epsilon(1e-12));
      CHECK(t.back[k] == Approx(end.back[k]).epsilon(1e-12));
    }
    CHECK((T - steady.nodal_temperatures(end.flux)).cwiseAbs().maxCoeff() < 1e-9);
    CHECK(std::abs(t.stored) < 1e-9);
  }
}

TEST_CASE("SteadyStateStaysInTime", "[shell_in_time]") {
  const auto s = shell(true);
  const Field q = random_flux(s.grid, 8);
  const auto steady = conduction(s, kConvective, 0, 12);
  const auto end = steady.solve(q, 0.0, q, 350.0);
  for (const double dt : {1e-4, 1.0, 1e4}) {
    const auto c = steady.over(dt, kCapacity);
    const auto past = c.history(steady.nodal_temperatures(end.flux));
    const auto t = c.solve(q, {0.0, 0.0}, q, 350.0, true, &past);
    for (std::size_t k = 0; k < q.size(); ++k) {
      CHECK(t.surface[k] == Approx(end.surface[k]).epsilon(1e-11));
    }
  }
}

TEST_CASE("TurnedShellIsTheTurnedAnswer", "[shell_in_time]") {
  const auto s = shell(true);
  const auto c = conduction(s, kConvective, 0, 12).over(0.1, kCapacity);
  const int by = 17;
  const auto turned = [&](const Field& f) {
    Field g(f.size());
    for (int i = 0; i < s.grid.nt; ++i) {
      for (int j = 0; j < s.grid.nz; ++j) {
        g[s.grid.index((i + by) % s.grid.nt, j)] = f[s.grid.index(i, j)];
      }
    }
    return g;
  };
  const auto two_steps = [&](const Field& q) {
    Eigen::MatrixXd T = c.uniform_temperatures(5.0);
    ShellTemperature t;
    for (int step = 0; step < 2; ++step) {
      const auto past = c.history(T);
      t = c.solve(q, {1e4, 2e4}, Field(q.size(), 360.0), 350.0, true, &past);
      T = c.nodal_temperatures(t.flux, &past);
    }
    return t.surface;
  };
  const Field q = random_flux(s.grid, 4), first = turned(two_steps(q)), then = two_steps(turned(q));
  for (std::size_t k = 0; k < q.size(); ++k) CHECK(then[k] == Approx(first[k]).epsilon(1e-12));
}

TEST_CASE("FluxesWarmEachOtherMutuallyInTime", "[shell_in_time]") {
  const auto s = shell(false);
  const Eigen::Map<const Eigen::VectorXd> dz(s.grid.dz.data(), s.grid.nz);
  const auto c = conduction(s, kConvective, 1, 8).over(0.01, kCapacity);
  for (const auto& z : c.surface()) {
    const Eigen::MatrixXd w = dz.asDiagonal() * z;
    CHECK((w - w.transpose()).norm() < 1e-12 * w.norm());
  }
}

TEST_CASE("ShellWithoutCapacityOrTimeIsRefused", "[shell_in_time]") {
  const auto c = conduction(shell(true), kConvective, 0, 2);
  CHECK_THROWS_AS(c.over(0.0, kCapacity), InputError);
  CHECK_THROWS_AS(c.over(INFINITY, kCapacity), InputError);
  CHECK_THROWS_AS(c.over(1.0, {0.0, 3.6e6}), InputError);
}
