#pragma once
/// How far the tier `estimate` lies from the full solution: bars from the indicator numbers.
#include "fidelity/estimate.hpp"
#include "fidelity/indicators.hpp"

namespace shellback::fidelity {

/// Relative errors [-], the temperature's in kelvin.
struct EstimateBars {
  double torque = 0.0;
  double h_min = 0.0;
  double p_max = 0.0;
  double side_flow = 0.0;
  double attitude = 0.0;
  double contact = 0.0;
  double temperature = 0.0;
};

[[nodiscard]] EstimateBars estimate_bars(const coupling::Case& c, const Estimate& e,
                                         const Indicators& numbers);

}  // namespace shellback::fidelity
