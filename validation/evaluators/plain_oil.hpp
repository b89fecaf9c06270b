#pragma once
/// Oil of one viscosity and density, whatever the pressure: that of closed solutions.
#include "fluid/reynolds.hpp"

namespace shellback::validation {

// Of films whose dimensionless numbers these do not change.
inline constexpr double kAnyRadius = 0.02;      ///< [m]
inline constexpr double kAnyClearance = 20e-6;  ///< [m]
inline constexpr double kAnyViscosity = 0.01;   ///< [Pa s]
inline constexpr double kAnyDensity = 850.0;    ///< [kg/m3]

/// `eta` [Pa s], `rho` [kg/m3]. Source: textbook (full film between smooth parallel walls).
[[nodiscard]] inline fluid::OilLaw plain_oil(double eta, double rho) {
  return [eta, rho](const fluid::FilmState& state, fluid::FilmCoefficients& coefficients) {
    const std::size_t n = state.p.size();
    coefficients.fluidity.assign(n, 1.0 / (12.0 * eta));
    coefficients.chi.assign(n, 0.5);
    coefficients.alpha.assign(n, 0.0);
    coefficients.density.assign(n, rho);
  };
}

}  // namespace shellback::validation
