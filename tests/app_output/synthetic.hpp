#pragma once
/// A made-up but plausible comparison to write out: Ocvirk's pressure, a filled half and a
/// cavitated half, temperatures that rise with the dissipation. Not a solution of anything.
#include "bearing/result.hpp"

namespace shellback::test {

/// 200 x 25 cells, hole at 90 deg, 8 kN downwards; with measured values.
[[nodiscard]] bearing::Case synthetic_case();

/// Isothermal, thd and tehd, split into five steps that add up.
[[nodiscard]] bearing::Comparison synthetic_comparison();

/// The tehd result of it.
[[nodiscard]] bearing::Result synthetic_result();

/// As `result`, ended by the iteration limit.
[[nodiscard]] bearing::Result not_converged(bearing::Result result);

}  // namespace shellback::test
