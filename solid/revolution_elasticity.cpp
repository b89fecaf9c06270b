#include "solid/revolution_elasticity.hpp"

#include <cmath>

#include "core/contract.hpp"
#include "solid/elastic_system.hpp"

namespace shellback::solid {
namespace {

constexpr double kNegligibleEnergy = 1e-10;  ///< of the field below a left-out row [-]

BlockColumns zero_columns(const BlockTridiagonal& a, Eigen::Index columns) {
  BlockColumns y;
  for (const auto& d : a.diagonal) y.push_back(Eigen::MatrixXd::Zero(d.rows(), columns));
  return y;
}

/// Unit pressure on each axial cell, without the factor R.
void add_pressure(const ElasticBody& body, const Freedoms& f, const Eigen::MatrixXd& p,
                  BlockColumns& load) {
  const int line = body.mesh.group_begin(body.loaded_line);
  for (int m = 0; m < body.mesh.line_nodes(); ++m) {
    const int i = f.position[3 * (line + m)];
    if (i >= 0) load[f.group[line + m]].row(i) += p.row(m);
  }
}

/// Rigid motions R of harmonic 1 and the body force along them.
struct RigidMotions {
  BlockColumns load;              ///< b, with b^T u the volume mean of u along R
  Eigen::MatrixXd projector;      ///< (b^T R)^-1
  Eigen::MatrixXd pressure_work;  ///< R^T P: includes the pinned freedoms
};

RigidMotions rigid_motions(const ElasticBody& body, const Freedoms& f, const BlockTridiagonal& a,
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
Eigen::MatrixXd thermal_response(const ElasticBody& body, const Freedoms& f, int n,
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
int first_row(const ElasticBody& body, int n) {
  if (!body.solid_core() || n < 2) return 0;
  const auto& r = body.mesh.r_face;
  int first = 0;
  while (first + 2 < body.mesh.rows &&
         std::pow(r[first + 1] / r.back(), 2 * n) < kNegligibleEnergy) {
    ++first;
  }
  return first;
}

/// One harmonic of one body, factored, and L^-1 of unit pressures.
struct Response {
  Freedoms freedoms;
  BlockTridiagonal factor;
  BlockColumns y;
};

/// `balanced`: nothing holds the body, a body force balances the pressures.
void push(const ElasticBody& body, const Eigen::MatrixXd& p, int n, bool balanced, Response& r) {
  const bool from_film = body.order == Elimination::outwards && !balanced;
  r.y = zero_columns(r.factor, p.cols());
  add_pressure(body, r.freedoms, p, r.y);
  if (balanced) balance(rigid_motions(body, r.freedoms, r.factor, p), r.y);
  const int first = body.order == Elimination::outwards ? first_row(body, n) : 0;
  solve_lower(r.factor, r.y, from_film ? body.loaded_line : first);
}

Response respond(const ElasticBody& body, const Eigen::MatrixXd& p, int n, bool hold_outer,
                 bool balanced) {
  const int first = first_row(body, n);
  Response r{make_freedoms(body, n, first, hold_outer), {}, {}};
  r.factor = stiffness(body, r.freedoms, n, first);
  if (!factorise(r.factor)) {
    throw InputError("the stiffness is not positive definite; check the elastic constants");
  }
  push(body, p, n, balanced, r);
  return r;
}

/// How the outer surface is held.
struct Holding {
  bool free_load;  ///< free under pressure
  bool free_heat;  ///< free to grow
};

/// Groups follow each other outwards: the outer surface is the last group.
void solve_outwards(const ElasticBody& body, const Eigen::MatrixXd& p, int n, Holding h,
                    Eigen::MatrixXd& compliance, Eigen::MatrixXd* thermal_deformation) {
  const int outer = body.mesh.rows;
  const bool floats = n == 1;
  Response r = respond(body, p, n, false, floats && h.free_load);
  compliance = work(r.y, h.free_load ? outer : outer - 1);
  if (thermal_deformation == nullptr) return;
  if (floats && h.free_heat && !h.free_load) push(body, p, n, true, r);
  if (!h.free_heat) r.y[outer].setZero();
  solve_upper(r.factor, r.y, h.free_heat ? outer : outer - 1);
  // The heat's load is in balance, so the rigid part of y does no work on it.
  *thermal_deformation = thermal_response(body, r.freedoms, n, r.y);
}

/// Groups follow each other along the axis: every way of holding has its own factor.
void solve_along(const ElasticBody& body, const Eigen::MatrixXd& p, int n, Holding h,
                 Eigen::MatrixXd& compliance, Eigen::MatrixXd* thermal_deformation) {
  const bool floats = n == 1;
  Response r = respond(body, p, n, !h.free_load, floats && h.free_load);
  compliance = work(r.y, body.mesh.cols);
  if (thermal_deformation == nullptr) return;
  if (h.free_heat != h.free_load) r = respond(body, p, n, !h.free_heat, floats && h.free_heat);
  solve_upper(r.factor, r.y);
  *thermal_deformation = thermal_response(body, r.freedoms, n, r.y);
}

ElasticOperators solve_all(const ElasticBody& body, const FilmGrid& grid,
                           const ElasticOptions& options) {
  const Eigen::MatrixXd p = cell_integrals(body.mesh, grid);
  const Eigen::Map<const Eigen::VectorXd> dz(grid.dz.data(), grid.nz);
  const Eigen::VectorXd per_cell = dz.cwiseInverse();
  ElasticOperators out;
  std::vector<int> wanted = options.only;
  for (int n = 0; n <= options.harmonics && options.only.empty(); ++n) wanted.push_back(n);
  out.compliance.resize(wanted.size());
  if (options.thermal_deformation) out.thermal_deformation.resize(wanted.size());
  const Holding holding{options.support == Support::free, options.support != Support::clamped};
  const auto solve = body.order == Elimination::outwards ? solve_outwards : solve_along;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    Eigen::MatrixXd* thermal_deformation =
        options.thermal_deformation ? &out.thermal_deformation[k] : nullptr;
    solve(body, p, wanted[k], holding, out.compliance[k], thermal_deformation);
    out.compliance[k] = grid.radius * per_cell.asDiagonal() * out.compliance[k];
    if (thermal_deformation != nullptr)
      *thermal_deformation = per_cell.asDiagonal() * *thermal_deformation;
  }
  return out;
}

}  // namespace

ElasticOperators shell_elasticity(const RevolutionMesh& mesh, const FilmGrid& grid,
                                  const std::vector<Material>& layers,
                                  const ElasticOptions& options) {
  EXPECTS(mesh.r_face.front() > 0.0 && mesh.half == grid.half);
  const int factorisations =
      options.thermal_deformation && options.support == Support::held ? 2 : 1;
  return solve_all(make_elastic_body(mesh, layers, options.ends == AxialEnds::plane_strain, 0,
                                     options.order, factorisations),
                   grid, options);
}

HarmonicOperator shaft_compliance(const RevolutionMesh& mesh, const FilmGrid& grid,
                                  const Material& material, int harmonics, AxialEnds ends,
                                  Elimination order) {
  EXPECTS(mesh.r_face.front() == 0.0 && mesh.half == grid.half);
  const ElasticOptions options{harmonics, Support::free, ends, false, order, {}};
  return solve_all(make_elastic_body(mesh, {material}, ends == AxialEnds::plane_strain, mesh.rows,
                                     order, 1),
                   grid, options)
      .compliance;
}

Eigen::MatrixXd shaft_thermal_deformation(const RevolutionMesh& mesh, const FilmGrid& grid,
                                          const Material& material) {
  EXPECTS(mesh.r_face.front() == 0.0 && mesh.half == grid.half);
  ElasticOptions options;
  options.support = Support::free;
  options.only = {0};
  const ElasticBody body = make_elastic_body(mesh, {material}, false, mesh.rows, options.order, 1);
  return -solve_all(body, grid, options).thermal_deformation.front();
}

Eigen::VectorXd uniform_expansion(const ElasticOperators& operators) {
  EXPECTS(!operators.thermal_deformation.empty());
  return operators.thermal_deformation.front().rowwise().sum();
}

}  // namespace shellback::solid
