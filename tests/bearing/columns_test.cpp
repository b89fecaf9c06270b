#include "bearing/columns.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <numeric>

#include "rheology/shear.hpp"
#include "rheology/viscosity.hpp"
#include "tests/bearing/sample_bearing.hpp"

using namespace shellback;
using namespace shellback::bearing;
using shellback::bearing::tests::random_field;
using shellback::bearing::tests::rig_case;

namespace {

/// A few columns of given gap, gradients and temperatures.
struct Scene {
  rheology::Oil oil;
  CrossFilmNodes gl;
  double speed = 8.0;  // [m/s]
  Field h, gx, gz;
  fluid::FilmState film;
  OilColumns columns;
  fluid::FilmCoefficients out;
  std::vector<int> supply;  ///< none

  Scene(int cells, int n) : gl(gauss_lobatto(n)), columns(uniform_columns(cells, n, 373.15)) {
    h = random_field(cells, 1, 1e-6, 20e-6);
    supply.assign(cells, -1);
    gx = random_field(cells, 2, -1e10, 1e10);
    gz = random_field(cells, 3, -1e10, 1e10);
    film.p = random_field(cells, 4, 0.0, 8e7);
    film.theta.assign(cells, 1.0);
    film.full.assign(cells, 1);
  }
  void set_T(const std::function<double(double)>& profile) {
    for (std::size_t k = 0; k < columns.T.size(); ++k) columns.T[k] = profile(gl.s[k % gl.n]);
  }
  void update(double tolerance = 1e-13) {
    update_columns(oil, gl, speed, h, supply, film, gx, gz, tolerance, columns, out);
  }
  [[nodiscard]] double stress(std::size_t cell, int k) const {
    const double from_centre = gl.s[k] - columns.centre[cell];
    const double arm = std::abs(from_centre) < 1e-14 ? 0.0 : h[cell] * from_centre;  // round-off
    return std::hypot(gx[cell] * arm + speed / (h[cell] * columns.g0[cell]), gz[cell] * arm);
  }
};

/// Integral over [0, 1] by Simpson's rule.
double integral(const std::function<double(double)>& f) {
  constexpr int kHalf = 2000;
  double sum = f(0.0) + f(1.0);
  for (int k = 1; k < 2 * kHalf; ++k) sum += (k % 2 ? 4.0 : 2.0) * f(k / (2.0 * kHalf));
  return sum / (6.0 * kHalf);
}

}  // namespace

TEST_CASE("UniformOilHasTheTextbookFluidity", "[columns]") {
  Scene s(4, 5);
  s.oil.temperature = rheology::ConstantViscosity{0.012};
  s.update();
  for (int c = 0; c < 4; ++c) {  // round-off
    CHECK(s.out.fluidity[c] * 12.0 * 0.012 == Approx(1.0).epsilon(1e-14));
    CHECK(std::abs(s.columns.centre[c] - 0.5) < 1e-15);
    CHECK(std::abs(s.out.chi[c] - 0.5) < 1e-15);
    CHECK(s.columns.g0[c] * 0.012 == Approx(1.0).epsilon(1e-14));
  }
}

TEST_CASE("LinearFluidityGivesThePolynomialIntegrals", "[columns]") {
  // f = f0 (1 + a s), 1/eta in the Reynolds slope: T - at = ln(1 + a s)/beta
  const double a = 4.0;
  for (const int n : {4, 5, 9}) {  // f (s - centre)^2 is of degree 3
    Scene s(1, n);
    s.oil.temperature = rheology::ReynoldsSlope{0.02, 350.0, 0.04};
    s.set_T([a](double y) { return 350.0 + std::log1p(a * y) / 0.04; });
    s.update();
    const double g0 = 1.0 + a / 2.0;
    const double centre = (0.5 + a / 3.0) / g0;
    const double g = (1.0 / 3.0 + a / 4.0) - centre * centre * g0;
    CHECK(s.columns.g0[0] * 0.02 == Approx(g0).epsilon(1e-13));
    CHECK(s.columns.centre[0] == Approx(centre).epsilon(1e-13));
    CHECK(s.out.fluidity[0] * 0.02 == Approx(g).epsilon(1e-13));
  }
}

TEST_CASE("ExponentialFluidityConvergesToTheClosedForm", "[columns]") {
  const double a = 2.0;  // ln of the viscosity ratio over the film
  const double g0 = std::expm1(a) / a;
  const double g1 = (std::exp(a) - g0) / a;
  const double g2 = (std::exp(a) - 2.0 * g1) / a;
  double before = INFINITY;
  for (const int n : {4, 6, 8}) {
    Scene s(1, n);
    s.oil.temperature = rheology::ReynoldsSlope{0.02, 350.0, 0.04};
    s.set_T([a](double y) { return 350.0 + a * y / 0.04; });
    s.update();
    const double error = std::abs(s.columns.centre[0] - g1 / g0) +
                         std::abs(s.out.fluidity[0] * 0.02 - (g2 - g1 * g1 / g0));
    CHECK(error < 2e-3 * before);  // quadrature of degree 2n - 3: factorial convergence
    before = error;
  }
  CHECK(before < 1e-9);
}

TEST_CASE("ThinningOilObeysItsLawAndSticksToTheJournal", "[columns]") {
  Scene s(40, 9);
  s.oil = rig_case().oil;
  s.set_T([](double y) { return 360.0 + 40.0 * y * (1.5 - y); });
  s.update();
  CHECK(s.columns.mismatch < 1e-12);
  bool thinned = false;
  for (std::size_t c = 0; c < 40; ++c) {
    double u = 0.0;
    double w = 0.0;
    for (int k = 0; k < 9; ++k) {
      const std::size_t at = c * 9 + k;
      const double low = rheology::viscosity(s.oil, s.columns.T[at], s.film.p[c]);
      const double f =
          rheology::shear_factor(s.oil.shear, s.stress(c, k) / s.columns.eta[at]).value;
      CHECK(std::abs(s.columns.eta[at] / (low * f) - 1.0) < 1e-10);  // slope times mismatch
      thinned = thinned || f < 0.8;
      const double arm = s.h[c] * (s.gl.s[k] - s.columns.centre[c]);
      const double tau_x = s.gx[c] * arm + s.speed / (s.h[c] * s.columns.g0[c]);
      u += s.gl.w[k] * s.h[c] * tau_x / s.columns.eta[at];
      w += s.gl.w[k] * s.h[c] * s.gz[c] * arm / s.columns.eta[at];
    }
    CHECK(u == Approx(s.speed).epsilon(1e-11));  // int tau_x/eta dy = U
    CHECK(std::abs(w) < 1e-8);                   // no axial slip; of some 100 m/s of integrand
  }
  CHECK(thinned);
}

TEST_CASE("ThinnedViscositiesBelongToTheirStressFromAnyGuess", "[columns]") {
  // Laws whose stress hardly rises with the rate (slopes of ln f down to -0.97) among them; oil
  // that is dragged, pressed, or both.
  for (const rheology::Cross& law :
       {rheology::Cross{0.5, 4.5e-8, 0.457}, rheology::Cross{0.01, 1e-6, 1.0},
        rheology::Cross{0.04, 1e-7, 1.45}, rheology::Cross{0.0, 1e-7, 0.9},
        rheology::Cross{0.9, 1e-3, 0.2}}) {
    for (const double speed : {0.0, 8.0, -300.0}) {
      for (const double guess : {0.0, 1e-12, 1e-3, 1e6, 1e17, double{NAN}}) {
        Scene s(70, 5);  // two whole blocks and a part
        s.oil.temperature = rheology::ConstantViscosity{0.012};
        s.oil.shear = law;
        s.speed = speed;
        s.columns.eta.assign(s.columns.eta.size(), guess);
        if (guess == 0.0 && speed != 0.0) s.gx = s.gz = Field(70, 0.0);
        s.update();
        CAPTURE(law.r, law.m, speed, guess);
        CHECK(s.columns.mismatch <= 1e-13);
        double worst = 0.0;
        for (std::size_t at = 0; at < s.columns.eta.size(); ++at) {
          const double eta = s.columns.eta[at];
          const double rate = s.stress(at / 5, static_cast<int>(at % 5)) / eta;
          worst =
              std::max(worst, std::abs(0.012 * rheology::shear_factor(law, rate).value / eta - 1));
          CHECK(eta <= 0.012 * (1.0 + 1e-14));
          CHECK(eta >= 0.012 * law.r * (1.0 - 1e-14));
        }
        CHECK(worst < 1e-12);  // the last step, over 1 + slope
      }
    }
  }
}

TEST_CASE("WhatIsNoNumberIsSeenAndStaysInItsColumn", "[columns]") {
  Scene good(40, 5);
  good.oil = rig_case().oil;
  good.update();
  for (const int what : {0, 1, 2, 3, 4}) {
    Scene s = good;
    (what == 0   ? s.gx[7]
     : what == 1 ? s.gz[7]
     : what == 2 ? s.h[7]
     : what == 3 ? s.film.p[7]
                 : s.columns.T[7 * 5 + 2]) = NAN;
    s.update();
    CHECK(std::isnan(s.columns.mismatch));
    CHECK(std::isnan(s.out.fluidity[7]));
    for (int c = 0; c < 40; ++c) {
      if (c != 7) CHECK(s.out.fluidity[c] == Approx(good.out.fluidity[c]).epsilon(1e-12));
    }
    s.gx = good.gx;  // and is forgotten with the next state
    s.gz = good.gz;
    s.h = good.h;
    s.film.p = good.film.p;
    s.columns.T = good.columns.T;
    s.update();
    CHECK(s.columns.mismatch <= 1e-13);
    CHECK(s.out.fluidity[7] == Approx(good.out.fluidity[7]).epsilon(1e-12));
  }
}

TEST_CASE("WhatThinningAddsToTheFlowIsItsSlope", "[columns]") {
  // Flow around -h^3 g dp/dx + U h chi, along -h^3 g dp/dz, against differences.
  Scene s(40, 7);
  s.oil = rig_case().oil;
  s.set_T([](double y) { return 350.0 + 20.0 * y; });
  for (int c = 0; c < 40; ++c) {
    s.gx[c] *= 0.1;  // journal and pressure drive alike
    s.gz[c] *= 0.1;
  }
  s.update();
  const auto flow = [](const Scene& at, int c, bool around) {
    const double by_slope = -std::pow(at.h[c], 3) * at.out.fluidity[c];
    return around ? by_slope * at.gx[c] + at.speed * at.h[c] * at.out.chi[c] : by_slope * at.gz[c];
  };
  double largest = 0.0;
  for (const bool around : {true, false}) {
    Scene less = s, more = s;
    constexpr double kStep = 1e5;  // [Pa/m]
    for (int c = 0; c < 40; ++c) {
      (around ? less.gx : less.gz)[c] -= kStep;
      (around ? more.gx : more.gz)[c] += kStep;
    }
    less.update();
    more.update();
    for (int c = 0; c < 40; ++c) {
      const double slope = (flow(more, c, around) - flow(less, c, around)) / (2.0 * kStep);
      const double added = -slope / (std::pow(s.h[c], 3) * s.out.fluidity[c]) - 1.0;
      largest = std::max(largest, std::abs(added));
      // Along, the centre's own answer is left out, which is of the slopes' product.
      const double told = around ? s.out.thins_around[c] : s.out.thins_along[c];
      CHECK(told == Approx(added).epsilon(around ? 1e-3 : 0.1).margin(around ? 1e-5 : 2e-3));
    }
  }
  CHECK(largest > 0.05);  // else this test tells nothing
}

TEST_CASE("SurfacesPressedTogetherAtRestLeaveNumbers", "[columns]") {
  Scene s(3, 5);
  s.oil = rig_case().oil;
  s.speed = 0.0;
  s.h[1] = 0.0;
  s.update();
  for (int c = 0; c < 3; ++c) {
    CHECK(std::isfinite(s.out.fluidity[c]));
    CHECK(std::isfinite(s.out.thins_around[c]));
    CHECK(std::isfinite(s.out.thins_along[c]));
  }
}

TEST_CASE("PressedOilThinsInClosedFormForUnitExponent", "[columns]") {
  // At rest the stress is gx h (s - 1/2); m = 1: eta^2 + (K tau - low) eta - r low K tau = 0.
  const rheology::Cross law{0.3, 2e-7, 1.0};
  const double low = 8e-3;
  for (const double gx : {0.0, 1e6, 1e9, 1e12}) {
    Scene s(1, 7);
    s.oil.temperature = rheology::ConstantViscosity{low};
    s.oil.shear = law;
    s.speed = 0.0;
    s.gx[0] = gx;
    s.gz[0] = 0.0;
    s.update();
    for (int k = 0; k < 7; ++k) {
      const double x = law.K * gx * s.h[0] * std::abs(s.gl.s[k] - 0.5);
      const double b = x - low, c = law.r * low * x;
      const double root = std::sqrt(b * b + 4.0 * c);
      // The form without cancellation on each side of b = 0.
      const double exact = b > 0.0 ? 2.0 * c / (b + root) : 0.5 * (root - b);
      CHECK(s.columns.eta[k] == Approx(exact).epsilon(1e-13));
    }
  }
}

TEST_CASE("DissipationIsStressTimesRate", "[columns]") {
  Scene s(10, 7);
  s.oil.temperature = rheology::ReynoldsSlope{0.01, 350.0, 0.04};
  s.set_T([](double y) { return 350.0 + 20.0 * y; });
  s.update();
  const auto phi = dissipation(s.gl, s.speed, s.h, s.gx, s.gz, s.columns);
  for (std::size_t c = 0; c < 10; ++c) {
    double sum = 0.0;
    for (int k = 0; k < 7; ++k) sum += s.gl.w[k] * s.h[c] * phi[c * 7 + k];
    // Power per area: U tau_j less the work of the pressure gradient on the Couette flow, that is
    // U^2/(h g0) + (p_x^2 + p_z^2) h^3 g
    const double exact =
        s.speed * s.speed / (s.h[c] * s.columns.g0[c]) +
        (s.gx[c] * s.gx[c] + s.gz[c] * s.gz[c]) * std::pow(s.h[c], 3) * s.out.fluidity[c];
    CHECK(sum == Approx(exact).epsilon(1e-12));  // the same quadrature: round-off
  }
}

TEST_CASE("VelocityProfilesHaveUnitMeanAndTheFilmsShape", "[columns]") {
  Scene s(1, 12);
  s.oil.temperature = rheology::ReynoldsSlope{0.02, 350.0, 0.04};
  s.set_T([](double y) { return 350.0 + 30.0 * y * y; });
  s.update();
  const VelocityProfiles v = velocity_profiles(s.gl, s.columns);
  const auto f = [](double y) { return std::exp(0.04 * 30.0 * y * y); };
  const auto upto = [&](double top, const std::function<double(double)>& g) {
    return top * integral([&](double x) { return g(top * x); });
  };
  const double centre = integral([&](double y) { return y * f(y); }) / integral(f);
  const auto couette = [&](double y) { return upto(y, f); };
  const auto poiseuille = [&](double y) {
    return upto(y, [&](double x) { return (centre - x) * f(x); });
  };
  const double couette_mean = integral([&](double y) { return (1.0 - y) * f(y); });
  const double poiseuille_mean =
      integral([&](double y) { return (1.0 - y) * (centre - y) * f(y); });
  double means[2] = {};
  for (int k = 0; k < 12; ++k) {
    CHECK(std::abs(v.couette[k] - couette(s.gl.s[k]) / couette_mean) < 1e-7);  // 12 nodes
    CHECK(std::abs(v.poiseuille[k] - poiseuille(s.gl.s[k]) / poiseuille_mean) < 1e-7);
    means[0] += s.gl.w[k] * v.couette[k];
    means[1] += s.gl.w[k] * v.poiseuille[k];
  }
  CHECK(means[0] == Approx(1.0).epsilon(1e-14));
  CHECK(means[1] == Approx(1.0).epsilon(1e-14));
  CHECK(std::abs(v.poiseuille[0]) < 1e-14);
  CHECK(std::abs(v.poiseuille[11]) < 1e-13);
}

TEST_CASE("NodeFlowsAddUpToTheFaceFlows", "[columns]") {
  const Solution s = solve_tier(bearing::tests::grooved_case(), Tier::thd);
  REQUIRE(s.verdict.good());
  const auto p =
      film_energy_problem(s.model, s.point, s.film, friction_of(s.model, s.point, s.film));
  const int n = s.model.gl.n;
  const double scale = fluid::flow_scale(s.film.flow);
  const auto check = [&](const std::vector<fluid::FaceFlow>& faces,
                         const std::vector<double>& nodes) {
    double worst = 0.0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      double sum = 0.0;
      for (int k = 0; k < n; ++k) sum += s.model.gl.w[k] * nodes[f * n + k];
      worst = std::max(worst, std::abs(sum - faces[f].m));
    }
    CHECK(worst < 1e-13 * scale);  // profiles of unit mean: round-off
  };
  check(s.film.flow.phi, p.phi_flow);
  check(s.film.flow.z, p.z_flow);
}

TEST_CASE("FrictionCoolsNoNodeOfAChamfer", "[columns]") {
  Case c = bearing::tests::warm_case();
  c.bearing.chamfer = EdgeOpening{200e-6, 0.5e-3};  // seven clearances
  c.model.grid = {48, 8};
  const Solution s = solve_tier(c, Tier::thd);
  REQUIRE(s.verdict.good());
  const Friction friction = friction_of(s.model, s.point, s.film);
  const auto p = film_energy_problem(s.model, s.point, s.film, friction);
  const FilmGrid& g = s.model.domain.grid;
  const int n = s.model.gl.n;
  double sum = 0.0;
  int heated = 0;
  for (int cell = 0; cell < g.cells(); ++cell) {
    const double* heat = &p.heat[static_cast<std::size_t>(cell) * n];
    const double of_cell = std::accumulate(heat, heat + n, 0.0);
    sum += of_cell;
    if (!(of_cell > 0.0)) continue;
    ++heated;
    for (int k = 0; k < n; ++k) CHECK(heat[k] >= -1e-14 * of_cell);  // round-off
  }
  CHECK(heated > g.cells() / 2);
  for (const auto& vessel : p.vessels) sum += vessel.heat;
  // All of it, wherever it is: friction power and pump power.
  const double power =
      s.point.scene.speed / g.radius * friction.viscous + pump_power(s.model, s.point, s.film);
  CHECK(g.multiplicity() * (sum + p.throttled) == Approx(power).epsilon(1e-10));
  // Nothing around it is colder than its oil and its surroundings.
  const auto& T = s.film.columns.T;
  CHECK(*std::min_element(T.begin(), T.end()) > c.shaft->ambient);
}

TEST_CASE("ADryColumnHasTheTemperaturesOfItsWalls") {
  Case c = shellback::bearing::tests::warm_case();
  const BearingModel model = make_bearing(c, physics_of(c, Tier::thd), {24, 4});
  OperatingPoint point = operating_point(model);
  FilmEquilibrium film = cold_start(model, point, 313.15);
  const int nz = model.domain.grid.nz;
  const int cell = 12 * nz;  // no oil comes to it, and none is there: neighbours and speed at rest
  point.scene.speed = 0.0;
  for (int k = 0; k < model.domain.grid.cells(); ++k) {
    if (model.supply.cell[k] >= 0) continue;
    film.film.theta[k] = 0.0;
    film.film.full[k] = 0;
  }
  REQUIRE(evaluate(model, point, {}, 1e-10, film));
  auto problem = film_energy_problem(model, point, film, friction_of(model, point, film));
  std::fill(problem.phi_flow.begin(), problem.phi_flow.end(), 0.0);
  std::fill(problem.z_flow.begin(), problem.z_flow.end(), 0.0);
  std::fill(problem.heat.begin(), problem.heat.end(), 0.0);
  thermal::FilmEnergy energy(std::move(problem));
  const int n = model.gl.n;
  std::vector<double> T = film.columns.T;
  const double shell = 320.0;
  const double shaft = 330.0;
  T[cell * n] = shell;
  T[cell * n + n - 1] = shaft;
  static_cast<void>(energy.sweep(T));
  for (int k = 0; k < n; ++k) {
    CHECK(T[cell * n + k] == Approx(shell + model.gl.s[k] * (shaft - shell)).epsilon(1e-9));
  }
}
