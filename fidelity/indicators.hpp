#pragma once
/// Indicator numbers that need no solution.
#include "bearing/case.hpp"

namespace shellback::fidelity {

/// Sag of a shaft on two supports over half of the bearing's width, per pressure on the projected
/// area [m/Pa]: Timoshenko beam on hinges [shaft] span apart, its curvature that of mid-width
/// (textbook); 0 without a span.
[[nodiscard]] double shaft_sag(const bearing::Case& c);

/// Radial widening of the gap per pressure [m/Pa]: that of the shell's layers, each on a stiff
/// back, of the housing, a plane-strain ring whose outer surface is held (textbook), and the sag of
/// the shaft. The case has a shell.
[[nodiscard]] double bore_compliance(const bearing::Case& c);

/// What shell and shaft at T [K] change of the clearance, freely, over the clearance: by the
/// difference of their expansions, or 0.3 of the shaft's, which is the warmer one; 0: one of them
/// is not known [-].
[[nodiscard]] double thermal_opening(const bearing::Case& c, double T);

}  // namespace shellback::fidelity
