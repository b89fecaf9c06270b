#pragma once
/// Points of a map that the instrument did not measure.
#include "surface/height_map.hpp"

namespace shellback::surface {

struct Holes {
  int count = 0;
  int i = -1;  ///< the first of them
  int j = -1;
  [[nodiscard]] double share(const HeightMap& map) const {
    return count / (static_cast<double>(map.nx) * map.ny);
  }
};
[[nodiscard]] Holes holes_of(const HeightMap& map);

/// Harmonic interpolation: the heights in the holes obey Laplace's equation in five points on the
/// map's grid, with the measured heights around them; nothing flows over the map's rim. The filled
/// heights lie between those around the hole, without summits of their own. Textbook.
/// Throws InputError if nothing was measured.
[[nodiscard]] HeightMap fill_laplace(HeightMap map);

}  // namespace shellback::surface
