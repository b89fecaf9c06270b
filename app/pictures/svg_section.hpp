#pragma once
/// Shell and housing temperature in the cross-section at mid-width.
#include <string>

#include "app/pictures/svg.hpp"
#include "bearing/result.hpp"

namespace shellback::app {

/// The ring between the bore and the outermost radius of `fields.r`, in the fixed frame (X right,
/// Y up), with layer boundaries, the sense of rotation and the load. A ring thinner than a
/// quarter of its outer radius is stretched radially, and says so. Needs `fields.T_solid`.
void draw_section(Svg& svg, const Box& box, const bearing::Case& c, const bearing::Result& result,
                  const std::string& title, const Theme& theme);

}  // namespace shellback::app
