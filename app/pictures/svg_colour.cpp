#include "app/pictures/svg_colour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/constants.hpp"

namespace shellback::app {
namespace {

/// Linear sRGB from OKLab (L, a, b).
std::array<double, 3> linear_rgb(double L, double a, double b) {
  const double l = std::pow(L + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(L - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(L - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

/// The sRGB transfer curve (IEC 61966-2-1).
double encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// Parabola through the three chromas: at 0, 1/2, 1.
double chroma(const ColourMap& m, double t) {
  return m.chroma_dark * (1 - t) * (1 - 2 * t) + 4 * m.chroma_middle * t * (1 - t) +
         m.chroma_light * t * (2 * t - 1);
}

}  // namespace

std::string colour_at(const ColourMap& map, double t) {
  t = std::clamp(t, 0.0, 1.0);
  const double L = map.dark + t * (map.light - map.dark);
  const double hue = (map.hue_dark + t * (map.hue_light - map.hue_dark)) * kPi / 180.0;
  // Colours a screen cannot show lose chroma, never lightness.
  for (double c = chroma(map, t);; c *= 0.97) {
    const auto rgb = linear_rgb(L, c * std::cos(hue), c * std::sin(hue));
    const auto [low, high] = std::minmax_element(rgb.begin(), rgb.end());
    if ((*low < -1e-3 || *high > 1.001) && c > 1e-3) continue;
    std::array<int, 3> byte{};
    for (int k = 0; k < 3; ++k) {
      byte[k] = static_cast<int>(std::lround(255.0 * encoded(std::clamp(rgb[k], 0.0, 1.0))));
    }
    return fmt::format("#{:02x}{:02x}{:02x}", byte[0], byte[1], byte[2]);
  }
}

}  // namespace shellback::app
