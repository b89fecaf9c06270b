#pragma once
/// A made-up but plausible load cycle to write out: a journal on an ellipse over two turns of a
/// crank. Not a solution of anything.
#include "bearing/over_time/cycle.hpp"

namespace shellback::test {

/// The synthetic case under a load that turns with the cycle.
[[nodiscard]] bearing::Case cycle_case();

/// 145 instants over 720 degrees at 3000 rpm, 24 frames on 60 x 9 cells; isothermal, converged.
[[nodiscard]] bearing::CycleResult synthetic_cycle();

/// The same without a crank, told in time.
[[nodiscard]] bearing::CycleResult timed_cycle();

/// Stopped at the third of its instants.
[[nodiscard]] bearing::CycleResult stopped_cycle();

}  // namespace shellback::test
