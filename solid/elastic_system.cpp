#include "solid/elastic_system.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/contract.hpp"

namespace shellback::solid {
namespace {

/// Local nodes that belong to the group after that of their element: those on the outer corner
/// line, and those on the corner line at larger z.
constexpr std::array<int, 8> kOuterNode{0, 1, 1, 0, 0, 1, 0, 0};
constexpr std::array<int, 8> kFarNode{0, 0, 1, 1, 0, 0, 1, 0};

void require_elastic(const Material& m) {
  if (m.youngs_modulus > 0.0 && m.poisson_ratio > -1.0 && m.poisson_ratio < 0.5) return;
  throw InputError(fmt::format(
      "material {}: Young's modulus {} Pa, Poisson's ratio {} (must be positive; in (-1, 0.5)); "
      "an incompressible layer is described by a ratio of 0.499",
      m.name, m.youngs_modulus, m.poisson_ratio));
}

/// Multiplications of a factorisation, about: groups times the cube of a block.
double factorisation_cost(int groups, int elements_per_line) {
  return groups * std::pow(3.0 * (3 * elements_per_line + 2), 3);
}

/// Nodes of one group: its corner line and the mid-side nodes up to the next.
struct Group {
  std::vector<int> line;
  std::vector<int> mid;
};

Group group_outwards(const RevolutionMesh& mesh, int k) {
  Group g;
  for (int m = 0; m < mesh.line_nodes(); ++m) g.line.push_back(mesh.group_begin(k) + m);
  if (k == mesh.rows) return g;
  for (int m = 0; m <= mesh.cols; ++m) g.mid.push_back(mesh.mid_node(k, m));
  return g;
}

Group group_along(const RevolutionMesh& mesh, int c) {
  Group g;
  for (int k = 0; k <= mesh.rows; ++k) {
    g.line.push_back(mesh.group_begin(k) + 2 * c);
    if (k < mesh.rows) g.line.push_back(mesh.mid_node(k, c));
    if (c < mesh.cols) g.mid.push_back(mesh.group_begin(k) + 2 * c + 1);
  }
  return g;
}

/// Components held at zero, by symmetry, regularity on the axis, plane strain, as the pins that
/// take out rigid motion (no reaction arises there: the loads are in balance), or because they are
/// left out.
std::vector<bool> held_components(const ElasticBody& body, int n, int first, bool hold_outer) {
  const RevolutionMesh& mesh = body.mesh;
  std::vector<bool> held(3 * mesh.nodes(), false);
  const double z_first = mesh.z_face.front(), z_last = mesh.z_face.back();
  const int outer = hold_outer ? mesh.group_begin(mesh.rows) : mesh.nodes();
  for (int a = 0; a < mesh.nodes(); ++a) {
    const bool axis = mesh.r[a] == 0.0;
    if (n == 0) held[3 * a + 1] = true;  // torsion does not touch the gap
    if (axis && n != 1) held[3 * a] = held[3 * a + 1] = true;
    if (axis && n != 0) held[3 * a + 2] = true;
    if (mesh.half && mesh.z[a] == 0.0) held[3 * a + 2] = true;
    if (body.plane_strain && (mesh.z[a] == z_last || mesh.z[a] == z_first)) held[3 * a + 2] = true;
    if (a < mesh.group_begin(first) || a >= outer) {
      held[3 * a] = held[3 * a + 1] = held[3 * a + 2] = true;
    }
  }
  const int pin = mesh.group_begin(mesh.rows) + (mesh.half ? 0 : mesh.cols);
  if (n == 1) held[3 * pin] = true;
  if (n <= 1 && body.can_tilt()) held[3 * pin + 2] = true;
  return held;
}

void scatter(const Eigen::Matrix<double, 24, 24>& ke, const LocalFreedoms& local,
             BlockTridiagonal& a) {
  for (int j = 0; j < 24; ++j) {
    const LocalFreedom& q = local[j];
    if (q.position < 0) continue;
    for (int i = 0; i < 24; ++i) {
      const LocalFreedom& p = local[i];
      if (p.position < 0 || p.group < q.group) continue;
      const double v = p.sign * q.sign * ke(i, j);
      if (p.group > q.group) {
        a.coupling[q.group](p.position, q.position) += v;
      } else if (p.position >= q.position) {
        a.diagonal[q.group](p.position, q.position) += v;
      }
    }
  }
}

}  // namespace

ElasticBody make_elastic_body(const RevolutionMesh& mesh, const std::vector<Material>& layers,
                              bool plane_strain, int loaded_line, Elimination order,
                              int factorisations) {
  for (const Material& m : layers) require_elastic(m);
  ElasticBody body{mesh, plane_strain, loaded_line, order, {}, {}};
  if (order == Elimination::cheapest) {
    const bool along = factorisations * factorisation_cost(mesh.cols, mesh.rows) <
                       factorisation_cost(mesh.rows, mesh.cols);
    body.order = along ? Elimination::along_axis : Elimination::outwards;
  }
  for (int row = 0; row < mesh.rows; ++row) {
    EXPECTS(mesh.layer[row] >= 0 && mesh.layer[row] < static_cast<int>(layers.size()));
    double last_length = 0.0;
    for (int col = 0; col < mesh.cols; ++col) {  // the matrices do not depend on z, only on dz
      const double length = mesh.z_face[col + 1] - mesh.z_face[col];
      if (col == 0 || std::abs(length - last_length) > 1e-12 * length) {
        body.pieces.push_back(elastic_element(mesh, row, col, layers[mesh.layer[row]]));
        last_length = length;
      }
      body.piece.push_back(static_cast<int>(body.pieces.size()) - 1);
    }
  }
  return body;
}

Freedoms make_freedoms(const ElasticBody& body, int n, int first, bool hold_outer) {
  const RevolutionMesh& mesh = body.mesh;
  const bool along = body.order == Elimination::along_axis;
  const std::vector<bool> held = held_components(body, n, first, hold_outer);
  Freedoms f{std::vector<int>(mesh.nodes(), 0),
             std::vector<int>(held.size(), -1),
             std::vector<double>(held.size(), 1.0),
             {},
             {}};
  const int last = along ? mesh.cols : mesh.rows;
  for (int k = 0; k <= last; ++k) {
    int next = 0;
    const auto take = [&](int a) {
      f.group[a] = k;
      for (int c = 0; c < 3; ++c) {
        if (held[3 * a + c]) continue;
        if (n == 1 && c == 1 && mesh.r[a] == 0.0) {  // translation of the axis
          f.position[3 * a + 1] = f.position[3 * a];
          f.sign[3 * a + 1] = -1.0;
        } else {
          f.position[3 * a + c] = next++;
        }
      }
    };
    const Group group = along ? group_along(mesh, k) : group_outwards(mesh, k);
    for (const int a : group.line) take(a);
    f.head.push_back(next);
    for (const int a : group.mid) take(a);
    f.size.push_back(next);
  }
  return f;
}

LocalFreedoms local_freedoms(const ElasticBody& body, const Freedoms& f, int row, int col) {
  const bool along = body.order == Elimination::along_axis;
  LocalFreedoms local;
  const auto& nodes = body.mesh.at(row, col);
  for (int i = 0; i < 24; ++i) {
    const int g = 3 * nodes[i / 3] + i % 3;
    const int group = along ? col + kFarNode[i / 3] : row + kOuterNode[i / 3];
    local[i] = {group, f.position[g], f.sign[g]};
  }
  return local;
}

BlockTridiagonal stiffness(const ElasticBody& body, const Freedoms& f, int n, int first) {
  const RevolutionMesh& mesh = body.mesh;
  BlockTridiagonal a;
  for (std::size_t k = 0; k < f.size.size(); ++k) {
    a.diagonal.push_back(Eigen::MatrixXd::Zero(f.size[k], f.size[k]));
    if (k + 1 == f.size.size()) break;
    a.coupling.push_back(Eigen::MatrixXd::Zero(f.size[k] > 0 ? f.head[k + 1] : 0, f.size[k]));
  }
  Eigen::Matrix<double, 24, 24> ke;
  int current = -1;
  for (int row = first; row < mesh.rows; ++row) {
    for (int col = 0; col < mesh.cols; ++col) {
      const int piece = body.piece[row * mesh.cols + col];
      if (piece != current) {
        const ElasticElement& e = body.pieces[piece];
        ke = e.k0 + n * e.k1 + (n * n) * e.k2;
        current = piece;
      }
      scatter(ke, local_freedoms(body, f, row, col), a);
    }
  }
  return a;
}

}  // namespace shellback::solid
