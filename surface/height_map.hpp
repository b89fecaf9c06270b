#pragma once
/// Heights of a surface on a regular grid.
///
/// x is the direction of motion, y across it; heights rise out of the solid into the film. A point
/// stands for the cell of one pitch around it. A height that is not a number is a hole.
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shellback::surface {

struct HeightMap {
  int nx = 0;             ///< points along the motion
  int ny = 0;             ///< points across
  double dx = 0.0;        ///< pitch along [m]
  double dy = 0.0;        ///< pitch across [m]
  std::vector<double> z;  ///< height [m], index j * nx + i; NaN: a hole
  double x0 = 0.0;        ///< where the first point stands in what was measured [m]
  double y0 = 0.0;
  bool turned = false;  ///< x and y are exchanged against what was measured

  [[nodiscard]] double at(int i, int j) const { return z[index(i, j)]; }
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
  }
  /// Of a point, as measured: x and y [m].
  [[nodiscard]] std::array<double, 2> place(int i, int j) const {
    const double along = x0 + i * dx, across = y0 + j * dy;
    return turned ? std::array{across, along} : std::array{along, across};
  }
  [[nodiscard]] double length() const { return nx * dx; }  ///< along [m]
  [[nodiscard]] double width() const { return ny * dy; }   ///< across [m]
};

/// The same surface with the two directions exchanged.
[[nodiscard]] inline HeightMap exchanged(const HeightMap& map) {
  HeightMap out{map.ny, map.nx, map.dy,     map.dx, std::vector<double>(map.z.size()),
                map.y0, map.x0, !map.turned};
  for (int j = 0; j < map.ny; ++j) {
    for (int i = 0; i < map.nx; ++i) out.z[out.index(j, i)] = map.at(i, j);
  }
  return out;
}

}  // namespace shellback::surface
