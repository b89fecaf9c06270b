#pragma once
/// The shape at rest, (3) of running_in.hpp, without the way there.
#include "bearing/over_time/running_in_states.hpp"

namespace shellback::bearing {

/// Of (3); wear that is less is next to none. In summit roughnesses [-]
inline constexpr double kComplementarity = 1e-6;

/// (3) by its own fixed point: in every cell the depth changes by what the gap lacks to the one at
/// which the contact pressure is the `limit` [Pa]. Adds the shape to the run, which tells why there
/// is none.
void find_worn_in(WornBearing& b, const SolveControl& control, double limit, RunningInRun& run);

}  // namespace shellback::bearing
