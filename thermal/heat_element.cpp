#include "thermal/heat_element.hpp"

#include <cmath>

namespace shellback::thermal {
namespace {

constexpr int kFullOrder = 3;
/// Local nodes of the element's edges at smallest z, largest z and outer radius.
constexpr std::array<int, 3> kLowEnd{0, 4, 1}, kHighEnd{3, 6, 2}, kOuterEdge{1, 5, 2};

/// int h N_a N_b r ds over a straight edge from (r0) to (r1) of given length.
void add_edge(Matrix8& m, const std::array<int, 3>& nodes, double h, double r0, double r1,
              double length) {
  const double x[3] = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)};
  const double w[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  for (int g = 0; g < 3; ++g) {
    const double t = x[g];
    const double n[3] = {0.5 * t * (t - 1.0), 1.0 - t * t, 0.5 * t * (t + 1.0)};
    const double f = h * w[g] * 0.5 * length * (0.5 * (r0 + r1) + 0.5 * (r1 - r0) * t);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) m(nodes[a], nodes[b]) += f * n[a] * n[b];
    }
  }
}

}  // namespace

HeatElement heat_element(const RevolutionMesh& mesh, int row, int col, double k,
                         const ConductionBoundary& boundary) {
  HeatElement e;
  for (const ShapePoint& s : shape_points(mesh, row, col, {kFullOrder, kFullOrder})) {
    const double f = k * s.weight;
    e.k0 += f * s.r * (s.n_r * s.n_r.transpose() + s.n_z * s.n_z.transpose());
    e.k2 += f / s.r * (s.n * s.n.transpose());
  }
  const double r0 = mesh.r_face[row], r1 = mesh.r_face[row + 1];
  const double h = boundary.end_heat_transfer;
  if (col == 0 && !mesh.half) add_edge(e.ends, kLowEnd, h, r0, r1, r1 - r0);
  if (col == mesh.cols - 1) add_edge(e.ends, kHighEnd, h, r0, r1, r1 - r0);
  const double z = 0.5 * (mesh.z_face[col] + mesh.z_face[col + 1]);
  const bool bare = boundary.kind == BackKind::convective && std::abs(z) > boundary.covered;
  if (row == mesh.rows - 1 && bare) {
    add_edge(e.outer, kOuterEdge, boundary.back_heat_transfer, r1, r1,
             mesh.z_face[col + 1] - mesh.z_face[col]);
  }
  return e;
}

Matrix8 heat_capacity_matrix(const RevolutionMesh& mesh, int row, int col, double rho_c) {
  Matrix8 m = Matrix8::Zero();
  for (const ShapePoint& s : shape_points(mesh, row, col, {kFullOrder, kFullOrder})) {
    m += rho_c * s.weight * s.r * (s.n * s.n.transpose());
  }
  return m;
}

}  // namespace shellback::thermal
