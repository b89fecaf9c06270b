#pragma once
/// A drawing as pixels.
#include <string>

namespace shellback::app {

/// The bytes of a PNG file of an SVG document, `scale` pixels per unit of the drawing (librsvg,
/// cairo; text in the fonts that fontconfig finds). Throws FileError if it cannot be drawn.
[[nodiscard]] std::string png_of(const std::string& svg, double scale = 1.5);

}  // namespace shellback::app
