#include "bearing/operating_point.hpp"

#include <cmath>

#include "bearing/state.hpp"

namespace shellback::bearing {

double LoadTarget::scale() const { return unit > 0.0 ? unit : std::hypot(force[0], force[1]); }

double PathRow::missing(const State& s) const {
  double left = length - along_load * (s.ln_load - from_load);
  for (int k = 0; k < 4; ++k) {
    if (along[k] != 0.0) left -= along[k] * (s.position.q[k] - from.q[k]) / unit[k];
  }
  return left;
}

fluid::Wrench LoadTarget::wanted(const State& s) const {
  fluid::Wrench w = force;
  if (path) {
    for (double& f : w) f *= std::exp(s.ln_load);
  }
  for (int k = 0; k < 2; ++k) w[k] += inertial_stiffness * s.flight[k];
  return w;
}

double LoadTarget::work_of_moment(double psi_x, double psi_y) const {
  return unknowns == 4 ? -force[2] * psi_x - force[3] * psi_y : 0.0;
}

LoadTarget load_target(const Case& c) {
  LoadTarget t;
  if (const auto* load = std::get_if<LoadGiven>(&c.operation.position)) {
    t.force = {-load->force * std::cos(load->angle), -load->force * std::sin(load->angle), 0.0,
               0.0};
  } else {
    t.unknowns = 0;
  }
  if (const auto* moment = std::get_if<MomentGiven>(&c.operation.alignment)) {
    t.unknowns = 4;
    t.force[2] = -moment->about_x;
    t.force[3] = -moment->about_y;
  }
  return t;
}

OperatingPoint operating_point(const BearingModel& model) {
  OperatingPoint point;
  static_cast<fluid::FilmDomain&>(point.scene) = model.domain;
  point.scene.supply = model.supply;
  point.scene.speed = model.input.operation.omega * model.input.bearing.radius;
  point.load = load_target(model.input);
  if (model.physics.elastic) point.layer = pressed_layer(model.input, model.domain.grid.cells());
  return point;
}

}  // namespace shellback::bearing
