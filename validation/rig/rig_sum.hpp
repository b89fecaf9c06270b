#pragma once
/// The KS rig as a sum of its bearings.
///
/// A straight shaft lies in two support bearings; midway between them the test bearing is loaded
/// with F. The transducer stands between motor and rig:
///
///   F_support = F/2               balance of forces, and of moments about mid-span [N]   (1)
///   M = M_test + 2 M_support      balance of moments about the shaft's axis [N m]        (2)
///
/// Valid for a shaft that neither bends nor tilts, and whose weight and inertia are small beside F.
/// Sources: textbook; arrangement: Sander, Allmaier, Priebsch, InTech 2016, doi 10.5772/64247, 3.4.
#include <array>
#include <vector>

#include "bearing/over_time/cycle.hpp"

namespace shellback::validation {

/// Loads of the three bearings: left support, test bearing, right support [N]. (1)
[[nodiscard]] std::array<double, 3> rig_loads(double load);

/// Torque at the motor of these three [N m]. (2)
[[nodiscard]] double rig_torque(const std::array<double, 3>& torques);

/// The same of a test bearing and two like supports.
[[nodiscard]] double rig_torque(double test, double support);

/// The rig at one instant.
struct RigInstant {
  double t = 0.0;         ///< [s]
  double omega = 0.0;     ///< [rad/s]
  double torque = 0.0;    ///< [N m]
  double asperity = 0.0;  ///< part of it from asperities [N m]
};

/// (2) at each instant of the test bearing; the supports' torques are straight between theirs.
/// Both start at 0 and neither is empty.
[[nodiscard]] std::vector<RigInstant> rig_series(const std::vector<bearing::CycleInstant>& test,
                                                 const std::vector<bearing::CycleInstant>& support);

/// The first time, after a first one above it, from which on asperities rub with less than a
/// hundredth of `breakaway` [s]; not-a-number if they never do. The hundredth is that of
/// lift_off_speed (docs/load-cycles.md).
[[nodiscard]] double time_of_full_film(const std::vector<RigInstant>& series, double breakaway);

}  // namespace shellback::validation
