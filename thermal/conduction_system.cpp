#include "thermal/conduction_system.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/contract.hpp"

namespace shellback::thermal {
namespace {

void require_possible(const std::vector<double>& conductivity, const ConductionBoundary& b) {
  for (const double k : conductivity) {
    if (k > 0.0) continue;
    throw InputError(fmt::format("conductivity of a layer is {} W/(m K) (must be positive)", k));
  }
  if (b.back_heat_transfer < 0.0 || b.end_heat_transfer < 0.0) {
    throw InputError(fmt::format(
        "heat transfer coefficients {} and {} W/(m2 K) of a body's surface and ends (must not be "
        "negative)",
        b.back_heat_transfer, b.end_heat_transfer));
  }
}

}  // namespace

ConductionSystem::ConductionSystem(const RevolutionMesh& mesh,
                                   const std::vector<double>& conductivity,
                                   const ConductionBoundary& boundary)
    : mesh_(mesh), boundary_(boundary), rows_(held() ? boundary.back_line : mesh.rows) {
  EXPECTS(boundary.back_line > 0 && boundary.back_line <= mesh.rows);
  require_possible(conductivity, boundary);
  for (int row = 0; row < rows_; ++row) {
    for (int col = 0; col < mesh.cols; ++col) {
      elements_.push_back(heat_element(mesh, row, col, conductivity[mesh.layer[row]], boundary));
    }
  }
}

ConductionSystem::ConductionSystem(const ConductionSystem& steady, const std::vector<double>& rho_c,
                                   double dt)
    : ConductionSystem(steady) {
  if (!(dt > 0.0) || std::isinf(dt)) {
    throw InputError(fmt::format("time step {} s of conduction (must be positive and finite)", dt));
  }
  dt_ = dt;
  storage_.clear();
  for (int row = 0; row < rows_; ++row) {
    const double c = rho_c[mesh_.layer[row]];
    if (!(c > 0.0)) {
      throw InputError(fmt::format(
          "density times heat capacity of a layer is {} J/(m3 K) (must be positive)", c));
    }
    for (int col = 0; col < mesh_.cols; ++col) {
      storage_.push_back(heat_capacity_matrix(mesh_, row, col, c) / dt);
    }
  }
}

int ConductionSystem::free_nodes() const {
  return held() ? mesh_.group_begin(rows_) : mesh_.nodes();
}

BlockTridiagonal ConductionSystem::factor(int n, const Eigen::MatrixXd& outer_line) const {
  BlockTridiagonal a;
  const int line = mesh_.line_nodes();
  for (int k = 0; k <= rows_; ++k) {
    const int size = mesh_.group_begin(k + 1) - mesh_.group_begin(k);
    a.diagonal.push_back(Eigen::MatrixXd::Zero(size, size));
    if (k < rows_) a.coupling.push_back(Eigen::MatrixXd::Zero(line, size));
  }
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const int row = static_cast<int>(e) / mesh_.cols;
    Matrix8 ke = elements_[e].steady(n);
    if (!storage_.empty()) ke += storage_[e];
    const auto& nodes = mesh_.element[e];
    for (int j = 0; j < 8; ++j) {
      const int gj = row + kUpperGroup[j], q = nodes[j] - mesh_.group_begin(gj);
      for (int i = 0; i < 8; ++i) {
        const int gi = row + kUpperGroup[i], p = nodes[i] - mesh_.group_begin(gi);
        if (gi == gj) a.diagonal[gi](p, q) += ke(i, j);
        if (gi > gj) a.coupling[gj](p, q) += ke(i, j);
      }
    }
  }
  if (held()) {
    a.diagonal.pop_back();
    a.coupling.pop_back();
  }
  if (outer_line.size() > 0) a.diagonal.back() += outer_line;
  if (!factorise(a)) throw InputError("the conduction matrix is not positive definite");
  return a;
}

Eigen::MatrixXd ConductionSystem::solve(const BlockTridiagonal& factor,
                                        const Eigen::MatrixXd& load) const {
  BlockColumns x;
  for (std::size_t k = 0; k < factor.diagonal.size(); ++k) {
    x.push_back(load.middleRows(mesh_.group_begin(static_cast<int>(k)), factor.diagonal[k].rows()));
  }
  solve_lower(factor, x);
  solve_upper(factor, x);
  Eigen::MatrixXd nodal = Eigen::MatrixXd::Zero(load.rows(), load.cols());
  for (std::size_t k = 0; k < x.size(); ++k) {
    nodal.middleRows(mesh_.group_begin(static_cast<int>(k)), x[k].rows()) = x[k];
  }
  return nodal;
}

Eigen::MatrixXd ConductionSystem::stored(const Eigen::MatrixXd& T) const {
  EXPECTS(!storage_.empty() && T.rows() == mesh_.nodes());
  Eigen::MatrixXd heat = Eigen::MatrixXd::Zero(T.rows(), T.cols());
  Eigen::Matrix<double, 8, Eigen::Dynamic> part(8, T.cols());
  for (std::size_t e = 0; e < storage_.size(); ++e) {
    for (int b = 0; b < 8; ++b) part.row(b) = T.row(mesh_.element[e][b]);
    part = storage_[e] * part.eval();
    for (int a = 0; a < 8; ++a) heat.row(mesh_.element[e][a]) += part.row(a);
  }
  return heat;
}

Eigen::RowVectorXd ConductionSystem::row_sums(Matrix8 HeatElement::*loss) const {
  Eigen::RowVectorXd w = Eigen::RowVectorXd::Zero(mesh_.nodes());
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    for (int a = 0; a < 8; ++a) w(mesh_.element[e][a]) += (elements_[e].*loss).row(a).sum();
  }
  return w;
}

Eigen::RowVectorXd ConductionSystem::to_ends() const { return row_sums(&HeatElement::ends); }

Eigen::RowVectorXd ConductionSystem::to_back() const {
  if (!held()) return row_sums(&HeatElement::outer);
  Eigen::RowVectorXd w = Eigen::RowVectorXd::Zero(mesh_.nodes());
  for (std::size_t e = elements_.size() - mesh_.cols; e < elements_.size(); ++e) {
    Matrix8 ke = elements_[e].k0 + elements_[e].ends;
    if (!storage_.empty()) ke += storage_[e];
    for (int i = 0; i < 8; ++i) {
      if (!kUpperGroup[i]) continue;
      for (int b = 0; b < 8; ++b) w(mesh_.element[e][b]) -= ke(i, b);
    }
  }
  return w;
}

Eigen::RowVectorXd ConductionSystem::before_to_back() const {
  Eigen::RowVectorXd w = Eigen::RowVectorXd::Zero(mesh_.nodes());
  if (!held() || storage_.empty()) return w;
  for (std::size_t e = elements_.size() - mesh_.cols; e < elements_.size(); ++e) {
    for (int i = 0; i < 8; ++i) {
      if (!kUpperGroup[i]) continue;
      for (int b = 0; b < 8; ++b) w(mesh_.element[e][b]) += storage_[e](i, b);
    }
  }
  return w;
}

Eigen::RowVectorXd ConductionSystem::to_store() const {
  Eigen::RowVectorXd w = Eigen::RowVectorXd::Zero(mesh_.nodes());
  for (std::size_t e = 0; e < storage_.size(); ++e) {
    for (int a = 0; a < 8; ++a) w(mesh_.element[e][a]) += storage_[e].row(a).sum();
  }
  return w;
}

}  // namespace shellback::thermal
