/// Makes data/surfaces/generated-longitudinal.txt: a Gaussian surface on a tilted, bent plane, in
/// the layout of Gwyddion's ASCII matrix (docs/surfaces.md). Writes to standard output.
#include <cmath>
#include <cstdio>

#include "surface/gaussian_surface.hpp"

int main() {
  using namespace shellback::surface;
  constexpr double kPitch = 1e-6, kTilt = 5e-3, kCurvature = 200.0;  // [m], [-], [1/m]
  const HeightMap map = gaussian_surface(
      {200, 160, kPitch, kPitch, 0.34e-6, 12e-6, 4e-6, CorrelationShape::smooth, 2026});
  std::printf(
      "# Channel: generated Gaussian surface, no measurement: Rq 0.34 um, correlation\n"
      "# lengths 12 um along x and 4 um across (gamma 3), tilt 5 mrad, curvature 200 1/m;\n"
      "# made by validation/tables/make_rough_map.cpp\n"
      "# Width: 200 um\n# Height: 160 um\n# Value units: nm\n");
  for (int j = map.ny - 1; j >= 0; --j) {
    for (int i = 0; i < map.nx; ++i) {
      const double y = (j - 0.5 * map.ny) * kPitch;
      const double z = map.at(i, j) + kTilt * i * kPitch + 0.5 * kCurvature * y * y;
      std::printf(i == 0 ? "%.0f" : "\t%.0f", 1e9 * z);
    }
    std::printf("\n");
  }
}
