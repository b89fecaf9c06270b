#include "core/revolution_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/make_grid.hpp"

using namespace shellback;

namespace {
RevolutionMesh sample_mesh(bool half) {
  const auto grid = make_grid(0.02, 0.03, 20, 9, half);
  const auto rows = rows_outwards(0.02, {20e-6, 1.5e-3, 10e-3}, 1e-3);
  return make_revolution_mesh(rows.face, rows.layer, axial_elements(grid), half);
}
}  // namespace

TEST_CASE("EveryLayerHasTwoRowsAndItsThickness", "[mesh]") {
  const auto rows = rows_outwards(0.02, {20e-6, 1.5e-3, 10e-3}, 1e-3);
  for (int l = 0; l < 3; ++l) CHECK(std::count(rows.layer.begin(), rows.layer.end(), l) >= 2);
  CHECK(rows.face[2] == Approx(0.02002).epsilon(1e-14));
  CHECK(rows.face.back() == Approx(0.03152).epsilon(1e-14));
  for (std::size_t k = 2; k < rows.layer.size(); ++k) {
    if (rows.layer[k] != rows.layer[k - 1]) continue;
    const double ratio = (rows.face[k + 1] - rows.face[k]) / (rows.face[k] - rows.face[k - 1]);
    CHECK(ratio <= 2.0 + 1e-9);
  }
}

TEST_CASE("ALayerHasTheRowsThatAreWanted", "[mesh]") {
  const RadialRows rows = rows_outwards(0.02, {1e-3, 2e-3}, 5e-3, {8, 0});
  CHECK(std::count(rows.layer.begin(), rows.layer.end(), 0) == 8);
  CHECK(std::count(rows.layer.begin(), rows.layer.end(), 1) == 2);
  CHECK(rows.face[8] == 0.021);
}

TEST_CASE("ElementsFillTheSection", "[mesh]") {
  const auto mesh = sample_mesh(false);
  double volume = 0.0;
  for (int row = 0; row < mesh.rows; ++row) {
    for (int col = 0; col < mesh.cols; ++col) {
      for (const auto& s : shape_points(mesh, row, col, {2, 2})) volume += s.weight * s.r;
    }
  }
  CHECK(volume == Approx(0.5 * 0.03 * (0.03152 * 0.03152 - 0.02 * 0.02)).epsilon(1e-13));
}

TEST_CASE("ShapeFunctionsReproduceQuadraticFields", "[mesh]") {
  const auto mesh = sample_mesh(true);
  const auto f = [](double r, double z) {
    return 1.0 + 2.0 * r - z + 30.0 * r * z + 9.0 * r * r - z * z;
  };
  for (const auto& s : shape_points(mesh, 2, 3, {3, 3})) {
    double value = 0.0, slope_r = 0.0, slope_z = 0.0;
    for (int a = 0; a < 8; ++a) {
      const int node = mesh.at(2, 3)[a];
      const double fa = f(mesh.r[node], mesh.z[node]);
      value += s.n(a) * fa;
      slope_r += s.n_r(a) * fa;
      slope_z += s.n_z(a) * fa;
    }
    CHECK(value == Approx(f(s.r, s.z)).epsilon(1e-13));
    CHECK(slope_r == Approx(2.0 + 30.0 * s.z + 18.0 * s.r).epsilon(1e-9));  // differences / dr
    CHECK(slope_z == Approx(-1.0 + 30.0 * s.r - 2.0 * s.z).epsilon(1e-9));
  }
}

TEST_CASE("CellIntegralsOfUnityAreTheCellWidths", "[mesh]") {
  for (const bool half : {false, true}) {
    const auto grid = make_grid(0.02, 0.03, 20, 9, half);
    const auto mesh =
        make_revolution_mesh({0.0, 0.01, 0.02}, {0, 0}, axial_elements(grid, 0.02), half);
    const auto p = cell_integrals(mesh, grid);
    for (int j = 0; j < grid.nz; ++j) {
      CHECK(p.col(j).sum() == Approx(grid.dz[j]).epsilon(1e-13));
      double first_moment = 0.0;
      for (int m = 0; m < mesh.line_nodes(); ++m) first_moment += p(m, j) * mesh.z[m];
      const double middle = 0.5 * (grid.z_face[j] + grid.z_face[j + 1]);
      CHECK(std::abs(first_moment - grid.dz[j] * middle) < 1e-15);
    }
  }
}
