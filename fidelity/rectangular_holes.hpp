#pragma once
/// Round holes as rectangles, for coarse grids.
///
/// Which cells of a coarse grid a circle takes jumps from grid to grid, and the oil flow with it.
/// Faces can be put on the edges of a rectangle, so that the solutions on a sequence of grids have
/// a limit that shows. Where the pressure of the supply drives the oil, the flow is that of a disc
/// of equal capacity, which depends on the mean of both edges; where the journal drags the oil
/// along, it is that of the wetted width, and of that alone where the supply has no pressure. In 11
/// random bearings the smallest film on 800 x 100 cells differed by at most 0.2 % from that with
/// the circle, the friction torque by 0.2 %, the side flow by 1.6 %; a square of the same area was
/// off by 0.8, 0.5 and 4.5 % (docs/auto-tier.md).
#include <string>

#include "coupling/case.hpp"

namespace shellback::fidelity {

/// The case with every hole as such a rectangle.
[[nodiscard]] coupling::Case with_rectangular_holes(coupling::Case c);

/// Relative bar of a quantity for the shape of the holes: what was seen in those 11 bearings, of
/// friction, films and oil flows. Zero without holes, and for other quantities, which were not
/// looked at: forces at given positions can change by a per cent [-].
[[nodiscard]] double hole_bar(const coupling::Case& c, const std::string& quantity);

}  // namespace shellback::fidelity
