#pragma once
/// One picture that tells a comparison: friction steps, gap, pressure and temperature maps.
#include <string>

#include "app/pictures/svg.hpp"
#include "bearing/result.hpp"

namespace shellback::app {

/// The sheet of a comparison, its size and its quarters [px].
namespace comparison_sheet {
inline constexpr double kWidth = 1200.0;
inline constexpr double kHeight = 700.0;
inline constexpr Box kTopLeft{24.0, 84.0, 560.0, 312.0};
inline constexpr Box kTopRight{608.0, 84.0, 580.0, 300.0};
inline constexpr Box kBottomLeft{24.0, 404.0, 560.0, 284.0};
inline constexpr Box kBottomRight{608.0, 396.0, 580.0, 292.0};
}  // namespace comparison_sheet

/// The picture (1200 x 700, white background) as an SVG document.
[[nodiscard]] std::string comparison_svg(const bearing::Case& c,
                                         const bearing::Comparison& comparison);

/// Title, scene and what did not converge, along the upper edge of such a sheet.
void draw_heading(Svg& svg, const bearing::Case& c, const bearing::Comparison& comparison,
                  const Theme& theme);

}  // namespace shellback::app
