#pragma once
/// The parts of a load cycle's page. Each function returns HTML with all outside text escaped; an
/// empty string if there is nothing to show.
#include <string>

#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

/// Means and extremes with their bars and instants.
[[nodiscard]] std::string cycle_quantities_html(const bearing::Case& c,
                                                const bearing::CycleResult& cycle);

/// Whether the bars meet model.tolerance, what is missed and what would help.
[[nodiscard]] std::string cycle_tolerance_html(const bearing::Case& c,
                                               const bearing::CycleResult& cycle);

/// How the cycle was run, audit and cost.
[[nodiscard]] std::string cycle_audit_html(const bearing::Case& c,
                                           const bearing::CycleResult& cycle);

/// The path of the journal and the curves over the cycle.
[[nodiscard]] std::string cycle_curves_html(const bearing::Case& c,
                                            const bearing::CycleResult& cycle);

/// Maps of the largest values on the unrolled bearing.
[[nodiscard]] std::string cycle_maps_html(const bearing::Case& c,
                                          const bearing::CycleResult& cycle);

/// The film over the cycle, with a slider; plays by itself unless the reader wants no motion.
[[nodiscard]] std::string cycle_animation_html(const bearing::Case& c,
                                               const bearing::CycleResult& cycle);

}  // namespace shellback::app
