#pragma once
/// Indicator numbers: which effects a case asks for, from closed estimates alone.
///
/// Each number has two limits, below the first the effect is negligible, above the second it is
/// important; between them it shows. The limits are those of the solver's theory notes. The
/// estimates are coarse (rigid isothermal film), the numbers therefore orders of magnitude.
#include <vector>

#include "app/derived.hpp"

namespace shellback::app {

/// Indicators of the case; `derived` without its indicators.
[[nodiscard]] std::vector<Indicator> indicators(const coupling::Case& subject,
                                                const Derived& derived);

}  // namespace shellback::app
