#include "fidelity/rectangular_holes.hpp"

#include <algorithm>

namespace shellback::fidelity {

using namespace coupling;

namespace {

/// Edges over the diameter [-].
struct Rectangle {
  double along, around;
};
constexpr Rectangle kPressed{0.91, 0.81};
constexpr Rectangle kDragged{1.0, 0.71};  ///< of a hole without pressure

bool is_hole(const Supply& s) { return s.kind == SupplyKind::hole; }

}  // namespace

Case with_rectangular_holes(Case c) {
  for (Supply& s : c.supplies) {
    if (!is_hole(s)) continue;
    const Rectangle& shape = s.pressure > 0.0 ? kPressed : kDragged;
    s.kind = SupplyKind::axial_groove;
    s.length = shape.along * s.diameter;
    s.arc = shape.around * s.diameter / c.bearing.radius;
  }
  return c;
}

double hole_bar(const Case& c, const std::string& quantity) {
  constexpr double kFilm = 0.002, kFlow = 0.016;
  if (std::none_of(c.supplies.begin(), c.supplies.end(), is_hole)) return 0.0;
  if (quantity.ends_with("_flow")) return kFlow;
  const bool film =
      quantity.starts_with("friction") || quantity.starts_with("h_min") || quantity == "power_loss";
  return film ? kFilm : 0.0;
}

}  // namespace shellback::fidelity
