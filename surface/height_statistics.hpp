#pragma once
/// Statistics of the heights over the whole patch.
///
///   Ra = <|z|>,  Rq^2 = <z^2>,  Rsk = <z^3>/Rq^3,  Rku = <z^4>/Rq^4       z from the mean
///
/// Areal means: ISO 25178 writes Sa, Sq, Ssk, Sku. A Gaussian surface has Rsk = 0, Rku = 3.
/// Textbook.
#include "surface/height_map.hpp"

namespace shellback::surface {

struct HeightStatistics {
  double Ra = 0.0;        ///< [m]
  double Rq = 0.0;        ///< [m]
  double skewness = 0.0;  ///< Rsk [-]
  double kurtosis = 0.0;  ///< Rku [-]
  double highest = 0.0;   ///< above the mean [m]
  double lowest = 0.0;    ///< the deepest valley, negative [m]
};

/// Of a map without holes. Throws InputError if all heights are equal.
[[nodiscard]] HeightStatistics height_statistics(const HeightMap& map);

}  // namespace shellback::surface
