#pragma once
/// The path of the journal within the clearance circle.
#include <vector>

#include "app/pictures/svg_axes.hpp"
#include "bearing/over_time/cycle.hpp"

namespace shellback::app {

/// Where eccentricities lie on the picture.
struct OrbitFrame {
  Point centre;
  double radius = 0.0;  ///< of the clearance circle [px]
  /// Position of the journal over the clearance; X right, Y up.
  [[nodiscard]] Point at(double ex, double ey) const {
    return {centre.x + radius * ex, centre.y - radius * ey};
  }
};

/// Draws into the square on the left of `box`, labels included: clearance circle, path, start,
/// where the bore is no
/// cylinder how far it lets a rigid journal (room_around), round instants with the load there as an
/// arrow (its length over the largest load's). Eccentricity ratios above 1 (elastic bearings) are
/// to scale; a path of a few marks is drawn once more, larger.
OrbitFrame draw_orbit(Svg& svg, const Box& box, const bearing::Case& c,
                      const bearing::CycleResult& cycle, const Theme& theme);

}  // namespace shellback::app
