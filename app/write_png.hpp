#pragma once
/// A drawing as pixels.
#include <string>

namespace shellback::app {

/// Renders an SVG document to a PNG file, `scale` pixels per unit of the drawing (librsvg, cairo;
/// text in the fonts that fontconfig finds). Throws FileError if the file cannot be written or the
/// drawing cannot be read.
void write_png(const std::string& path, const std::string& svg, double scale = 1.5);

}  // namespace shellback::app
