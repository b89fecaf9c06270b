#pragma once
/// When a search for a periodic state has come to its end, and how that is told.
#include <cmath>

#include "core/outcome.hpp"

namespace shellback::bearing {

/// How cycles draw near to the periodic state: where the change falls by the ratio rho from cycle
/// to cycle, rho/(1 - rho) of the last one is still to come.
struct Closure {
  double last = NAN;    ///< difference of the last two cycles [-]
  double before = NAN;  ///< of the two before [-]
  void add(double difference);
  /// Two cycles agree within 1e-4 in smallest film and torque.
  [[nodiscard]] bool closed() const;
};

[[nodiscard]] Verdict not_closed(int cycles, double closure);
/// `change` of the walls from the last cycle to the next [K].
[[nodiscard]] Verdict walls_not_found(int cycles, double change);
/// Thermal deformation of the walls [m] against the cold clearance [m].
[[nodiscard]] Verdict no_clearance(double thermal_deformation, double clearance);
/// No temperature of the film at which the oil of a mean cycle carries off its heat.
[[nodiscard]] Verdict no_lumped_balance(double hottest);
/// A step that was not found, at `t` of the cycle [s]; `crank_speed` [rad/s], 0: told in time.
[[nodiscard]] Verdict at_instant(Verdict v, double t, double crank_speed);

}  // namespace shellback::bearing
