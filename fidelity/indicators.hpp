#pragma once
/// Indicator numbers of a case, taken at its estimate: which effects can matter.
///
/// Source of numbers and limits: methods 7.2 (docs/models.md); the names are those of the effects
/// that a solved result reports. Orders of magnitude.
#include <vector>

#include "coupling/bearing.hpp"
#include "coupling/result.hpp"
#include "fidelity/estimate.hpp"

namespace shellback::fidelity {

struct Indicators {
  double heating = 0.0;     ///< beta dT, dT of the heat balance [-]
  double across = 0.0;      ///< Nahme number beta eta U^2/k [-]
  double elastic = 0.0;     ///< opening of a held ring under p_max over h_min [-]; 0: no shell
  double thermal = 0.0;     ///< free growth of the clearance over the clearance [-]; 0: no walls
  double pressure = 0.0;    ///< alpha p_max [-]
  double shear = 0.0;       ///< viscosity lost at U/h_min [-]
  double lambda = 0.0;      ///< h_min over roughness [-]; infinite: smooth
  double turbulence = 0.0;  ///< Reynolds number over Taylor's limit [-]
};

/// Radial widening of the bore per uniform pressure [m/Pa]: plane-strain ring of radii a, b, outer
/// surface held (textbook); the housing's material, without one the first layer's. The case has a
/// shell.
[[nodiscard]] double bore_compliance(const coupling::Case& c);

[[nodiscard]] Indicators indicators(const coupling::Case& c, const Estimate& e);

/// The numbers as effects of a result; `physics`: which of them it has.
[[nodiscard]] std::vector<coupling::Effect> effects(const Indicators& numbers,
                                                    const coupling::Physics& physics);

}  // namespace shellback::fidelity
