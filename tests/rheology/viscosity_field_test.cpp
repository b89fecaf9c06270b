#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/contract.hpp"
#include "rheology/shear.hpp"
#include "rheology/viscosity.hpp"
#include "tests/rheology/oils.hpp"

using namespace shellback;
using namespace shellback::rheology;
using namespace shellback::rheology::test;

namespace {

/// Vector exp and log are good to 4 units in the last place, the exponents are below 20: the two
/// roads may differ by 20 * 4 * 1.1e-16 = 1e-14.
constexpr double kVectorTolerance = 1e-14;

struct Nodes {
  std::vector<double> T, p, out;
};

Nodes nodes(std::size_t n) {
  Nodes at{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(n);
    at.T[i] = celsius(20.0 + 130.0 * s);
    at.p[i] = 3e8 * std::fmod(7.3 * s, 1.0);
  }
  return at;
}

/// Largest relative residual of eta = eta_low f(tau/eta).
double residual(const Cross& law, const std::vector<double>& low, const std::vector<double>& tau,
                const std::vector<double>& eta) {
  double worst = 0.0;
  for (std::size_t i = 0; i < low.size(); ++i) {
    const double f = shear_factor(law, tau[i] / eta[i]).value;
    worst = std::max(worst, std::abs(low[i] * f / eta[i] - 1.0));
  }
  return worst;
}

}  // namespace

TEST_CASE("AFieldHasTheViscosityOfItsNodes") {
  const TemperatureLaw by_T[] = {ConstantViscosity{0.01}, Vogel{0.09521e-3, 896.4, 110.0},
                                 ReynoldsSlope{0.0277, 313.15, 0.0341}};
  const PressureLaw by_p[] = {NoPressureEffect{}, Barus{9.5e-9}, Roelands{0.6},
                              Houpert{0.6, 0.03, 363.15}};
  for (const std::size_t n : {0u, 1u, 7u, 300u}) {  // empty, tails of the vector loop, a block
    Nodes at = nodes(n);
    for (const auto& temperature : by_T) {
      for (const auto& pressure : by_p) {
        Oil oil;
        oil.temperature = temperature;
        oil.pressure = pressure;
        double worst = 0.0, worst_slope = 0.0;
        viscosity(oil, at.T, at.p, at.out);
        for (std::size_t i = 0; i < n; ++i) {
          worst = std::max(worst, std::abs(at.out[i] / viscosity(oil, at.T[i], at.p[i]) - 1.0));
        }
        pressure_slope(oil, at.T, at.p, at.out);
        for (std::size_t i = 0; i < n; ++i) {
          const double one = pressure_slope(oil, at.T[i], at.p[i]);
          worst_slope = std::max(worst_slope, std::abs(at.out[i] - one) / 1e-8);
        }
        CHECK(worst < kVectorTolerance);
        CHECK(worst_slope < kVectorTolerance);
      }
    }
  }
}

TEST_CASE("TheThinnedViscosityBelongsToItsStress") {
  const std::size_t n = 700;  // two whole blocks and a part
  for (const Cross& law : {Cross{0.5, 4.5e-8, 0.457}, Cross{0.01, 1e-6, 1.0},
                           Cross{0.04, 1e-7, 1.45}, Cross{0.0, 1e-7, 0.9}, Cross{0.9, 1e-3, 0.2}}) {
    REQUIRE(stress_is_monotone(law));
    Oil oil;
    oil.shear = law;
    std::vector<double> low(n), tau(n), eta(n);
    for (const double guess : {0.0, 1e-12, 1e-3, 1e6}) {
      for (std::size_t i = 0; i < n; ++i) {
        const double s = static_cast<double>(i) / static_cast<double>(n - 1);
        low[i] = 1e-3 * std::pow(1e4, std::fmod(3.7 * s, 1.0));
        tau[i] = i == 0 ? 0.0 : std::pow(10.0, -3.0 + 12.0 * s);
        eta[i] = guess;
      }
      shear_thinned(oil, low, tau, eta);
      CHECK(eta[0] == low[0]);
      // The residual is that of f at a rate which itself carries the error of eta, amplified by
      // 1 + |d ln f/d ln rate| < 2, plus the scalar pow of the check (u^m, log up to 40).
      CHECK(residual(law, low, tau, eta) < 2e-14);
      for (std::size_t i = 0; i < n; ++i) {
        CHECK(eta[i] <= low[i] * (1.0 + 1e-15));
        CHECK(eta[i] >= low[i] * law.r);
      }
    }
  }
}

TEST_CASE("ThinningIsKnownInClosedFormForUnitExponent") {
  // m = 1: eta = low (r x + eta... ) with x = K tau: eta^2 + (x - low) eta - r low x = 0.
  const Cross law{0.3, 2e-7, 1.0};
  Oil oil;
  oil.shear = law;
  const std::vector<double> low(5, 8e-3), tau{0.0, 1e2, 1e4, 1e6, 1e9};
  std::vector<double> eta(5, 0.0);
  shear_thinned(oil, low, tau, eta);
  for (std::size_t i = 0; i < tau.size(); ++i) {
    const double x = law.K * tau[i], b = x - low[i], c = law.r * low[i] * x;
    const double root = std::sqrt(b * b + 4.0 * c);
    // The form without cancellation on each side of b = 0.
    const double exact = b > 0.0 ? 2.0 * c / (b + root) : 0.5 * (root - b);
    CHECK(eta[i] == Approx(exact).epsilon(1e-14));
  }
}

TEST_CASE("TheSignOfTheStressDoesNotMatter") {
  const Oil oil = oil_0W20();
  const std::vector<double> low(3, 5e-3), tau{1e3, 1e5, 1e6}, minus{-1e3, -1e5, -1e6};
  std::vector<double> a(3, 0.0), b(3, 0.0);
  shear_thinned(oil, low, tau, a);
  shear_thinned(oil, low, minus, b);
  CHECK(a == b);
}

TEST_CASE("ALawWithoutThinningReturnsTheLowShearViscosity") {
  const std::vector<double> low{1e-3, 2e-3}, tau{1e5, 1e9};
  for (const ShearLaw& law : {ShearLaw{NoShearThinning{}}, ShearLaw{Cross{1.0, 1e-7, 0.5}},
                              ShearLaw{Cross{0.5, 0.0, 0.5}}}) {
    Oil oil;
    oil.shear = law;
    std::vector<double> eta{5.0, 0.0};
    shear_thinned(oil, low, tau, eta);
    CHECK(eta == low);
  }
}

TEST_CASE("AnAmbiguousShearLawIsRefused") {
  Oil oil;
  oil.shear = Cross{0.01, 1e-7, 2.0};
  const std::vector<double> low{1e-3}, tau{1e5};
  std::vector<double> eta{0.0};
  CHECK_THROWS_AS(shear_thinned(oil, low, tau, eta), InputError);
}
