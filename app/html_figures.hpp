#pragma once
/// The figures of a comparison page, as inline SVG with captions.
#include <string>

#include "bearing/result.hpp"

namespace shellback::app {

/// The friction waterfall; empty if the split was not computed.
[[nodiscard]] std::string waterfall_html(const bearing::Case& c,
                                         const bearing::Comparison& comparison);

/// Pressure, gap, film and shell temperature at mid-width (beside a groove all round there midway
/// on a land), one curve per result.
[[nodiscard]] std::string profiles_html(const bearing::Comparison& comparison);

/// Maps on the unrolled bearing: pressure, fill ratio and gap of the first and the last result
/// side by side on common scales; temperatures of the last result that has them.
[[nodiscard]] std::string maps_html(const bearing::Case& c, const bearing::Comparison& comparison);

/// Temperature across the film, there likewise, and in the section of shell and housing.
[[nodiscard]] std::string depth_html(const bearing::Case& c, const bearing::Comparison& comparison);

}  // namespace shellback::app
