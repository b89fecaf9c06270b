#pragma once
/// Small sweeps that the tests share.
#include "app/study/sweep.hpp"
#include "tests/bearing/sample_bearing.hpp"

namespace shellback::study::tests {

using bearing::Case;

/// Rigid isothermal bearing: speed [rpm] along, load [kN] across if there is a second axis.
[[nodiscard]] inline CaseAt plain_source(const std::vector<Axis>& axes) {
  return [axes](const Position& at) {
    Case c = bearing::tests::plain_case();
    c.operation.omega = std::stod(word_at(axes[0], at.along)) * kPi / 30.0;
    if (!at.across.empty()) {
      bearing::tests::set_load(c, 1e3 * std::stod(word_at(axes[1], at.across[0])));
    }
    return c;
  };
}

/// KS test bearing, tehd on a coarse grid: speed [rpm] along.
[[nodiscard]] inline CaseAt rig_source(const std::vector<Axis>& axes) {
  return [axes](const Position& at) {
    Case c = bearing::tests::rig_case();
    c.model.grid = {60, 9};
    c.operation.omega = std::stod(word_at(axes[0], at.along)) * kPi / 30.0;
    return c;
  };
}

[[nodiscard]] inline double torque(const SweepPoint& point) {
  return point.result.value("friction_torque");
}

}  // namespace shellback::study::tests
