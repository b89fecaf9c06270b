#pragma once
/// One case, one result, in whatever tier the case names: what `run` calls.
#include "coupling/control.hpp"
#include "coupling/result.hpp"

namespace shellback::fidelity {

/// Solves the case in its tier: `estimate`, `auto`, or one of coupling/solve.hpp.
[[nodiscard]] coupling::Result solve_case(const coupling::Case& c,
                                          const coupling::SolveControl& control = {});

}  // namespace shellback::fidelity
