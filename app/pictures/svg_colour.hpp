#pragma once
/// Colour maps with equal steps of perceived lightness.
///
/// A map is a path in OKLCh (lightness, chroma, hue): lightness rises linearly from dark to
/// light, hue turns linearly, chroma bulges in the middle. Equal differences of the value are
/// therefore equal differences of lightness, and the map still reads in grey.
/// Source of the colour space: B. Ottosson, "A perceptual color space for image processing"
/// (2020), matrices as published there (textbook).
#include <string>

namespace shellback::app {

struct ColourMap {
  double dark = 0.0;       ///< OKLab lightness at 0 [-]
  double light = 1.0;      ///< lightness at 1 [-]
  double hue_dark = 0.0;   ///< hue at 0 [deg]
  double hue_light = 0.0;  ///< hue at 1 [deg]
  double chroma_dark = 0.0;
  double chroma_middle = 0.0;
  double chroma_light = 0.0;
};
/// Dark blue over green to pale yellow: pressure, gap, fill.
inline constexpr ColourMap kCool{0.24, 0.95, 285.0, 108.0, 0.075, 0.125, 0.075};
/// Dark violet over red to pale yellow: temperature.
inline constexpr ColourMap kWarm{0.24, 0.95, -65.0, 100.0, 0.080, 0.185, 0.085};

struct ColourScale {
  ColourMap map;
  double low = 0.0;
  double high = 1.0;
};

/// "#rrggbb" at `t` in [0, 1]; values outside take the end's colour, which the colour bar says.
[[nodiscard]] std::string colour_at(const ColourMap& map, double t);

}  // namespace shellback::app
