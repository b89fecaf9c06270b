#pragma once
/// Bearings whose summits rub, most of them over load cycles.
#include <cmath>

#include "tests/bearing/sample_bearing.hpp"

namespace shellback::bearing::tests {

/// The rig's bearing in oil of 60 degC, pressed down by 2.5 + 1.5 cos kN while it turns to and fro.
[[nodiscard]] inline Case to_and_fro_case(double mass) {
  constexpr int kRows = 40;
  Case c = rig_case();
  c.model.grid = {48, 7};
  c.model.switches.elastic_deformation = true;
  c.oil_temperature = 333.15;
  c.operation.omega = 200.0 * kPi / 30.0;
  c.cycle = LoadCycle{};
  c.cycle->period = 0.2;
  c.cycle->journal_mass = mass;
  for (int k = 0; k < kRows; ++k) {
    const double angle = 2.0 * kPi * k / kRows;
    c.cycle->t.push_back(0.2 * k / kRows);
    c.cycle->x.push_back(0.0);
    c.cycle->y.push_back(-2.5e3 - 1.5e3 * std::cos(angle));
    c.cycle->omega.push_back(c.operation.omega * std::sin(angle));
  }
  return c;
}

/// 50 x 20 mm with relieved edges under a load that swings to 7.5 kN, rough, in contact at its
/// peak, with which the table begins, or half a period later.
[[nodiscard]] inline Case rubbing_case(bool begins_at_the_peak) {
  constexpr int kRows = 36;
  Case c = rig_case();
  c.bearing.radius = 0.025;
  c.bearing.width = 0.02;
  c.bearing.radial_clearance = 25e-6;
  c.bearing.edge_relief = EdgeOpening{2e-6, 3e-3};
  c.model.grid = {48, 7};
  c.surfaces.contact->friction = 0.03;
  c.operation.omega = 600.0 * kPi / 30.0;
  c.cycle = LoadCycle{};
  c.cycle->crank_speed = c.operation.omega;
  c.cycle->period = 2.0 * kPi / c.operation.omega;
  for (int k = 0; k < kRows; ++k) {
    const double angle = 2.0 * kPi * k / kRows + (begins_at_the_peak ? 0.0 : kPi);
    c.cycle->t.push_back(c.cycle->period * k / kRows);
    c.cycle->x.push_back(3.6e3 * std::sin(angle));
    c.cycle->y.push_back(-4.25e3 - 3.25e3 * std::cos(angle));
  }
  return c;
}

/// The KS bearing, elastic, at a speed at which its edges rub and wear until they are worn in.
[[nodiscard]] inline Case wearing_case() {
  Case c = rig_case();
  c.model.tier = Tier::isothermal;
  c.model.switches.elastic_deformation = true;
  c.model.grid = {60, 13};
  c.operation.omega = 600.0 * kPi / 30.0;
  c.running_in = RunningIn{1e-8, 350e6, {}, 0.0, {}, 0.0};
  return c;
}

}  // namespace shellback::bearing::tests
