#pragma once
/// A bearing under a load cycle from one temperature of its bodies to the periodic state.
#include "bearing/warm_up.hpp"

namespace shellback::bearing {

/// As warm_up says; for cases with a load cycle.
[[nodiscard]] WarmUp warm_up_over_cycles(const Case& c, Tier tier, const WarmUpOptions& options,
                                         const SolveControl& control);

}  // namespace shellback::bearing
