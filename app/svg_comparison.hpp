#pragma once
/// One picture that tells a comparison: friction steps, gap, pressure and temperature maps.
#include <string>

#include "coupling/result.hpp"

namespace shellback::app {

/// Writes the picture (1200 x 700, white background) as an SVG file. Throws FileError.
void write_comparison_svg(const std::string& path, const coupling::Case& c,
                          const coupling::Comparison& comparison);

}  // namespace shellback::app
