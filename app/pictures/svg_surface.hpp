#pragma once
/// The picture of a measured surface: map, height distribution, contact and factors over the gap.
#include <string>

#include "app/reading/surface_report.hpp"

namespace shellback::app {

[[nodiscard]] std::string surface_svg(const SurfaceReport& report);

}  // namespace shellback::app
