#pragma once
/// Gaussian surfaces of a given roughness, correlation and orientation, made of random numbers.
///
/// White noise is smoothed by a kernel that is a product of one along and one across:
///   smooth   exp(-2 ln2 (x/lambda)^2)      R = exp(-ln2 (x/lambda)^2): all moments exist
///   linear   1 within lambda of 0          R = 1 - |x|/(2 lambda): the surfaces of Patir (1978)
/// each way; R falls to a half at lambda. The surface repeats itself at its sides. Textbook.
#include <cstdint>

#include "surface/height_map.hpp"

namespace shellback::surface {

enum class CorrelationShape { smooth, linear };

struct GaussianSurface {
  int nx = 0, ny = 0;
  double dx = 1.0, dy = 1.0;              ///< pitch [m]
  double Rq = 1.0;                        ///< of the ensemble; a patch scatters about it [m]
  double lambda_x = 1.0, lambda_y = 1.0;  ///< correlation lengths along and across [m]
  CorrelationShape shape = CorrelationShape::smooth;
  std::uint64_t seed = 1;
};

/// The same numbers give the same surface on every machine.
[[nodiscard]] HeightMap gaussian_surface(const GaussianSurface& wanted);

}  // namespace shellback::surface
