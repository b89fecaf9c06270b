#pragma once
/// A load cycle in several tiers: picture and page.
#include <string>

#include "bearing/over_time/compare_cycles.hpp"

namespace shellback::app {

/// The sheet (1200 x 700, white): where the difference in friction comes from, and smallest film,
/// friction torque and temperature of all tiers over the cycle.
[[nodiscard]] std::string cycle_comparison_svg(const bearing::Case& c,
                                               const bearing::CycleComparison& comparison);

/// One page, self-contained.
[[nodiscard]] std::string cycle_comparison_html(const bearing::Case& c,
                                                const bearing::CycleComparison& comparison);

}  // namespace shellback::app
