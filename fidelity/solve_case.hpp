#pragma once
/// One case, one result, in whatever tier the case names: what `run` calls.
#include "bearing/control.hpp"
#include "bearing/result.hpp"

namespace shellback::fidelity {

/// Solves the case in its tier: `estimate`, `auto`, or one of bearing/steady/solve.hpp.
[[nodiscard]] bearing::Result solve_case(const bearing::Case& c,
                                         const bearing::SolveControl& control = {});

}  // namespace shellback::fidelity
