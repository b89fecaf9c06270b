#pragma once
/// Indicator numbers that need no solution.
#include "bearing/case.hpp"

namespace shellback::fidelity {

/// Radial widening of the bore per uniform pressure [m/Pa]: plane-strain ring of radii a, b, outer
/// surface held (textbook); the housing's material, without one the first layer's. The case has a
/// shell.
[[nodiscard]] double bore_compliance(const bearing::Case& c);

}  // namespace shellback::fidelity
