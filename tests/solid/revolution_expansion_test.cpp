#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "core/constants.hpp"
#include "tests/solid/revolution_bodies.hpp"

using namespace shellback;
using namespace shellback::solid;
using namespace shellback::test;

namespace {

/// Thermal deformation of the bore [m] under nodal temperatures f(r) of harmonic n.
Eigen::VectorXd grow(const Bush& b, const ElasticOperators& e, int n,
                     const std::function<double(double)>& f) {
  Eigen::VectorXd t(b.mesh.nodes());
  for (int a = 0; a < b.mesh.nodes(); ++a) t(a) = f(b.mesh.r[a]);
  return e.thermal_deformation[n] * t;
}

}  // namespace

TEST_CASE("UniformHeatingOfAFreeBodyScalesIt", "[growth]") {
  for (const bool half : {true, false}) {
    const auto b = bush(half, {1e-3, 10e-3});
    for (const Support s : {Support::held, Support::free}) {
      const auto e = shell_elasticity(b.mesh, b.grid, {steel(), steel()}, {1, s});
      const Eigen::VectorXd u = uniform_expansion(e);
      for (int j = 0; j < b.grid.nz; ++j) {
        CHECK(u(j) == Approx(11e-6 * 0.024).epsilon(1e-10));  // linear field: only round-off
      }
    }
  }
}

TEST_CASE("ClampedBushGrowsInwards", "[growth]") {
  const double a = 0.024, b_out = 0.034, nu = 0.3, alpha = 11e-6;
  const auto b = bush(true, {b_out - a});
  const auto e =
      shell_elasticity(b.mesh, b.grid, {steel()}, {0, Support::clamped, AxialEnds::plane_strain});
  // plane-strain ring, uniform temperature, u(b) = 0, sigma_rr(a) = 0 (textbook)
  const double square = b_out * b_out - a * a;
  const double c1 =
      -(1 + nu) / (1 - nu) * alpha * square / 2 / (b_out * b_out + a * a / (1 - 2 * nu));
  const double exact = c1 * a * 2 * (1 - nu) / (1 - 2 * nu);
  REQUIRE(exact < 0.0);
  CHECK(uniform_expansion(e)(2) == Approx(exact).epsilon(2e-4));  // as Lame's ring
}

TEST_CASE("BoreOfAFreeRingFollowsTheMeanTemperature", "[growth]") {
  // plane strain: u(a) = 2 (1 + nu) alpha a int T r dr / (b^2 - a^2) (textbook)
  const double a = 0.024, b_out = 0.034;
  const auto b = bush(true, {b_out - a});
  const auto e =
      shell_elasticity(b.mesh, b.grid, {steel()}, {0, Support::free, AxialEnds::plane_strain});
  const auto t = [&](double r) { return (b_out - r) / (b_out - a); };
  const double integral =
      (b_out * (b_out * b_out - a * a) / 2 - (std::pow(b_out, 3) - std::pow(a, 3)) / 3) /
      (b_out - a);
  const double exact = 2 * 1.3 * 11e-6 * a * integral / (b_out * b_out - a * a);
  CHECK(grow(b, e, 0, t)(2) == Approx(exact).epsilon(2e-4));  // as Lame's ring
}

TEST_CASE("HarmonicTemperatureLeavesAFreeRingWithoutStress", "[growth]") {
  // T = Re f(z) with f analytic: u + i v = (1 + nu) alpha int f dz, no stress in the plane;
  // r^-n with n = 1 would need a dislocation
  const double a = 0.024;
  const auto b = bush(true, {6e-3}, 5, 48);
  const auto e =
      shell_elasticity(b.mesh, b.grid, {steel()}, {4, Support::free, AxialEnds::plane_strain});
  for (int n = 1; n <= 4; ++n) {
    const double out = 1.3 * 11e-6 * a / (n + 1);
    const auto u = grow(b, e, n, [&](double r) { return std::pow(r / a, n); });
    CHECK(u(1) == Approx(out).epsilon(1e-3));  // mesh error as in RingFollowsMichell
    if (n == 1) continue;
    const auto v = grow(b, e, n, [&](double r) { return std::pow(r / a, -n); });
    CHECK(v(1) == Approx(1.3 * 11e-6 * a / (1 - n)).epsilon(1e-3));
  }
}

TEST_CASE("OuterLayerThatExpandsMoreOpensTheBore", "[growth]") {
  const auto b = bush(true, {2e-3, 10e-3});
  Material aluminium = steel();
  aluminium.expansion = 23e-6;
  aluminium.youngs_modulus = 70e9;
  const auto e = shell_elasticity(b.mesh, b.grid, {steel(), aluminium}, {0, Support::free});
  const double u = uniform_expansion(e)(0);
  CHECK(u > 11e-6 * 0.024);
  CHECK(u < 23e-6 * 0.024);
}
