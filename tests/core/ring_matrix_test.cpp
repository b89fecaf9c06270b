#include "core/ring_matrix.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace shellback;

namespace {

using Vector = std::vector<double>;

/// Dense copy, built from the definition of the stencil and not from RingMatrix::multiply. With
/// three lines or more the west and east neighbours are different lines.
Eigen::MatrixXd dense(const RingMatrix& a) {
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(a.nt * a.nz, a.nt * a.nz);
  for (int i = 0; i < a.nt; ++i) {
    for (int j = 0; j < a.nz; ++j) {
      const int k = i * a.nz + j;
      m(k, k) += a.c[k];
      m(k, (i + a.nt - 1) % a.nt * a.nz + j) += a.w[k];
      m(k, (i + 1) % a.nt * a.nz + j) += a.e[k];
      if (j > 0) m(k, k - 1) += a.s[k];
      if (j + 1 < a.nz) m(k, k + 1) += a.n[k];
    }
  }
  return m;
}

Vector random_vector(std::size_t size, unsigned seed, double low = -1.0, double high = 1.0) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(low, high);
  Vector v(size);
  for (double& x : v) x = uniform(engine);
  return v;
}

/// Random couplings of either sign under a dominant diagonal.
RingMatrix dominant(int nt, int nz, unsigned seed) {
  RingMatrix a;
  a.resize(nt, nz);
  for (auto* x : {&a.w, &a.e, &a.s, &a.n}) *x = random_vector(x->size(), seed++);
  for (std::size_t k = 0; k < a.c.size(); ++k) {
    const double sum =
        std::abs(a.w[k]) + std::abs(a.e[k]) + std::abs(a.s[k]) + std::abs(a.n[k]) + 0.1;
    a.c[k] = k % 3 == 0 ? -sum : sum;
  }
  return a;
}

/// Cavitated lines: pure transport from the west, no diffusion, column sums as in a film matrix.
RingMatrix upwind(int nt, int nz, unsigned seed, const std::vector<int>& cavitated) {
  RingMatrix a = dominant(nt, nz, seed);
  for (double& c : a.c) c = std::abs(c);
  for (const int i : cavitated) {
    for (int j = 0; j < nz; ++j) {
      const int k = i * nz + j;
      a.e[k] = a.s[k] = a.n[k] = 0.0;
      a.c[k] = 1.5;
      a.w[k] = -1.2;
    }
  }
  return a;
}

/// Nothing passes between the line before `at` and the line `at`.
void cut_both_ways(RingMatrix& a, int at) {
  const int before = (at + a.nt - 1) % a.nt;
  for (int j = 0; j < a.nz; ++j) a.w[at * a.nz + j] = a.e[before * a.nz + j] = 0.0;
}

/// Residual and difference from a dense solution. Both are round-off: 1e-16 times the condition
/// number (below 100 for these matrices) times the growth of rounding over about 1000 sums.
void check_solve(const RingMatrix& a, int count, unsigned seed) {
  const std::size_t n = a.c.size();
  const Vector b = random_vector(n * count, seed);
  Vector x = b;
  RingFactor factor;
  REQUIRE(factor.factorize(a));
  factor.solve(x.data(), count);
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(dense(a));
  for (int r = 0; r < count; ++r) {
    const Vector own(x.begin() + static_cast<long>(r * n),
                     x.begin() + static_cast<long>((r + 1) * n));
    const Eigen::Map<const Eigen::VectorXd> rhs(&b[r * n], static_cast<long>(n));
    const Eigen::VectorXd expected = lu.solve(rhs);
    Vector product;
    a.multiply(own, product);
    double difference = 0.0, residual = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      difference = std::max(difference, std::abs(own[k] - expected(static_cast<long>(k))));
      residual = std::max(residual, std::abs(product[k] - b[r * n + k]));
    }
    CHECK(difference < 1e-11 * expected.cwiseAbs().maxCoeff());
    CHECK(residual < 1e-11 * expected.cwiseAbs().maxCoeff());
  }
}

}  // namespace

TEST_CASE("TheProductIsThatOfTheStencil") {
  const RingMatrix a = dominant(6, 5, 3);
  const Vector x = random_vector(30, 9);
  Vector y;
  a.multiply(x, y);
  const Eigen::VectorXd expected = dense(a) * Eigen::Map<const Eigen::VectorXd>(x.data(), 30);
  for (int k = 0; k < 30; ++k) CHECK(std::abs(y[k] - expected(k)) < 1e-14);  // five terms below 4
}

TEST_CASE("AClosedRingIsSolvedForEveryNumberOfAxialCells") {
  for (int nz = 1; nz <= 40; ++nz) check_solve(dominant(5, nz, 10u + nz), 2, 77u + nz);
}

TEST_CASE("AClosedRingIsSolvedForEveryNumberOfLines") {
  for (int nt = 3; nt <= 24; ++nt) check_solve(dominant(nt, 4, 5u + nt), 1, 7u + nt);
}

TEST_CASE("AnUpwindRingIsSolvedWhereverTheFilmIsCavitated") {
  for (int first = 0; first < 9; ++first) {
    check_solve(upwind(9, 6, 31, {first}), 3, 8);
    check_solve(upwind(9, 6, 32, {first, (first + 1) % 9, (first + 2) % 9}), 3, 9);
    check_solve(upwind(9, 6, 33, {first, (first + 4) % 9}), 3, 10);
  }
}

TEST_CASE("AnUpwindRingIsSolvedForEveryNumberOfAxialCells") {
  for (int nz = 1; nz <= 40; ++nz) check_solve(upwind(6, nz, 50u + nz, {2, 3}), 1, 3u + nz);
}

TEST_CASE("AGrooveOverAPartOfACavitatedLineIsSolvedWhereverItLies") {
  for (int at = 0; at < 9; ++at) {
    for (int open = 0; open <= 6; ++open) {  // cells of the line that take over from the one before
      RingMatrix a = upwind(9, 6, 60u + at, {at, (at + 1) % 9, (at + 8) % 9});
      for (int j = open; j < 6; ++j) a.w[at * 6 + j] = 0.0;
      check_solve(a, 2, 11u + open);
    }
  }
}

TEST_CASE("ACavitatedLineWithoutTransportIsRefused") {
  RingMatrix a = upwind(7, 5, 81, {2, 3});
  a.c[3 * 5 + 2] = 0.0;
  RingFactor factor;
  CHECK_FALSE(factor.factorize(a));
}

TEST_CASE("ARingCutByAGrooveIsSolvedWhereverTheGrooveLies") {
  for (int at = 0; at < 7; ++at) {
    for (const int nz : {1, 7, 8, 9, 17}) {
      RingMatrix a = dominant(7, nz, 90u + at);
      cut_both_ways(a, at);
      check_solve(a, 2, 4u + at);
      cut_both_ways(a, (at + 3) % 7);
      check_solve(a, 2, 5u + at);
    }
  }
}

TEST_CASE("AOneSidedCutIsSolvedInEitherDirection") {
  for (const bool forward : {true, false}) {
    for (int at = 0; at < 7; ++at) {
      RingMatrix a = dominant(7, 5, 120u + at);
      for (int j = 0; j < 5; ++j) (forward ? a.e : a.w)[at * 5 + j] = 0.0;
      check_solve(a, 2, 6u + at);
    }
  }
}

TEST_CASE("APartlyCutLineIsNoCut") {
  RingMatrix a = dominant(7, 5, 200);
  for (int j = 0; j < 4; ++j) a.e[2 * 5 + j] = a.w[3 * 5 + j] = 0.0;  // one coupling is left
  check_solve(a, 2, 6);
}

TEST_CASE("RowsInNeedOfPivotingAreSolved") {
  // Zero diagonals inside a line: the block is regular, its first pivot is not.
  RingMatrix a = dominant(5, 6, 210);
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 6; ++j) {
      const int k = i * 6 + j;
      a.w[k] *= 0.01;
      a.e[k] *= 0.01;
      a.c[k] = 0.0;
      a.s[k] = j % 2 == 1 ? 2.0 : 0.3;
      a.n[k] = j % 2 == 0 ? 2.0 : 0.3;
    }
  }
  check_solve(a, 2, 6);
}

TEST_CASE("FactorsMayBeReusedForAnotherMatrix") {
  RingFactor factor;
  for (const int nz : {12, 3, 20}) {
    const RingMatrix a = upwind(8, nz, 300, {nz % 8});
    Vector x = random_vector(a.c.size(), 4), b = x, product;
    REQUIRE(factor.factorize(a));
    factor.solve(x.data());
    a.multiply(x, product);
    // Round-off as in check_solve.
    for (std::size_t k = 0; k < b.size(); ++k) CHECK(std::abs(product[k] - b[k]) < 1e-11);
  }
}

TEST_CASE("ASingularBlockIsRefused") {
  for (int at = 0; at < 6; ++at) {
    RingMatrix a = dominant(6, 4, 400);
    for (int j = 0; j < 4; ++j) {
      const int k = at * 4 + j;
      a.c[k] = a.w[k] = a.e[k] = a.s[k] = a.n[k] = 0.0;
    }
    RingFactor factor;
    CHECK_FALSE(factor.factorize(a));
  }
}

TEST_CASE("AnInfiniteCoefficientIsRefused") {
  RingMatrix a = dominant(6, 4, 500);
  a.c[9] = std::nan("");
  RingFactor factor;
  CHECK_FALSE(factor.factorize(a));
}
