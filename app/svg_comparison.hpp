#pragma once
/// One picture that tells a comparison: friction steps, gap, pressure and temperature maps.
#include <string>

#include "app/svg.hpp"
#include "bearing/result.hpp"

namespace shellback::app {

/// The picture (1200 x 700, white background) as an SVG document.
[[nodiscard]] std::string comparison_svg(const bearing::Case& c,
                                         const bearing::Comparison& comparison);

/// Title, scene and what did not converge, along the upper edge of such a sheet.
void draw_heading(Svg& svg, const bearing::Case& c, const bearing::Comparison& comparison,
                  const Theme& theme);

}  // namespace shellback::app
