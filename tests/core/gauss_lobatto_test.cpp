#include "core/gauss_lobatto.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace shellback;

namespace {

constexpr int kMost = 12;         ///< nodes tested
constexpr double kSlack = 2e-13;  ///< entries of D reach 2 n^2 = 300: 300 x 12 sums x 1e-16

/// (s - 0.3)^d: no coefficient of its expansion vanishes.
double power(double s, int d) { return std::pow(s - 0.3, d); }
double integral(double s, int d) { return (power(s, d + 1) - power(0.0, d + 1)) / (d + 1); }
double slope(double s, int d) { return d == 0 ? 0.0 : d * power(s, d - 1); }

double apply(const std::vector<double>& m, const CrossFilmNodes& gl, int row, int degree) {
  double sum = 0.0;
  for (int l = 0; l < gl.n; ++l) sum += m[row * gl.n + l] * power(gl.s[l], degree);
  return sum;
}

}  // namespace

TEST_CASE("NodesRunFromWallToWallAndAreSymmetric") {
  for (int n = 3; n <= kMost; ++n) {
    const CrossFilmNodes gl = gauss_lobatto(n);
    CHECK(gl.s.front() == 0.0);
    CHECK(gl.s.back() == 1.0);
    for (int k = 0; k + 1 < n; ++k) CHECK(gl.s[k] < gl.s[k + 1]);
    for (int k = 0; k < n; ++k) {
      CHECK(std::abs(gl.s[k] + gl.s[n - 1 - k] - 1.0) < kSlack);
      CHECK(std::abs(gl.w[k] - gl.w[n - 1 - k]) < kSlack);
    }
  }
  // Four nodes, textbook (Abramowitz and Stegun 25.4.32): +-1/sqrt 5, weights 1/6, 5/6.
  const CrossFilmNodes four = gauss_lobatto(4);
  CHECK(std::abs(four.s[1] - 0.5 * (1.0 - 1.0 / std::sqrt(5.0))) < kSlack);
  CHECK(std::abs(four.w[0] - 1.0 / 12.0) < kSlack);
  CHECK(std::abs(four.w[1] - 5.0 / 12.0) < kSlack);
}

TEST_CASE("QuadratureIsExactToDegreeTwoNMinusThreeAndNotBeyond") {
  for (int n = 3; n <= kMost; ++n) {
    const CrossFilmNodes gl = gauss_lobatto(n);
    const auto error = [&](int degree) {
      double sum = 0.0;
      for (int k = 0; k < n; ++k) sum += gl.w[k] * power(gl.s[k], degree);
      return std::abs(sum - integral(1.0, degree));
    };
    for (int d = 0; d <= 2 * n - 3; ++d) CHECK(error(d) < kSlack);
    // The rule errs by (n-1)!^4 n(n-1).../..., about 16^-n: far above round-off up to n = 8.
    if (n <= 8) CHECK(error(2 * n - 2) > 1e-11);
  }
}

TEST_CASE("DerivativesAndRunningIntegralsOfPolynomialsAreExact") {
  for (int n = 3; n <= kMost; ++n) {
    const CrossFilmNodes gl = gauss_lobatto(n);
    for (int d = 0; d < n; ++d) {
      for (int k = 0; k < n; ++k) {
        CHECK(std::abs(apply(gl.D, gl, k, d) - slope(gl.s[k], d)) < kSlack * n);
        CHECK(std::abs(apply(gl.Q, gl, k, d) - integral(gl.s[k], d)) < kSlack);
      }
    }
  }
}

TEST_CASE("SummationByPartsHoldsExactly") {
  // W D + (W D)^T = diag(-1, 0, ..., 0, 1): the discrete product rule.
  for (int n = 3; n <= kMost; ++n) {
    const CrossFilmNodes gl = gauss_lobatto(n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double sum = gl.w[i] * gl.D[i * n + j] + gl.w[j] * gl.D[j * n + i];
        const double ends = i != j ? 0.0 : (i == 0 ? -1.0 : (i == n - 1 ? 1.0 : 0.0));
        CHECK(std::abs(sum - ends) < kSlack);
      }
    }
  }
}

TEST_CASE("TheLastRunningIntegralIsTheQuadrature") {
  for (int n = 3; n <= kMost; ++n) {
    const CrossFilmNodes gl = gauss_lobatto(n);
    for (int l = 0; l < n; ++l) {
      CHECK(std::abs(gl.Q[l]) < kSlack);
      CHECK(std::abs(gl.Q[(n - 1) * n + l] - gl.w[l]) < kSlack);
    }
  }
}

TEST_CASE("ProjectionKeepsTheIntegralAndLowerDegreesAndRemovesTheHighestMode") {
  for (int n = 3; n <= kMost; ++n) {
    const CrossFilmNodes gl = gauss_lobatto(n);
    for (int d = 0; d <= n - 2; ++d) {
      for (int k = 0; k < n; ++k) {
        CHECK(std::abs(apply(gl.S, gl, k, d) - power(gl.s[k], d)) < kSlack);
      }
    }
    double top = 0.0;  // whatever S leaves has no divided difference of order n - 1
    for (int l = 0; l < n; ++l) {
      double kept = 0.0;
      for (int k = 0; k < n; ++k) kept += gl.w[k] * gl.S[k * n + l];
      CHECK(std::abs(kept - gl.w[l]) < kSlack);
      for (int k = 0; k < n; ++k) {
        double twice = 0.0;
        for (int m = 0; m < n; ++m) twice += gl.S[k * n + m] * gl.S[m * n + l];
        CHECK(std::abs(twice - gl.S[k * n + l]) < kSlack);
      }
      top += gl.S[l * n + l];
    }
    CHECK(std::abs(top - (n - 1)) < kSlack);  // rank of a projection: one mode is gone
  }
}
