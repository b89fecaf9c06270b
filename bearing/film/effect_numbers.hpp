#pragma once
/// Indicator numbers of the effects, included or left out, of a steady state or a cycle. Source:
/// methods 7.2.
#include <limits>
#include <vector>

#include "bearing/bearing.hpp"
#include "bearing/film/equilibrium.hpp"
#include "bearing/result.hpp"

namespace shellback::bearing {

/// What a film has come to; of a cycle its means and extremes.
struct EffectNumbers {
  double T = 0.0;      ///< film, mean [K]
  double U = 0.0;      ///< sliding speed, largest magnitude [m/s]
  double h_min = 0.0;  ///< smallest film [m]
  double p_max = 0.0;  ///< [Pa]
  double rise = 0.0;   ///< friction power over the heat capacity of the oil that leaves [K]
  double fed = 0.0;    ///< head of the fed oil over the pressure that drives it (FedFlow::part) [-]
  /// Largest elastic opening over yielding_film; NaN: not in this tier [-].
  double opening = std::numeric_limits<double>::quiet_NaN();
  /// Largest thermal change of the gap; NaN: not in this tier [m].
  double widening = std::numeric_limits<double>::quiet_NaN();
};

/// The film, or its roughness, if that is more [m].
[[nodiscard]] double yielding_film(const BearingModel& m, double h_min);

/// `heated`: the film's temperature follows from its friction.
[[nodiscard]] std::vector<Effect> effects_of(const BearingModel& m, const EffectNumbers& n,
                                             bool heated);

}  // namespace shellback::bearing
