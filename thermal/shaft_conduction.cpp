#include "thermal/shaft_conduction.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/constants.hpp"
#include "core/contract.hpp"
#include "thermal/impedance_modes.hpp"

namespace shellback::thermal {
namespace {

ConductionSystem steady_system(const RevolutionMesh& mesh, const FilmGrid& grid,
                               const ShaftBody& shaft) {
  EXPECTS(mesh.half == grid.half && mesh.r_face.front() == 0.0);
  if (!(shaft.conductivity > 0.0) || shaft.heat_transfer < 0.0) {
    throw InputError(fmt::format(
        "shaft with conductivity {} W/(m K) and heat transfer {} W/(m2 K) (the first must be "
        "positive, the other must not be negative)",
        shaft.conductivity, shaft.heat_transfer));
  }
  ConductionBoundary boundary;
  boundary.back_heat_transfer = shaft.heat_transfer;
  boundary.back_line = mesh.rows;
  boundary.covered = 0.5 * grid.width;
  return {mesh, {shaft.conductivity}, boundary};
}

}  // namespace

RevolutionMesh shaft_mesh(const FilmGrid& grid, double overhang) {
  const std::vector<double> film = axial_elements(grid);
  const double at_edge = film.back() - film[film.size() - 2];
  const RadialRows rows = rows_of_cylinder(grid.radius, at_edge);
  return make_revolution_mesh(rows.face, rows.layer, axial_elements(grid, overhang), grid.half);
}

ShaftConduction::ShaftConduction(const RevolutionMesh& mesh, const FilmGrid& grid,
                                 const ShaftBody& body)
    : ShaftConduction(steady_system(mesh, grid, body), grid, body) {}

ShaftConduction ShaftConduction::over(double dt) const {
  return {ConductionSystem(system_, {body_.capacity}, dt), grid_, body_};
}

ShaftConduction::ShaftConduction(ConductionSystem system, const FilmGrid& grid,
                                 const ShaftBody& body)
    : system_(std::move(system)),
      grid_(grid),
      body_(body),
      dz_(Eigen::Map<const Eigen::VectorXd>(grid.dz.data(), grid.nz)),
      cells_(cell_integrals(system_.mesh(), grid)),
      out_(whole() * system_.to_back()),
      store_(whole() * system_.to_store()) {
  insulated_ = steady() && out_.sum() == 0.0;
  held_ = steady() ? body.conductivity / grid.radius : 0.0;
  Eigen::MatrixXd film;
  if (steady()) {
    film = held_ * grid.radius * cells_ * dz_.cwiseInverse().asDiagonal() * cells_.transpose();
  }
  factor_ = system_.factor(0, film);
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(system_.mesh().nodes(), grid.nz);
  load.bottomRows(cells_.rows()) = grid.radius * cells_;
  nodal_ = system_.solve(factor_, load);
  if (steady()) factor_ = {};
  ImpedanceModes modes = impedance_modes(surface(nodal_), dz_);
  mu_ = (modes.lambda.cwiseInverse().array() - held_).max(0.0);
  if (insulated_) mu_[grid.nz - 1] = 0.0;  // of the largest eigenvalue of Z: the mean's
  modes_ = std::move(modes.V);
  draw_ = whole() * grid.radius * (dz_.transpose() * modes_) * mu_.asDiagonal() *
          modes_.transpose() * dz_.asDiagonal();
}

bool ShaftConduction::steady() const { return std::isinf(system_.dt()); }

double ShaftConduction::whole() const { return 2.0 * kPi * grid_.multiplicity(); }

Eigen::MatrixXd ShaftConduction::surface(const Eigen::MatrixXd& nodal) const {
  return dz_.cwiseInverse().asDiagonal() * (cells_.transpose() * nodal.bottomRows(cells_.rows()));
}

Eigen::VectorXd ShaftConduction::rise(const std::vector<double>& t,
                                      const ShaftHistory* past) const {
  EXPECTS(static_cast<int>(t.size()) == grid_.nz && (past != nullptr) != steady());
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(t.data(), grid_.nz);
  x.array() -= body_.ambient;
  if (past) x -= past->surface;
  return x;
}

ShaftHistory ShaftConduction::history(const Eigen::VectorXd& before) const {
  EXPECTS(!steady() && before.size() == system_.mesh().nodes());
  ShaftHistory h;
  h.nodal = system_.solve(factor_, system_.stored(before));
  h.surface = surface(h.nodal);
  h.heat_out = out_.dot(h.nodal);
  h.stored = store_.dot(h.nodal - before);
  return h;
}

ShaftTemperature ShaftConduction::solve(const std::vector<double>& q, double g,
                                        const std::vector<double>& t_old,
                                        const ShaftHistory* history) const {
  EXPECTS(static_cast<int>(q.size()) == grid_.nz && g >= 0.0);
  if (insulated_ && g == 0.0) {
    throw InputError(
        "no heat can leave the shaft: its overhang or heat transfer coefficient is zero");
  }
  const Eigen::Map<const Eigen::VectorXd> given(q.data(), grid_.nz);
  const Eigen::VectorXd offered = modes_.transpose() * dz_.cwiseProduct(given);
  const Eigen::VectorXd old = modes_.transpose() * dz_.cwiseProduct(rise(t_old, history));
  // mode by mode: mu t = offered - g (t - old)
  const Eigen::VectorXd t = (offered + g * old).cwiseQuotient((mu_.array() + g).matrix());
  const Eigen::VectorXd flux = modes_ * mu_.cwiseProduct(t);
  ShaftTemperature out;
  out.nodal = nodal_ * (flux + held_ * (modes_ * t));
  out.heat_in = whole() * grid_.radius * dz_.dot(flux);
  out.heat_out = out_.dot(out.nodal);
  if (history) {
    out.stored = store_.dot(out.nodal) + history->stored;
    out.heat_out += history->heat_out;
    out.nodal += history->nodal;
  }
  out.temperature = at(out.nodal).temperature;
  return out;
}

double ShaftConduction::imbalance(const std::vector<double>& q, const std::vector<double>& t,
                                  const ShaftHistory* history) const {
  const Eigen::Map<const Eigen::VectorXd> given(q.data(), grid_.nz);
  return whole() * grid_.radius * dz_.dot(given) - draw_.dot(rise(t, history));
}

Eigen::VectorXd ShaftConduction::uniform(double T) const {
  return Eigen::VectorXd::Constant(system_.mesh().nodes(), T - body_.ambient);
}

ShaftTemperature ShaftConduction::at(const Eigen::VectorXd& nodal) const {
  const Eigen::VectorXd t = surface(nodal).array() + body_.ambient;
  ShaftTemperature out;
  out.temperature.assign(t.data(), t.data() + t.size());
  out.nodal = nodal;
  return out;
}

}  // namespace shellback::thermal
