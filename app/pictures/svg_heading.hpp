#pragma once
/// What stands along the upper edge of a sheet.
#include "app/pictures/svg.hpp"
#include "bearing/case.hpp"

namespace shellback::app {

/// Title, scene and what was changed on the command line, down to y = 75 px.
void draw_scene(Svg& svg, const bearing::Case& c, const Theme& theme);

/// The same with how it went below the title, down to y = 88 px; `good`: as it should.
void draw_scene(Svg& svg, const bearing::Case& c, const std::string& how_it_went, bool good,
                const Theme& theme);

}  // namespace shellback::app
