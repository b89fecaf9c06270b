#pragma once
/// Indicator numbers that need no solution.
#include "bearing/case.hpp"

namespace shellback::fidelity {

/// Radial widening of the bore per pressure [m/Pa]: that of the shell's layers, each on a stiff
/// back, and of the housing, a plane-strain ring whose outer surface is held (textbook). The case
/// has a shell.
[[nodiscard]] double bore_compliance(const bearing::Case& c);

}  // namespace shellback::fidelity
