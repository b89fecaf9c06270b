#pragma once
/// A made-up but plausible comparison to write out: Ocvirk's pressure, a filled half and a
/// cavitated half, temperatures that rise with the dissipation. Not a solution of anything.
#include "coupling/result.hpp"

namespace shellback::test {

/// 200 x 25 cells, hole at 90 deg, 8 kN downwards; with measured values.
[[nodiscard]] coupling::Case synthetic_case();

/// Isothermal, thd and tehd, split into five steps that add up.
[[nodiscard]] coupling::Comparison synthetic_comparison();

/// The tehd result of it.
[[nodiscard]] coupling::Result synthetic_result();

/// As `result`, ended by the iteration limit.
[[nodiscard]] coupling::Result not_converged(coupling::Result result);

}  // namespace shellback::test
