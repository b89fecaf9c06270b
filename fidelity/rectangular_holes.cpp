#include "fidelity/rectangular_holes.hpp"

namespace shellback::fidelity {

coupling::Case with_rectangular_holes(coupling::Case c) {
  for (coupling::Supply& s : c.supplies) {
    if (s.kind != coupling::SupplyKind::hole) continue;
    s.kind = coupling::SupplyKind::axial_groove;
    const bool pressed = s.pressure > 0.0;
    s.length = (pressed ? kHoleWidth : kDraggedWidth) * s.diameter;
    s.arc = (pressed ? kHoleArc : kDraggedArc) * s.diameter / c.bearing.radius;
  }
  return c;
}

}  // namespace shellback::fidelity
