#pragma once
/// Tier `estimate` over a load cycle: the journal's path by Booker's mobility
/// (mobility_motion.hpp), one temperature from the heat of a mean cycle in lumps (lumped_heat.hpp).
///
///   e(t + period; T) = e(t; T),   <P>(T) = rho cp <Q> (T - T_supply) + sum of G (T - T_outside)
///   (1)
///
/// <P> mean power of shaft and load, <Q> mean flow out of the edges. Cycle after cycle until the
/// journal comes back to where it was within 1e-4 of the gap that is left there, what is still to
/// come counted; then the next T. Each cycle chooses its steps anew: where two differ by no more
/// than these err, paths begun beside tell what is still to come. An event begins in the steady
/// place of its first row. The path is integrated by CVODE (smooth_motion.hpp, docs/decisions/035).
///
/// Left out, and said: the film's history (oil that lacks because it has not come back: the film is
/// full wherever it closes), supply by place and time, mass and tilt of the journal, deformation.
/// What this cannot know is not in the result: oil in the gap, supply flow, fields.
#include "bearing/over_time/cycle.hpp"

namespace shellback::fidelity {

/// The case has a cycle. Does not throw for lack of convergence: the verdict says so.
[[nodiscard]] bearing::CycleResult estimate_cycle(const bearing::Case& c,
                                                  const bearing::SolveControl& control = {});

}  // namespace shellback::fidelity
