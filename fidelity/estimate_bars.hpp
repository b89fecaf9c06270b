#pragma once
/// What the estimate's model leaves out, by indicator numbers: relative bars of its quantities.
#include <vector>

#include "bearing/result.hpp"
#include "fidelity/estimate.hpp"

namespace shellback::fidelity {

inline constexpr double kMostBar = 2.0;  ///< beyond this a bar says nothing more [-]

/// Of the values, but for the eccentricity ratio and the temperature.
struct EstimateBars {
  double torque = 0.0;
  double film = 0.0;
  double peak = 0.0;                     ///< largest pressure
  double flow = 0.0;                     ///< out of the edges
  double angle = 0.0;                    ///< attitude
  double eccentricity = 0.0;             ///< its ratio, absolute
  double temperature = 0.0;              ///< [K]
  std::vector<bearing::Effect> effects;  ///< by name and indicator, as a solved result has them
};

/// Sums over the indicator numbers of the state `e`; docs/auto-tier.md.
[[nodiscard]] EstimateBars estimate_bars(const bearing::Case& c, const Estimate& e);

}  // namespace shellback::fidelity
