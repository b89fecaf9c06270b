#include "fidelity/rectangular_holes.hpp"

#include <algorithm>

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

double hole_bar(const coupling::Case& c, const std::string& quantity) {
  constexpr double kFilm = 0.002;
  constexpr double kFlow = 0.016;
  const bool none = std::none_of(c.supplies.begin(), c.supplies.end(), [](const auto& s) {
    return s.kind == coupling::SupplyKind::hole;
  });
  if (none) return 0.0;
  if (quantity.ends_with("_flow")) return kFlow;
  const bool film =
      quantity.starts_with("friction") || quantity.starts_with("h_min") || quantity == "power_loss";
  return film ? kFilm : 0.0;
}

}  // namespace shellback::fidelity
