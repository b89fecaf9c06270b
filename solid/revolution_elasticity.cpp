#include "solid/revolution_elasticity.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/block_cholesky.hpp"
#include "core/contract.hpp"
#include "solid/elastic_element.hpp"

namespace shellback::solid {
namespace {

constexpr double kNegligibleEnergy = 1e-10;  ///< of the field below a left-out row [-]
/// Local nodes that belong to the group of the row above (outer corner line).
constexpr std::array<int, 8> kUpperGroup{0, 1, 1, 0, 0, 1, 0, 0};

/// The body: its mesh and one set of element matrices for each distinct element.
struct Body {
  const RevolutionMesh& mesh;
  AxialEnds ends = AxialEnds::free;
  int loaded_line = 0;  ///< corner line that carries the film
  std::vector<ElasticElement> pieces;
  std::vector<int> piece;  ///< of each element, index row * cols + col

  [[nodiscard]] bool solid_core() const { return mesh.r_face.front() == 0.0; }
  /// Tilt is a free rigid motion of harmonic 1.
  [[nodiscard]] bool can_tilt() const { return !mesh.half && ends == AxialEnds::free; }
};

void require_elastic(const Material& m) {
  if (m.youngs_modulus > 0.0 && m.poisson_ratio > -1.0 && m.poisson_ratio < 0.5) return;
  throw InputError(fmt::format(
      "material {}: Young's modulus {} Pa, Poisson's ratio {} (must be positive; in (-1, 0.5)); "
      "an incompressible layer is described by a ratio of 0.499",
      m.name, m.youngs_modulus, m.poisson_ratio));
}

Body make_body(const RevolutionMesh& mesh, const std::vector<Material>& layers, AxialEnds ends,
               int loaded_line) {
  for (const Material& m : layers) require_elastic(m);
  Body body{mesh, ends, loaded_line, {}, {}};
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

/// Where each nodal component stands in the blocks.
struct Freedoms {
  std::vector<int> position;  ///< 3 nodes entries: row in the group's block, -1 if held at zero
  std::vector<double> sign;   ///< component = sign * unknown
  std::vector<int> size;      ///< rows of each group's block
  std::vector<int> head;      ///< rows that belong to its corner line
};

/// Components held at zero, by symmetry, regularity on the axis, plane strain, or as the pins
/// that take out rigid motion (no reaction arises there: the loads are in balance).
std::vector<bool> held_components(const Body& body, int n) {
  const RevolutionMesh& mesh = body.mesh;
  std::vector<bool> held(3 * mesh.nodes(), false);
  const double z_first = mesh.z_face.front(), z_last = mesh.z_face.back();
  const bool plane = body.ends == AxialEnds::plane_strain;
  for (int a = 0; a < mesh.nodes(); ++a) {
    const bool axis = mesh.r[a] == 0.0;
    if (n == 0) held[3 * a + 1] = true;  // torsion does not touch the gap
    if (axis && n != 1) held[3 * a] = held[3 * a + 1] = true;
    if (axis && n != 0) held[3 * a + 2] = true;
    if (mesh.half && mesh.z[a] == 0.0) held[3 * a + 2] = true;
    if (plane && (mesh.z[a] == z_last || mesh.z[a] == z_first)) held[3 * a + 2] = true;
  }
  const int pin = mesh.group_begin(mesh.rows) + (mesh.half ? 0 : mesh.cols);
  if (n == 1) held[3 * pin] = true;
  if (n <= 1 && body.can_tilt()) held[3 * pin + 2] = true;
  return held;
}

Freedoms make_freedoms(const Body& body, int n) {
  const RevolutionMesh& mesh = body.mesh;
  const std::vector<bool> held = held_components(body, n);
  Freedoms f{std::vector<int>(held.size(), -1), std::vector<double>(held.size(), 1.0), {}, {}};
  for (int k = 0; k <= mesh.rows; ++k) {
    int next = 0;
    const int begin = mesh.group_begin(k), head_end = begin + mesh.line_nodes();
    f.head.push_back(0);
    for (int a = begin; a < mesh.group_begin(k + 1); ++a) {
      if (a == head_end) f.head.back() = next;
      for (int c = 0; c < 3; ++c) {
        if (held[3 * a + c]) continue;
        if (n == 1 && c == 1 && mesh.r[a] == 0.0) {  // translation of the axis
          f.position[3 * a + 1] = f.position[3 * a];
          f.sign[3 * a + 1] = -1.0;
        } else {
          f.position[3 * a + c] = next++;
        }
      }
    }
    if (k == mesh.rows) f.head.back() = next;
    f.size.push_back(next);
  }
  return f;
}

struct LocalFreedom {
  int group;
  int position;
  double sign;
};
using LocalFreedoms = std::array<LocalFreedom, 24>;

LocalFreedoms local_freedoms(const Body& body, const Freedoms& f, int row, int col) {
  LocalFreedoms local;
  const auto& nodes = body.mesh.at(row, col);
  for (int i = 0; i < 24; ++i) {
    const int g = 3 * nodes[i / 3] + i % 3;
    local[i] = {row + kUpperGroup[i / 3], f.position[g], f.sign[g]};
  }
  return local;
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

/// Stiffness of harmonic n from row `first` outwards.
BlockTridiagonal stiffness(const Body& body, const Freedoms& f, int n, int first) {
  const RevolutionMesh& mesh = body.mesh;
  BlockTridiagonal a;
  for (int k = 0; k <= mesh.rows; ++k) {
    const int size = k >= first ? f.size[k] : 0;
    a.diagonal.push_back(Eigen::MatrixXd::Zero(size, size));
    if (k < mesh.rows)
      a.coupling.push_back(Eigen::MatrixXd::Zero(size > 0 ? f.head[k + 1] : 0, size));
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

BlockColumns zero_columns(const BlockTridiagonal& a, Eigen::Index columns) {
  BlockColumns y;
  for (const auto& d : a.diagonal) y.push_back(Eigen::MatrixXd::Zero(d.rows(), columns));
  return y;
}

/// Unit pressure on each axial cell, without the factor R.
void add_pressure(const Body& body, const Freedoms& f, const Eigen::MatrixXd& p,
                  BlockColumns& load) {
  const int line = body.mesh.group_begin(body.loaded_line);
  for (int m = 0; m < body.mesh.line_nodes(); ++m) {
    const int i = f.position[3 * (line + m)];
    if (i >= 0) load[body.loaded_line].row(i) += p.row(m);
  }
}

/// Rigid motions R of harmonic 1 and the body force along them.
struct RigidMotions {
  BlockColumns load;              ///< b, with b^T u the volume mean of u along R
  Eigen::MatrixXd projector;      ///< (b^T R)^-1
  Eigen::MatrixXd pressure_work;  ///< R^T P: includes the pinned freedoms
};

RigidMotions rigid_motions(const Body& body, const Freedoms& f, const BlockTridiagonal& a,
                           const Eigen::MatrixXd& p) {
  const RevolutionMesh& mesh = body.mesh;
  const int modes = body.can_tilt() ? 2 : 1;
  RigidMotions rigid{zero_columns(a, modes), Eigen::MatrixXd::Zero(modes, modes),
                     Eigen::MatrixXd::Zero(modes, p.cols())};
  const auto motion = [&](int freedom, int mode) {
    const int node = freedom / 3, c = freedom % 3;
    const double lateral = mode == 0 ? 1.0 : mesh.z[node];
    return c == 0 ? lateral : c == 1 ? -lateral : mode == 0 ? 0.0 : -mesh.r[node];
  };
  for (int row = 0; row < mesh.rows; ++row) {
    for (int col = 0; col < mesh.cols; ++col) {
      const auto be = rigid_load(mesh, row, col);
      const auto local = local_freedoms(body, f, row, col);
      for (int i = 0; i < 24; ++i) {
        const int freedom = 3 * mesh.at(row, col)[i / 3] + i % 3;
        for (int s = 0; s < modes; ++s) {
          for (int t = 0; t < modes; ++t) rigid.projector(s, t) += be(i, s) * motion(freedom, t);
          if (local[i].position < 0) continue;
          rigid.load[local[i].group](local[i].position, s) += local[i].sign * be(i, s);
        }
      }
    }
  }
  const int line = mesh.group_begin(body.loaded_line);
  for (int m = 0; m < mesh.line_nodes(); ++m) {
    for (int s = 0; s < modes; ++s) {
      rigid.pressure_work.row(s) += motion(3 * (line + m), s) * p.row(m);
    }
  }
  rigid.projector = rigid.projector.inverse().eval();
  return rigid;
}

/// Body force that balances the pressures: load - b (b^T R)^-T R^T load.
void balance(const RigidMotions& rigid, BlockColumns& load) {
  const Eigen::MatrixXd share = rigid.projector.transpose() * rigid.pressure_work;
  for (std::size_t k = 0; k < load.size(); ++k) load[k].noalias() -= rigid.load[k] * share;
}

/// Gram matrix of the blocks first .. last of L^-1 load: the work of one load on another.
Eigen::MatrixXd work(const BlockColumns& y, int last) {
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(y.front().cols(), y.front().cols());
  for (int k = 0; k <= last; ++k) {
    if (y[k].rows() > 0) w.selfadjointView<Eigen::Lower>().rankUpdate(y[k].transpose());
  }
  return w.selfadjointView<Eigen::Lower>();
}

/// X^T G_n: what nodal temperatures do to the surface, X the response to unit pressures.
Eigen::MatrixXd thermal_response(const Body& body, const Freedoms& f, int n,
                                 const BlockColumns& x) {
  const RevolutionMesh& mesh = body.mesh;
  const Eigen::Index nz = x.front().cols();
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(mesh.nodes(), nz);
  Eigen::Matrix<double, 24, 8> g;
  Eigen::MatrixXd xe(24, nz);
  int current = -1;
  for (int row = 0; row < mesh.rows; ++row) {
    for (int col = 0; col < mesh.cols; ++col) {
      const int piece = body.piece[row * mesh.cols + col];
      if (piece != current) g = body.pieces[piece].g0 + n * body.pieces[piece].g1;
      current = piece;
      const auto local = local_freedoms(body, f, row, col);
      for (int i = 0; i < 24; ++i) {
        if (local[i].position < 0) {
          xe.row(i).setZero();
        } else {
          xe.row(i) = local[i].sign * x[local[i].group].row(local[i].position);
        }
      }
      const Eigen::MatrixXd part = g.transpose().lazyProduct(xe);
      for (int a = 0; a < 8; ++a) u.row(mesh.at(row, col)[a]) += part.row(a);
    }
  }
  return u.transpose();
}

/// Deepest row whose inner face still feels harmonic n of a load on the surface.
int first_row(const Body& body, int n) {
  if (!body.solid_core() || n < 2) return 0;
  const auto& r = body.mesh.r_face;
  int first = 0;
  while (first + 2 < body.mesh.rows &&
         std::pow(r[first + 1] / r.back(), 2 * n) < kNegligibleEnergy) {
    ++first;
  }
  return first;
}

/// Everything about one harmonic of one body.
struct Harmonic {
  const Body& body;
  const Freedoms& freedoms;
  const Eigen::MatrixXd& pressure;  ///< P
  int n;

  void solve(const ElasticOptions& options, Eigen::MatrixXd& compliance,
             Eigen::MatrixXd* growth) const;
};

void Harmonic::solve(const ElasticOptions& options, Eigen::MatrixXd& compliance,
                     Eigen::MatrixXd* growth) const {
  const int outer = body.mesh.rows;  // the last block is the outer surface
  const int first = first_row(body, n);
  BlockTridiagonal a = stiffness(body, freedoms, n, first);
  RigidMotions rigid;
  const bool floats = n == 1;
  if (floats) rigid = rigid_motions(body, freedoms, a, pressure);
  if (!factorise(a)) {
    throw InputError("the stiffness is not positive definite; check the elastic constants");
  }
  const auto response = [&](bool balanced) {
    BlockColumns y = zero_columns(a, pressure.cols());
    add_pressure(body, freedoms, pressure, y);
    if (balanced) balance(rigid, y);
    solve_lower(a, y, balanced ? first : body.loaded_line);
    return y;
  };
  const bool free_load = options.support == Support::free;
  BlockColumns y = response(floats && free_load);
  compliance = work(y, free_load ? outer : outer - 1);
  if (growth == nullptr) return;
  const bool free_heat = options.support != Support::clamped;
  if (floats && free_heat && !free_load) y = response(true);
  if (!free_heat) y[outer].setZero();
  solve_upper(a, y, free_heat ? outer : outer - 1);
  // The heat's load is in balance, so the rigid part of y does no work on it.
  *growth = thermal_response(body, freedoms, n, y);
}

ElasticOperators solve_all(const Body& body, const FilmGrid& grid, const ElasticOptions& options) {
  const Eigen::MatrixXd p = cell_integrals(body.mesh, grid);
  const Eigen::Map<const Eigen::VectorXd> dz(grid.dz.data(), grid.nz);
  const Eigen::VectorXd per_cell = dz.cwiseInverse();
  ElasticOperators out;
  out.compliance.resize(options.harmonics + 1);
  if (options.growth) out.growth.resize(options.harmonics + 1);
  Freedoms freedoms;
  for (int n = 0; n <= options.harmonics; ++n) {
    if (n <= 2) freedoms = make_freedoms(body, n);  // the same from n = 2 on
    Eigen::MatrixXd* growth = options.growth ? &out.growth[n] : nullptr;
    Harmonic{body, freedoms, p, n}.solve(options, out.compliance[n], growth);
    out.compliance[n] = grid.radius * per_cell.asDiagonal() * out.compliance[n];
    if (growth != nullptr) *growth = per_cell.asDiagonal() * *growth;
  }
  return out;
}

}  // namespace

ElasticOperators shell_elasticity(const RevolutionMesh& mesh, const FilmGrid& grid,
                                  const std::vector<Material>& layers,
                                  const ElasticOptions& options) {
  EXPECTS(mesh.r_face.front() > 0.0 && mesh.half == grid.half);
  return solve_all(make_body(mesh, layers, options.ends, 0), grid, options);
}

HarmonicOperator shaft_compliance(const RevolutionMesh& mesh, const FilmGrid& grid,
                                  const Material& material, int harmonics, AxialEnds ends) {
  EXPECTS(mesh.r_face.front() == 0.0 && mesh.half == grid.half);
  const ElasticOptions options{harmonics, Support::free, ends, false};
  return solve_all(make_body(mesh, {material}, ends, mesh.rows), grid, options).compliance;
}

std::vector<double> shaft_growth(double radius, double expansion,
                                 const std::vector<double>& shaft_temperature,
                                 double reference_temperature) {
  std::vector<double> opening;
  for (const double t : shaft_temperature) {
    opening.push_back(-expansion * radius * (t - reference_temperature));
  }
  return opening;
}

Eigen::VectorXd uniform_growth(const ElasticOperators& operators) {
  EXPECTS(!operators.growth.empty());
  return operators.growth.front().rowwise().sum();
}

}  // namespace shellback::solid
