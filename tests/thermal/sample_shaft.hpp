#pragma once
/// A steel shaft for the tests of thermal/shaft_conduction.
#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "core/make_grid.hpp"
#include "thermal/shaft_conduction.hpp"

namespace shellback::thermal::tests {

inline const ShaftBody kSteelShaft{50.0, 80.0, 330.0, 3.6e6};
inline constexpr double kShaftRadius = 0.024, kShaftWidth = 0.02, kShaftOverhang = 0.06;

inline FilmGrid shaft_grid(bool half, double radius = kShaftRadius, double width = kShaftWidth,
                           int nz = 15) {
  return make_grid(radius, width, 40, nz, half, {}, {0.2 * width});
}

inline ShaftConduction shaft_on(const FilmGrid& grid, const ShaftBody& body = kSteelShaft,
                                double overhang = kShaftOverhang) {
  return {shaft_mesh(grid, overhang), grid, body};
}

inline std::vector<double> uneven_flux(int nz) {
  std::vector<double> q(nz);
  for (int j = 0; j < nz; ++j) q[j] = 2e4 * (1.0 + 0.7 * std::sin(1.3 * j));
  return q;
}

/// Mean of cos(k z) over the cells.
inline std::vector<double> cosine(const FilmGrid& grid, double k) {
  std::vector<double> mean;
  for (int j = 0; j < grid.nz; ++j) {
    const double low = grid.z_face[j], high = grid.z_face[j + 1];
    mean.push_back(k > 0.0 ? (std::sin(k * high) - std::sin(k * low)) / (k * (high - low)) : 1.0);
  }
  return mean;
}

}  // namespace shellback::thermal::tests
