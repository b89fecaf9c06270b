#include "core/harmonics.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/field_operator.hpp"
#include "core/make_grid.hpp"

using namespace shellback;

namespace {

/// Faces on edges that do not fit an even grid: cell widths differ by tens of percent.
FilmGrid uneven_grid() { return make_grid(0.02, 0.03, 61, 7, false, {0.3, 0.37, 2.0, 2.61, 4.4}); }

Field random_field(std::size_t size, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Field f(size);
  for (double& x : f) x = uniform(engine);
  return f;
}

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index cols, unsigned seed) {
  const Field f = random_field(static_cast<std::size_t>(rows * cols), seed);
  return Eigen::Map<const Eigen::MatrixXd>(f.data(), rows, cols);
}

/// Operator whose product with diag(dz) is symmetric, different for each harmonic.
HarmonicOperator symmetric_operator(const FilmGrid& grid, int highest) {
  HarmonicOperator op;
  for (int n = 0; n <= highest; ++n) {
    Eigen::MatrixXd c = random_matrix(grid.nz, grid.nz, 100u + static_cast<unsigned>(n));
    c = (c + c.transpose()).eval();
    for (int j = 0; j < grid.nz; ++j) c.row(j) /= grid.dz[j];
    op.push_back(c);
  }
  return op;
}

double work(const FilmGrid& g, const Field& a, const Field& b) {
  double w = 0.0;
  for (int i = 0; i < g.nt; ++i) {
    for (int j = 0; j < g.nz; ++j) w += g.area(i, j) * a[g.index(i, j)] * b[g.index(i, j)];
  }
  return w;
}

}  // namespace

TEST_CASE("AnalysisIsTheFourierIntegralOfAPiecewiseConstantField", "[harmonics]") {
  const auto grid = uneven_grid();
  const Harmonics harmonics(grid, 12);
  const int hot = 17;  // one circumferential cell at 1, the rest at 0
  Field f(grid.cells(), 0.0);
  for (int j = 0; j < grid.nz; ++j) f[grid.index(hot, j)] = 1.0;
  const auto c = harmonics.analyse(f);
  const double a = grid.phi_face[hot], b = grid.phi_face[hot + 1];
  CHECK(c(0, 0) == Approx((b - a) / (2.0 * kPi)).epsilon(1e-13));
  for (const int n : {1, 5, 12}) {
    CHECK(c(3, 2 * n - 1) ==
          Approx((std::sin(n * b) - std::sin(n * a)) / (n * kPi)).epsilon(1e-12));
    CHECK(c(3, 2 * n) == Approx((std::cos(n * a) - std::cos(n * b)) / (n * kPi)).epsilon(1e-12));
  }
}

TEST_CASE("SynthesisGivesCellMeans", "[harmonics]") {
  const auto grid = uneven_grid();
  const Harmonics harmonics(grid, 9);
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(grid.nz, 19);
  c.col(9).setConstant(2.0);  // 2 cos 5 phi
  const Field f = harmonics.synthesise(c);
  for (const int i : {0, 20, 60}) {
    double mean = 0.0;  // midpoint rule, 1000 points: exact to 1e-6 of the amplitude
    for (int k = 0; k < 1000; ++k) {
      mean += 2.0e-3 * std::cos(5.0 * (grid.phi_face[i] + (k + 0.5) * 1e-3 * grid.dphi[i]));
    }
    CHECK(std::abs(f[grid.index(i, 2)] - mean) < 1e-6);
  }
}

TEST_CASE("HarmonicsReturnFromAnEvenGridWithTheSquareOfTheCellMean", "[harmonics]") {
  const auto grid = make_grid(0.02, 0.03, 64, 5, false);
  const Harmonics harmonics(grid, 16);
  const Eigen::MatrixXd c = random_matrix(grid.nz, 33, 7);
  const Eigen::MatrixXd back = harmonics.analyse(harmonics.synthesise(c));
  for (int n = 1; n <= 16; ++n) {
    const double x = n * kPi / 64.0, factor = std::pow(std::sin(x) / x, 2);
    const double error =
        (back.middleCols(2 * n - 1, 2) - factor * c.middleCols(2 * n - 1, 2)).norm();
    CHECK(error < 1e-13);  // round-off of 64-term sums
  }
}

TEST_CASE("FitInvertsSynthesisAndKeepsTheMean", "[harmonics]") {
  const auto grid = uneven_grid();
  const Harmonics harmonics(grid, 15);
  const Eigen::MatrixXd c = random_matrix(grid.nz, 31, 3);
  CHECK((harmonics.fit(harmonics.synthesise(c)) - c).norm() < 1e-12);  // condition about 2
  const Field f = random_field(grid.cells(), 4);
  CHECK((harmonics.fit(f).col(0) - harmonics.analyse(f).col(0)).norm() < 1e-13);
}

TEST_CASE("WorkOfOnePressureOnTheDisplacementOfAnotherIsMutual", "[harmonics]") {
  const auto grid = uneven_grid();
  const Harmonics harmonics(grid, 15);
  const auto op = symmetric_operator(grid, 15);
  const Field p = random_field(grid.cells(), 1), q = random_field(grid.cells(), 2);
  const FieldOperator all(harmonics, op);
  for (const bool above : {false, true}) {  // the highest harmonic
    const auto answer = [&](const Field& f) { return above ? all(f) : apply(harmonics, op, f); };
    const double pq = work(grid, q, answer(p));
    const double qp = work(grid, p, answer(q));
    const double size = work(grid, p, answer(p));
    CHECK(std::abs(pq - qp) < 1e-12 * (std::abs(size) + std::abs(pq)));
  }
}

TEST_CASE("TurningTheLoadByWholeCellsTurnsTheResponse", "[harmonics]") {
  const auto grid = make_grid(0.02, 0.03, 48, 5, false);
  const Harmonics harmonics(grid, 12);
  const auto op = symmetric_operator(grid, 12);
  const Field p = random_field(grid.cells(), 5);
  const int shift = 11 * grid.nz;
  Field turned(p.size());
  for (std::size_t k = 0; k < p.size(); ++k) turned[(k + shift) % p.size()] = p[k];
  const Field u = apply(harmonics, op, p), v = apply(harmonics, op, turned);
  for (std::size_t k = 0; k < p.size(); ++k) {
    // round-off against amplitudes of a few 100 (the operator is divided by dz)
    CHECK(std::abs(v[(k + shift) % p.size()] - u[k]) < 1e-10);
  }
}

TEST_CASE("LayerThatAnswersAllHarmonicsAlikeIsAColumn", "[harmonics]") {
  const auto grid = uneven_grid();
  const Harmonics harmonics(grid, 10);
  const HarmonicOperator column(11, 3.0 * Eigen::MatrixXd::Identity(grid.nz, grid.nz));
  const Field p = random_field(grid.cells(), 6), u = FieldOperator(harmonics, column)(p);
  for (std::size_t k = 0; k < p.size(); ++k) CHECK(std::abs(u[k] - 3.0 * p[k]) < 1e-14);
}

TEST_CASE("AnOperatorMadeReadyIsThatOfTheSeries", "[harmonics]") {
  // (1) of field_operator.hpp, for lines of every length that registers are filled with otherwise.
  for (const int nz : {1, 5, 8, 13, 17, 25, 34, 50}) {
    const auto grid = make_grid(0.02, 0.03, 40, nz, false);
    const Harmonics harmonics(grid, 11);
    const auto op = symmetric_operator(grid, 11);
    const Field f = random_field(grid.cells(), nz);
    HarmonicOperator rest = op;
    for (auto& m : rest) m -= op.back();
    const Eigen::Map<const Eigen::MatrixXd> columns(f.data(), nz, grid.nt);
    const Eigen::MatrixXd tail = op.back() * columns;
    const Field within = apply(harmonics, rest, f), u = FieldOperator(harmonics, op)(f);
    for (std::size_t k = 0; k < f.size(); ++k) {
      // round-off of sums of 40 terms of the operator's size
      CHECK(std::abs(u[k] - within[k] - tail.data()[k]) < 1e-13 * op.front().norm());
    }
  }
}

TEST_CASE("ComposedOperatorsActOneAfterTheOther", "[harmonics]") {
  const auto grid = uneven_grid();
  const auto a = symmetric_operator(grid, 6), b = symmetric_operator(grid, 6);
  const Eigen::MatrixXd c = random_matrix(grid.nz, 13, 8);
  const Eigen::MatrixXd once = multiply(compose(a, b), c), twice = multiply(a, multiply(b, c));
  CHECK((once - twice).norm() < 1e-13 * twice.norm());
}

TEST_CASE("MoreHarmonicsThanCellsCanTellApartAreRefused", "[harmonics]") {
  const auto grid = make_grid(0.02, 0.03, 20, 5, false);
  CHECK_NOTHROW(Harmonics(grid, 9));
  CHECK_THROWS_AS(Harmonics(grid, 10), InputError);
}
