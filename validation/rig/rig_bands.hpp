#pragma once
/// How far the unknown inputs move the torque of the rig.
#include <vector>

#include "validation/rig/rig_study.hpp"

namespace shellback::validation {

/// Smallest and largest torque at one speed, each unknown changed alone; not-a-number: none.
struct RigBand {
  double rpm = 0.0;
  double low = 0.0;   ///< [N m]
  double high = 0.0;  ///< [N m]
};
[[nodiscard]] std::vector<RigBand> rig_bands(const RigStudy& study, double peak);

/// What one end of an unknown does to the torque: relative changes over the speeds.
struct RigEffect {
  const RigUnknown* unknown = nullptr;
  int end = 0;
  double low = 0.0;   ///< smallest relative change [-]
  double high = 0.0;  ///< largest [-]
  int missing = 0;    ///< speeds without a result
};
[[nodiscard]] std::vector<RigEffect> rig_effects(const RigStudy& study);

}  // namespace shellback::validation
