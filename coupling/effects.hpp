#pragma once
/// Indicator numbers of the effects, included or left out. Source: methods 7.2.
#include "coupling/solve.hpp"

namespace shellback::coupling {

[[nodiscard]] std::vector<Effect> effects_of(const Solution& s, const Friction& friction);

}  // namespace shellback::coupling
