#pragma once
/// Axes with round ticks, and the frame that places values on a picture.
#include <string>
#include <vector>

#include "app/pictures/svg.hpp"

namespace shellback::app {

struct Axis {
  double low = 0.0;
  double high = 1.0;
  std::vector<double> ticks;
  int decimals = 0;   ///< of the tick labels
  std::string title;  ///< with its unit
  bool logarithmic = false;
};

/// Axis that encloses [low, high], ends and ticks on 1, 2 or 5 times a power of ten, with at
/// most `max_ticks` intervals. A vanishing range is widened so that there is something to show.
[[nodiscard]] Axis round_axis(double low, double high, int max_ticks, std::string title);

/// Exactly [low, high] with the round ticks inside.
[[nodiscard]] Axis tight_axis(double low, double high, int max_ticks, std::string title);

/// Equal ratios on equal lengths, exactly [low, high] (both positive), with ticks at 1, 2 and 5
/// times the powers of ten, or fewer if they would crowd.
[[nodiscard]] Axis log_axis(double low, double high, std::string title);

/// Where the value lies on the axis: 0 at its low end, 1 at its high end. On a logarithmic axis
/// the value must be positive.
[[nodiscard]] double share_of(const Axis& axis, double value);

/// 0 to 360 with a tick every 45 (or 90) degrees.
[[nodiscard]] Axis degree_axis(double step = 45.0);

[[nodiscard]] std::string tick_label(const Axis& axis, double value);

/// A box whose x runs along one axis and whose y (upwards) runs along the other.
struct Frame {
  Box box;
  Axis x;
  Axis y;
  [[nodiscard]] Point at(double vx, double vy) const {
    return {box.x + box.width * share_of(x, vx), box.bottom() - box.height * share_of(y, vy)};
  }
};

enum class GridLines { none, horizontal };

/// Ticks, labels and axis titles outside the box, its outline, and optionally grid lines.
void draw_axes(Svg& svg, const Frame& frame, const Theme& theme, GridLines lines);

}  // namespace shellback::app
