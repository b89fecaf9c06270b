#pragma once
/// Form and tilt of a measured patch, taken away.
///
///   z_form(x, y) = sum_{a + b <= n} c_ab P_a(u) P_b(v),   u, v = -1 ... 1 over the patch
///
/// P Legendre polynomials, c_ab by least squares over all points that are not holes. Textbook.
#include "surface/height_map.hpp"

namespace shellback::surface {

/// What was taken away.
struct Form {
  int degree = 0;
  double mean = 0.0;            ///< height of the mean plane [m]
  double slope_x = 0.0;         ///< mean slope along the motion [-]
  double slope_y = 0.0;         ///< and across [-]
  double curvature_x = 0.0;     ///< mean curvature along, > 0: a valley [1/m]
  double curvature_y = 0.0;     ///< and across [1/m]
  double peak_to_valley = 0.0;  ///< of the form without its mean plane's tilt [m]
};

struct Levelled {
  HeightMap map;  ///< what is left; its mean is 0 over the points measured
  Form form;
};

inline constexpr int kHighestForm = 8;  ///< beyond, a form is roughness

/// Throws InputError if the degree is outside [0, kHighestForm] or the points measured are too few
/// or lie so that they do not determine the form.
[[nodiscard]] Levelled remove_form(HeightMap map, int degree);

}  // namespace shellback::surface
