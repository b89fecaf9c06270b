#pragma once
/// Rings one in the other whose joints neither slip nor open, each at one temperature.
///
/// Thick rings in plane stress under pressures p on their inner radius a and q on their outer b,
///   u(a) = a alpha T + a/E [ p ((b2 + a2)/(b2 - a2) + nu) - q 2 b2/(b2 - a2) ]
///   u(b) = b alpha T + b/E [ p 2 a2/(b2 - a2) - q ((b2 + a2)/(b2 - a2) - nu) ]                 (1)
/// a2, b2: squares; T: above the temperature at which they were fitted without pressure [K]; the
/// bore and the outermost surface are free. Joints give one displacement to both their rings.
/// Source: textbook (Lame).
#include <vector>

#include "solid/material.hpp"

namespace shellback::solid {

struct Ring {
  Material material;
  double outer = 0.0;  ///< radius [m]; its inner one is the outer of the ring before
  double rise = 0.0;   ///< T [K]
};

struct JoinedRings {
  double opening = 0.0;  ///< of the bore [m]
  std::vector<double>
      pressures;  ///< of the joints, from the bore outwards; below zero they pull [Pa]
};

/// `bore`: inner radius of the first ring [m]. Needs one ring and more, of rising radii.
[[nodiscard]] JoinedRings joined_rings(double bore, const std::vector<Ring>& rings);

}  // namespace shellback::solid
