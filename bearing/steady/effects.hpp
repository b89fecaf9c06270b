#pragma once
/// Indicator numbers of the effects, included or left out. Source: methods 7.2.
#include "bearing/steady/solve.hpp"

namespace shellback::bearing {

[[nodiscard]] std::vector<Effect> effects_of(const Solution& s, const Friction& friction,
                                             Tier tier);

}  // namespace shellback::bearing
