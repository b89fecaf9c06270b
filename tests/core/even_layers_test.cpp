// Even layers and the bulk node: the identities that balances and viscosity integrals rest on.
#include "core/even_layers.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/bulk_node.hpp"
#include "core/gauss_lobatto.hpp"
#include "tests/observed_order.hpp"

using namespace shellback;

namespace {

std::vector<double> times(const std::vector<double>& m, const std::vector<double>& x) {
  const std::size_t n = x.size();
  std::vector<double> y(n, 0.0);
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = 0; c < n; ++c) y[r] += m[r * n + c] * x[c];
  }
  return y;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

std::vector<double> sampled(const CrossFilmNodes& set, double (*f)(double)) {
  std::vector<double> x;
  for (const double s : set.s) x.push_back(f(s));
  return x;
}

double wave(double s) { return std::exp(s) * std::cos(3.0 * s); }

}  // namespace

TEST_CASE("EvenLayersSumByParts") {
  for (const int layers : {2, 5, 10, 40}) {
    const CrossFilmNodes set = even_layers(layers);
    const auto f = sampled(set, wave);
    CHECK(dot(set.w, times(set.D, f)) == Approx(f.back() - f.front()).margin(1e-13));
  }
}

TEST_CASE("RunningIntegralOfAProjectedFlowHasThatFlowAsDerivative") {
  for (const int layers : {2, 5, 10, 40}) {
    for (const CrossFilmNodes& set : {even_layers(layers), gauss_lobatto(layers % 20 + 3)}) {
      const auto f = sampled(set, wave);
      const auto kept = times(set.S, f);
      const auto V = times(set.Q, kept);
      const auto back = times(set.D, V);
      CHECK(dot(set.w, kept) == Approx(dot(set.w, f)).margin(1e-13));
      CHECK(V.front() == 0.0);
      CHECK(V.back() == Approx(dot(set.w, f)).margin(1e-12));
      for (std::size_t k = 0; k < f.size(); ++k) CHECK(back[k] == Approx(kept[k]).margin(1e-11));
    }
  }
}

TEST_CASE("ConductionIsSymmetricKeepsHeatAndIsExactForALinearProfile") {
  for (const CrossFilmNodes& set : {even_layers(7), gauss_lobatto(5), bulk_node()}) {
    const int n = set.n;
    const auto flux = times(set.A, set.s);  // -d2/ds2 of s, in the weak form: its two wall fluxes
    CHECK(flux.front() == Approx(-1.0));
    CHECK(flux.back() == Approx(1.0));
    for (int r = 0; r < n; ++r) {
      double sum = 0.0;
      for (int c = 0; c < n; ++c) {
        sum += set.A[r * n + c];
        CHECK(set.A[r * n + c] == Approx(set.A[c * n + r]).margin(1e-12));
      }
      CHECK(sum == Approx(0.0).margin(1e-12));
      if (r > 0 && r + 1 < n) CHECK(flux[r] == Approx(0.0).margin(1e-12));
    }
  }
}

TEST_CASE("EvenLayersIntegrateToSecondOrder") {
  const double exact =
      (std::exp(1.0) * (std::cos(3.0) + 3.0 * std::sin(3.0)) - 1.0) / 10.0;  // of wave
  const auto error = [&](int layers) {
    const CrossFilmNodes set = even_layers(layers);
    return dot(set.w, sampled(set, wave)) - exact;
  };
  CHECK(test::order_of_errors(error(20), error(40)) == Approx(2.0).margin(0.15));
}

TEST_CASE("BulkNodeGivesTheHeatOfTheParabola") {
  const CrossFilmNodes set = bulk_node();
  const double shell = 3.0, shaft = 5.0, top = 2.0;  // T = linear + 4 top s (1 - s)
  const double mean = 0.5 * (shell + shaft) + 2.0 / 3.0 * top;
  const auto flux = times(set.A, {shell, mean, shaft});
  CHECK(-flux.front() == Approx((shaft - shell) + 4.0 * top));  // dT/ds at s = 0
  CHECK(-flux.back() == Approx(4.0 * top - (shaft - shell)));   // -dT/ds at s = 1
}
