// A thin soft layer on a stiff shell is a column: it yields t (1+nu)(1-2nu)/(E(1-nu)) to any
// pressure, and must not answer pressures of cells with displacements of its own making.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/decompositions.hpp"
#include "core/make_grid.hpp"
#include "tests/analytic/elasticity.hpp"
#include "tests/solid/revolution_bodies.hpp"

using namespace shellback;
using namespace shellback::solid;
using namespace shellback::test;

namespace {

constexpr double kLayer = 10e-6;

Material soft(double nu) { return {"soft", 0.3, 1500.0, 1000.0, 2e9, nu, 60e-6}; }

/// Soft layer in `rows` even rows on 2 mm of steel in a steel housing of 95.6 mm.
RevolutionMesh lined_shell(const FilmGrid& grid, double layer = kLayer, int rows = 2) {
  const double surface = surface_row(kRadius, 48);
  RadialRows r = rows_outwards(kRadius + layer, {2e-3, 21.9e-3 - layer}, surface);
  std::vector<double> face;
  for (int k = 0; k < rows; ++k) face.push_back(kRadius + layer * k / rows);
  face.insert(face.end(), r.face.begin(), r.face.end());
  std::vector<int> of(rows, 0);
  for (const int l : r.layer) of.push_back(l + 1);
  return make_revolution_mesh(face, of, axial_elements(grid), grid.half);
}

Eigen::MatrixXd compliance(const FilmGrid& grid, const RevolutionMesh& mesh, const Material& lining,
                           int n) {
  const ElasticOptions options{n,     Support::held,         AxialEnds::free,
                               false, Elimination::cheapest, {n}};
  return shell_elasticity(mesh, grid, {lining, steel(), steel()}, options).compliance.front();
}

/// Largest yield of the layer over that of a column, over all pressures that are constant on cells.
/// The layer's part is what the shell yields beyond one whose lining is of steel.
double softest(const FilmGrid& grid, const RevolutionMesh& mesh, double nu, int n) {
  const Eigen::Map<const Eigen::VectorXd> dz(grid.dz.data(), grid.nz);
  const Eigen::VectorXd root = dz.cwiseSqrt(), over_root = root.cwiseInverse();
  const Eigen::MatrixXd part =
      root.asDiagonal() *
      (compliance(grid, mesh, soft(nu), n) - compliance(grid, mesh, steel(), n)) *
      over_root.asDiagonal();
  return symmetric_modes(0.5 * (part + part.transpose())).values.maxCoeff() /
         analytic::winkler_layer(kLayer, 2e9, nu);
}

/// Largest second difference of neighbouring cells [same unit].
double zigzag(const Eigen::VectorXd& u) {
  double worst = 0.0;
  for (Eigen::Index j = 1; j + 1 < u.size(); ++j) {
    worst = std::max(worst, std::abs(u(j + 1) - 2.0 * u(j) + u(j - 1)));
  }
  return worst;
}

}  // namespace

TEST_CASE("NoPressureFindsAThinLayerSofterThanAColumn", "[thin layer]") {
  for (int nz = 18; nz <= 28; ++nz) {
    for (const bool half : {true, false}) {
      const auto grid = make_grid(kRadius, kWidth, 48, nz, half);
      const auto mesh = lined_shell(grid);
      for (const int n : {0, 8}) {
        INFO(nz << " cells, half " << half << ", harmonic " << n);
        const double ratio = softest(grid, mesh, 0.33, n);
        CAPTURE(ratio);
        CHECK(ratio < 1.05);  // the free end's own softness
        CHECK(ratio > 0.95);
      }
    }
  }
}

TEST_CASE("UnevenCellsFindAThinLayerNoSofter", "[thin layer]") {
  const std::vector<GridEdges> edges{
      {-2.5e-3, 2.5e-3}, {-3.1e-3, 1.7e-3, 5.9e-3}, {0.4e-3, 4.3e-3}, {-8.2e-3, 7.9e-3}};
  for (const auto& e : edges) {
    for (const int nz : {19, 24}) {
      const auto grid = make_grid(kRadius, kWidth, 48, nz, false, {}, e);
      const auto mesh = lined_shell(grid);
      for (const double nu : {0.33, 0.45}) {
        const double ratio = softest(grid, mesh, nu, 8);
        CAPTURE(nz, nu, e.front(), ratio);
        CHECK(ratio < 1.05);
      }
    }
  }
}

TEST_CASE("UniformHeatingLiftsAThinLayerEvenly", "[thin layer]") {
  constexpr double kRise = 50.0;
  for (const int nz : {20, 24, 25}) {
    for (const bool half : {true, false}) {
      const auto grid = make_grid(kRadius, kWidth, 48, nz, half);
      const auto mesh = lined_shell(grid);
      const auto e =
          shell_elasticity(mesh, grid, {soft(0.33), steel(), steel()},
                           {0, Support::held, AxialEnds::free, true, Elimination::cheapest, {}});
      const Eigen::VectorXd u = kRise * uniform_expansion(e);
      INFO(nz << " cells, half " << half << ": " << (u.transpose() * 1e9));
      CHECK(zigzag(u) < 1e-9);
    }
  }
}

TEST_CASE("RowsOfAThinLayerDoNotMatter", "[thin layer]") {
  const auto grid = make_grid(kRadius, kWidth, 48, 25, true);
  for (const double nu : {0.33, 0.45, 0.49}) {
    const auto two = compliance(grid, lined_shell(grid, kLayer, 2), soft(nu), 8);
    for (const int rows : {1, 4}) {
      const auto other = compliance(grid, lined_shell(grid, kLayer, rows), soft(nu), 8);
      CAPTURE(nu, rows, (other - two).norm() / two.norm());
      CHECK((other - two).norm() < 0.02 * two.norm());
    }
  }
}

TEST_CASE("HalfAThinLayerYieldsAsTheWholeOne", "[thin layer]") {
  const auto half = make_grid(kRadius, kWidth, 48, 25, true);
  const auto full = make_grid(kRadius, kWidth, 48, 25, false);
  const auto h = compliance(half, lined_shell(half), soft(0.45), 8);
  const auto even = even_part(compliance(full, lined_shell(full), soft(0.45), 8));
  CHECK((even - h).norm() < 1e-8 * even.norm());  // round-off of the factorisations
}
