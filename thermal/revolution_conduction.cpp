#include "thermal/revolution_conduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/block_cholesky.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::thermal {
namespace {

constexpr int kFullOrder = 3;
/// Local nodes that belong to the outer corner line of their row.
constexpr std::array<int, 8> kUpperGroup{0, 1, 1, 0, 0, 1, 0, 0};
/// Local nodes of the element's edges at smallest z, largest z and outer radius.
constexpr std::array<int, 3> kLowEnd{0, 4, 1}, kHighEnd{3, 6, 2}, kOuterEdge{1, 5, 2};

using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// Element integrals per radian: conduction k0 + n^2 k2, loss through ends and outer surface.
struct HeatElement {
  Matrix8 k0 = Matrix8::Zero(), k2 = Matrix8::Zero();
  Matrix8 ends = Matrix8::Zero(), outer = Matrix8::Zero();
};

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
  if (row == mesh.rows - 1 && boundary.kind == BackKind::convective) {
    add_edge(e.outer, kOuterEdge, boundary.back_heat_transfer, r1, r1,
             mesh.z_face[col + 1] - mesh.z_face[col]);
  }
  return e;
}

/// Rows that conduct: all of them, or those inside a prescribed back.
int active_rows(const RevolutionMesh& mesh, const ConductionBoundary& b) {
  return b.kind == BackKind::convective ? mesh.rows : b.back_line;
}

void require_possible(const std::vector<double>& conductivity, const ConductionBoundary& b) {
  for (const double k : conductivity) {
    if (k > 0.0) continue;
    throw InputError(
        fmt::format("conductivity of a shell layer is {} W/(m K) (must be positive)", k));
  }
  if (b.back_heat_transfer < 0.0 || b.end_heat_transfer < 0.0) {
    throw InputError(fmt::format(
        "heat transfer coefficients {} and {} W/(m2 K) of the shell's back and ends (must not be "
        "negative)",
        b.back_heat_transfer, b.end_heat_transfer));
  }
  if (b.kind == BackKind::convective && b.back_heat_transfer + b.end_heat_transfer == 0.0) {
    throw InputError(
        "no heat can leave the shell: both heat transfer coefficients are zero; give the back or "
        "the ends a positive one, or prescribe the back temperature");
  }
}

BlockTridiagonal conduction_matrix(const RevolutionMesh& mesh,
                                   const std::vector<HeatElement>& elements, int n, int rows) {
  BlockTridiagonal a;
  const int line = mesh.line_nodes();
  for (int k = 0; k <= rows; ++k) {
    const int size = mesh.group_begin(k + 1) - mesh.group_begin(k);
    a.diagonal.push_back(Eigen::MatrixXd::Zero(size, size));
    if (k < rows) a.coupling.push_back(Eigen::MatrixXd::Zero(line, size));
  }
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < mesh.cols; ++col) {
      const HeatElement& e = elements[row * mesh.cols + col];
      const Matrix8 ke = e.k0 + n * n * e.k2 + e.ends + e.outer;
      const auto& nodes = mesh.at(row, col);
      for (int j = 0; j < 8; ++j) {
        const int gj = row + kUpperGroup[j], q = nodes[j] - mesh.group_begin(gj);
        for (int i = 0; i < 8; ++i) {
          const int gi = row + kUpperGroup[i], p = nodes[i] - mesh.group_begin(gi);
          if (gi == gj) a.diagonal[gi](p, q) += ke(i, j);
          if (gi > gj) a.coupling[gj](p, q) += ke(i, j);
        }
      }
    }
  }
  return a;
}

/// int h N_a r ds of the chosen loss, summed over the conducting elements: heat per radian and
/// kelvin of each node.
Eigen::RowVectorXd loss_weights(const RevolutionMesh& mesh,
                                const std::vector<HeatElement>& elements, int rows,
                                Matrix8 HeatElement::*loss) {
  Eigen::RowVectorXd w = Eigen::RowVectorXd::Zero(mesh.nodes());
  for (int e = 0; e < rows * mesh.cols; ++e) {
    const auto& nodes = mesh.element[e];
    for (int a = 0; a < 8; ++a) w(nodes[a]) += (elements[e].*loss).row(a).sum();
  }
  return w;
}

/// Heat that the held nodes of line `rows` take up per radian, per temperature of each node.
Eigen::RowVectorXd reaction_weights(const RevolutionMesh& mesh,
                                    const std::vector<HeatElement>& elements, int rows) {
  Eigen::RowVectorXd w = Eigen::RowVectorXd::Zero(mesh.nodes());
  for (int e = (rows - 1) * mesh.cols; e < rows * mesh.cols; ++e) {
    const auto& nodes = mesh.element[e];
    const Matrix8 ke = elements[e].k0 + elements[e].ends;
    for (int i = 0; i < 8; ++i) {
      if (!kUpperGroup[i]) continue;
      for (int b = 0; b < 8; ++b) w(nodes[b]) -= ke(i, b);
    }
  }
  return w;
}

/// Nodal temperature rises per unit flux on each axial film cell.
Eigen::MatrixXd nodal_response(const RevolutionMesh& mesh, const std::vector<HeatElement>& elements,
                               const Eigen::MatrixXd& load, int n, int rows, bool held) {
  BlockTridiagonal a = conduction_matrix(mesh, elements, n, rows);
  if (held) {
    a.diagonal.pop_back();
    a.coupling.pop_back();
  }
  if (!factorise(a)) throw InputError("the conduction matrix is not positive definite");
  BlockColumns x;
  for (const auto& d : a.diagonal) x.push_back(Eigen::MatrixXd::Zero(d.rows(), load.cols()));
  x[0].topRows(load.rows()) = load;
  solve_lower(a, x);
  solve_upper(a, x);
  Eigen::MatrixXd nodal = Eigen::MatrixXd::Zero(mesh.nodes(), load.cols());
  for (std::size_t k = 0; k < x.size(); ++k) {
    nodal.middleRows(mesh.group_begin(static_cast<int>(k)), x[k].rows()) = x[k];
  }
  return nodal;
}

/// Nodes on z = 0 from the bore outwards.
std::vector<int> section_nodes(const RevolutionMesh& mesh) {
  std::vector<int> nodes;
  for (int k = 0; k <= mesh.rows; ++k) {
    nodes.push_back(mesh.group_begin(k) + (mesh.half ? 0 : mesh.cols));
    const bool has_mid = mesh.half || mesh.cols % 2 == 0;
    if (k < mesh.rows && has_mid) nodes.push_back(mesh.mid_node(k, mesh.half ? 0 : mesh.cols / 2));
  }
  return nodes;
}

}  // namespace

int outer_line(const RevolutionMesh& mesh, int layer) {
  const auto end = std::upper_bound(mesh.layer.begin(), mesh.layer.end(), layer);
  return static_cast<int>(end - mesh.layer.begin());
}

ShellConduction::ShellConduction(const RevolutionMesh& mesh, const FilmGrid& grid,
                                 const std::vector<double>& conductivity,
                                 const ConductionBoundary& boundary, Harmonics harmonics)
    : ShellConduction(mesh, grid, conductivity, boundary, harmonics,
                      HarmonicSample(harmonics.highest(), true)) {}

ShellConduction::ShellConduction(const RevolutionMesh& mesh, const FilmGrid& grid,
                                 const std::vector<double>& conductivity,
                                 const ConductionBoundary& boundary, Harmonics harmonics,
                                 HarmonicSample sample)
    : mesh_(mesh), grid_(grid), harmonics_(std::move(harmonics)), sample_(std::move(sample)) {
  EXPECTS(mesh.half == grid.half && mesh.r_face.front() > 0.0);
  EXPECTS(boundary.back_line > 0 && boundary.back_line <= mesh.rows);
  require_possible(conductivity, boundary);
  const int rows = active_rows(mesh, boundary);
  const bool held = boundary.kind == BackKind::prescribed;
  std::vector<HeatElement> elements;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < mesh.cols; ++col) {
      elements.push_back(heat_element(mesh, row, col, conductivity[mesh.layer[row]], boundary));
    }
  }
  const Eigen::MatrixXd p = cell_integrals(mesh, grid);
  const Eigen::Map<const Eigen::VectorXd> dz(grid.dz.data(), grid.nz);
  const Eigen::VectorXd root = dz.cwiseSqrt(), over_root = root.cwiseInverse();
  const Eigen::MatrixXd mean = dz.cwiseInverse().asDiagonal() * p.transpose();
  const auto at_line = [&](int k) {
    return mean * nodal_.back().middleRows(mesh.group_begin(k), mesh.line_nodes());
  };
  for (const int n : sample_.computed()) {
    nodal_.push_back(nodal_response(mesh, elements, grid.radius * p, n, rows, held));
    surface_.push_back(at_line(0));
    back_.push_back(at_line(boundary.back_line));
  }
  surface_ = sample_.complete(surface_);
  back_ = sample_.complete(back_);
  for (const Eigen::MatrixXd& surface : surface_) {
    const Eigen::MatrixXd z = root.asDiagonal() * surface * over_root.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (z + z.transpose()));
    lambda_.push_back(eigen.eigenvalues());
    modes_.push_back(over_root.asDiagonal() * eigen.eigenvectors());
  }
  mean_ = dz.transpose() * surface_[0] / dz.sum();
  const double turn = 2.0 * kPi * grid.multiplicity();
  const Eigen::RowVectorXd to_back = held ? reaction_weights(mesh, elements, rows)
                                          : loss_weights(mesh, elements, rows, &HeatElement::outer);
  back_heat_ = turn * to_back * nodal_[0];
  end_heat_ = turn * loss_weights(mesh, elements, rows, &HeatElement::ends) * nodal_[0];
}

HarmonicOperator ShellConduction::entering(FilmConductance film) const {
  const Eigen::Map<const Eigen::VectorXd> dz(grid_.dz.data(), grid_.nz);
  HarmonicOperator op;
  for (std::size_t n = 0; n < modes_.size(); ++n) {
    const double g = n == 0 ? film.mean : film.local;
    const Eigen::VectorXd part = (1.0 + g * lambda_[n].array()).inverse();
    op.emplace_back(modes_[n] * part.asDiagonal() * modes_[n].transpose() * dz.asDiagonal());
  }
  return op;
}

double ShellConduction::mean_surface(const Field& q, double surroundings) const {
  double mean = 0.0;  // only the circumferential mean of the flux reaches that of the temperature
  for (int i = 0; i < grid_.nt; ++i) {
    const double part = grid_.dphi[i] / (2.0 * kPi);
    for (int j = 0; j < grid_.nz; ++j) mean += part * mean_[j] * q[grid_.index(i, j)];
  }
  return surroundings + mean;
}

ShellTemperature ShellConduction::solve(const Field& q, FilmConductance film, const Field& t_old,
                                        double surroundings, bool with_back) const {
  EXPECTS(film.mean >= 0.0 && film.local >= 0.0 && q.size() == t_old.size());
  const Eigen::Map<const Eigen::VectorXd> dz(grid_.dz.data(), grid_.nz);
  ShellTemperature out;
  out.flux = harmonics_.analyse(q);
  Eigen::MatrixXd old = harmonics_.fit(t_old);
  old.col(0).array() -= surroundings;
  for (Eigen::Index c = 0; c < old.cols(); ++c) {
    const Eigen::Index n = (c + 1) / 2;
    const double g = n == 0 ? film.mean : film.local;
    const Eigen::VectorXd y = modes_[n].transpose() * dz.cwiseProduct(out.flux.col(c));
    const Eigen::VectorXd y_old = modes_[n].transpose() * dz.cwiseProduct(old.col(c));
    // t - t_old = (lambda y - y_old) / (1 + g lambda) per mode; the flux gives way by g times it
    out.flux.col(c) -= modes_[n] * (g * (lambda_[n].array() * y.array() - y_old.array()) /
                                    (1.0 + g * lambda_[n].array()))
                                       .matrix();
  }
  const auto cells = [&](const HarmonicOperator& op) {
    Eigen::MatrixXd t = multiply(op, out.flux);
    t.col(0).array() += surroundings;
    return harmonics_.synthesise(t);
  };
  out.surface = cells(surface_);
  if (with_back) out.back = cells(back_);
  const Eigen::VectorXd mean_flux = out.flux.col(0);
  out.heat_in = 2.0 * kPi * grid_.multiplicity() * grid_.radius * dz.dot(mean_flux);
  out.heat_back = back_heat_ * mean_flux;
  out.heat_ends = end_heat_ * mean_flux;
  return out;
}

HarmonicOperator ShellConduction::section() const {
  const std::vector<int> nodes = section_nodes(mesh_);
  HarmonicOperator op;
  for (const auto& t : nodal_) {
    Eigen::MatrixXd s(nodes.size(), t.cols());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      s.row(static_cast<Eigen::Index>(i)) = t.row(nodes[i]);
    }
    op.push_back(std::move(s));
  }
  return sample_.complete(op);
}

std::vector<double> ShellConduction::section_radii() const {
  std::vector<double> radii;
  for (const int a : section_nodes(mesh_)) radii.push_back(mesh_.r[a]);
  return radii;
}

}  // namespace shellback::thermal
