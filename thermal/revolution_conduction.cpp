#include "thermal/revolution_conduction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "thermal/impedance_modes.hpp"

namespace shellback::thermal {
namespace {

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
    : system_(mesh, conductivity, boundary),
      grid_(grid),
      back_line_(boundary.back_line),
      harmonics_(std::move(harmonics)),
      sample_(std::move(sample)),
      cells_(cell_integrals(mesh, grid)) {
  EXPECTS(mesh.half == grid.half && mesh.r_face.front() > 0.0);
  const bool insulated = boundary.back_heat_transfer + boundary.end_heat_transfer == 0.0;
  if (boundary.kind == BackKind::convective && insulated) {
    throw InputError(
        "no heat can leave the shell: both heat transfer coefficients are zero; give the back or "
        "the ends a positive one, or prescribe the back temperature");
  }
  compute();
}

ShellConduction::ShellConduction(const ShellConduction& steady, const std::vector<double>& rho_c,
                                 double dt)
    : system_(steady.system_, rho_c, dt),
      grid_(steady.grid_),
      back_line_(steady.back_line_),
      harmonics_(steady.harmonics_),
      sample_(steady.harmonics_.highest(), true),
      cells_(steady.cells_) {
  compute();
}

ShellConduction ShellConduction::over(double dt, const std::vector<double>& rho_c) const {
  return {*this, rho_c, dt};
}

double ShellConduction::whole() const { return 2.0 * kPi * grid_.multiplicity(); }

Eigen::MatrixXd ShellConduction::cells_at(int line, const Eigen::MatrixXd& nodal) const {
  const RevolutionMesh& mesh = system_.mesh();
  const Eigen::Map<const Eigen::VectorXd> dz(grid_.dz.data(), grid_.nz);
  const Eigen::MatrixXd mean = dz.cwiseInverse().asDiagonal() * cells_.transpose();
  return mean * nodal.middleRows(mesh.group_begin(line), mesh.line_nodes());
}

void ShellConduction::compute() {
  const bool steady = std::isinf(dt());
  const Eigen::Map<const Eigen::VectorXd> dz(grid_.dz.data(), grid_.nz);
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(system_.mesh().nodes(), grid_.nz);
  load.topRows(cells_.rows()) = grid_.radius * cells_;
  for (const int n : sample_.computed()) {
    BlockTridiagonal factor = system_.factor(n);
    nodal_.push_back(system_.solve(factor, load));
    surface_.push_back(cells_at(0, nodal_.back()));
    back_.push_back(cells_at(back_line_, nodal_.back()));
    if (!steady) factor_.push_back(std::move(factor));
  }
  surface_ = sample_.complete(surface_);
  back_ = sample_.complete(back_);
  for (const Eigen::MatrixXd& surface : surface_) {
    ImpedanceModes modes = impedance_modes(surface, dz);
    lambda_.push_back(std::move(modes.lambda));
    modes_.push_back(std::move(modes.V));
  }
  mean_ = dz.transpose() * surface_[0] / dz.sum();
  back_heat_ = whole() * system_.to_back() * nodal_[0];
  end_heat_ = whole() * system_.to_ends() * nodal_[0];
  store_heat_ = whole() * system_.to_store() * nodal_[0];
}

ShellHistory ShellConduction::history(const Eigen::MatrixXd& before) const {
  EXPECTS(!factor_.empty() && before.cols() == harmonics_.coefficients() + grid_.nt);
  const Eigen::MatrixXd load = system_.stored(before);
  ShellHistory h;
  h.nodal.resize(before.rows(), before.cols());
  h.nodal.col(0) = system_.solve(factor_[0], load.col(0));
  for (std::size_t n = 1; n < factor_.size(); ++n) {
    h.nodal.middleCols<2>(2 * n - 1) = system_.solve(factor_[n], load.middleCols<2>(2 * n - 1));
  }
  h.nodal.rightCols(grid_.nt) = system_.solve(factor_.back(), load.rightCols(grid_.nt));
  h.surface = cells_at(0, h.nodal);
  h.back = cells_at(back_line_, h.nodal);
  const Eigen::Map<const Eigen::VectorXd> dz(grid_.dz.data(), grid_.nz);
  h.mean = dz.dot(h.surface.col(0)) / dz.sum();
  const Eigen::VectorXd T = h.nodal.col(0), T_before = before.col(0);
  h.heat_back = whole() * (system_.to_back().dot(T) + system_.before_to_back().dot(T_before));
  h.heat_ends = whole() * system_.to_ends().dot(T);
  h.stored = whole() * system_.to_store().dot(T - T_before);
  return h;
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

double ShellConduction::mean_surface(const Field& q, double surroundings,
                                     const ShellHistory* history) const {
  double mean =
      history ? history->mean
              : 0.0;  // only the circumferential mean of the flux reaches that of the temperature
  for (int i = 0; i < grid_.nt; ++i) {
    const double part = grid_.dphi[i] / (2.0 * kPi);
    for (int j = 0; j < grid_.nz; ++j) mean += part * mean_[j] * q[grid_.index(i, j)];
  }
  return surroundings + mean;
}

Eigen::MatrixXd ShellConduction::answer_above(const Field& q, double g, const Field& t_old,
                                              const ShellHistory* history, Field& surface) const {
  const auto rest = [&](const Field& f) {
    const Field known = harmonics_.synthesise(harmonics_.fit(f));
    const Eigen::Map<const Eigen::MatrixXd> all(f.data(), grid_.nz, grid_.nt);
    return Eigen::MatrixXd(all -
                           Eigen::Map<const Eigen::MatrixXd>(known.data(), grid_.nz, grid_.nt));
  };
  const Eigen::Map<const Eigen::VectorXd> dz(grid_.dz.data(), grid_.nz);
  const Eigen::VectorXd& lambda = lambda_.back();
  Eigen::MatrixXd flux = rest(q), T = rest(t_old);
  Eigen::MatrixXd beyond = -T;  // of what the history leaves
  if (history) beyond += history->surface.rightCols(grid_.nt);
  const Eigen::MatrixXd to_modes = modes_.back().transpose() * dz.asDiagonal();
  const Eigen::VectorXd yields = (1.0 + g * lambda.array()).inverse();
  const Eigen::MatrixXd change =
      modes_.back() *
      (yields.asDiagonal() * (lambda.asDiagonal() * (to_modes * flux) + to_modes * beyond));
  T += change;
  flux -= g * change;
  Eigen::Map<Eigen::MatrixXd>(surface.data(), grid_.nz, grid_.nt) += T;
  return flux;
}

ShellTemperature ShellConduction::solve(const Field& q, FilmConductance film, const Field& t_old,
                                        double surroundings, bool with_back,
                                        const ShellHistory* history) const {
  EXPECTS(film.mean >= 0.0 && film.local >= 0.0 && q.size() == t_old.size());
  EXPECTS((history != nullptr) == std::isfinite(dt()));
  const Eigen::Map<const Eigen::VectorXd> dz(grid_.dz.data(), grid_.nz);
  ShellTemperature out;
  out.flux = harmonics_.analyse(q);
  Eigen::MatrixXd old = harmonics_.fit(t_old);
  old.col(0).array() -= surroundings;
  if (history) old -= history->surface.leftCols(harmonics_.coefficients());
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
  const auto cells = [&](const HarmonicOperator& op, Eigen::MatrixXd ShellHistory::*past) {
    Eigen::MatrixXd t = multiply(op, out.flux);
    if (history) t += (history->*past).leftCols(harmonics_.coefficients());
    t.col(0).array() += surroundings;
    return harmonics_.synthesise(t);
  };
  out.surface = cells(surface_, &ShellHistory::surface);
  if (with_back) out.back = cells(back_, &ShellHistory::back);
  const Eigen::VectorXd mean_flux = out.flux.col(0);
  out.heat_in = whole() * grid_.radius * dz.dot(mean_flux);
  out.heat_back = back_heat_ * mean_flux + (history ? history->heat_back : 0.0);
  out.heat_ends = end_heat_ * mean_flux + (history ? history->heat_ends : 0.0);
  out.stored = store_heat_ * mean_flux + (history ? history->stored : 0.0);
  const Eigen::MatrixXd above = answer_above(q, film.local, t_old, history, out.surface);
  out.flux.conservativeResize(Eigen::NoChange, harmonics_.coefficients() + grid_.nt);
  out.flux.rightCols(grid_.nt) = above;
  return out;
}

Eigen::MatrixXd ShellConduction::nodal_temperatures(const Eigen::MatrixXd& flux,
                                                    const ShellHistory* history) const {
  EXPECTS((history != nullptr) == std::isfinite(dt()));
  const Eigen::Index known = harmonics_.coefficients();
  EXPECTS(flux.cols() == known + grid_.nt);
  Eigen::MatrixXd T(system_.mesh().nodes(), flux.cols());
  T.leftCols(known) = multiply(history ? nodal_ : sample_.complete(nodal_), flux.leftCols(known));
  T.rightCols(grid_.nt) = nodal_.back() * flux.rightCols(grid_.nt);
  if (history) T += history->nodal;
  return T;
}

Eigen::MatrixXd ShellConduction::uniform_temperatures(double rise) const {
  Eigen::MatrixXd T =
      Eigen::MatrixXd::Zero(system_.mesh().nodes(), harmonics_.coefficients() + grid_.nt);
  T.col(0).head(system_.free_nodes()).setConstant(rise);
  return T;
}

ShellTemperature ShellConduction::at(const Eigen::MatrixXd& nodal, double surroundings) const {
  const auto cells = [&](int line) {
    Eigen::MatrixXd t = cells_at(line, nodal);
    t.col(0).array() += surroundings;
    Field cells = harmonics_.synthesise(t.leftCols(harmonics_.coefficients()));
    if (line == 0) {  // nothing of it comes to the back
      Eigen::Map<Eigen::MatrixXd>(cells.data(), grid_.nz, grid_.nt) += t.rightCols(grid_.nt);
    }
    return cells;
  };
  ShellTemperature out;
  out.surface = cells(0);
  out.back = cells(back_line_);
  return out;
}

Eigen::MatrixXd ShellConduction::section(const Eigen::MatrixXd& nodal) const {
  const std::vector<int> nodes = section_nodes(system_.mesh());
  Eigen::MatrixXd s(nodes.size(), nodal.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    s.row(static_cast<Eigen::Index>(i)) = nodal.row(nodes[i]);
  }
  return s;
}

HarmonicOperator ShellConduction::section() const {
  HarmonicOperator op;
  for (const auto& t : nodal_) op.push_back(section(t));
  return sample_.complete(op);
}

std::vector<double> ShellConduction::section_radii() const {
  std::vector<double> radii;
  for (const int a : section_nodes(system_.mesh())) radii.push_back(system_.mesh().r[a]);
  return radii;
}

}  // namespace shellback::thermal
