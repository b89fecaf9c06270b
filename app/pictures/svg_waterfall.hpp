#pragma once
/// The friction difference between two predictions, step by step.
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/svg.hpp"
#include "bearing/result.hpp"

namespace shellback::app {

/// One bar of the waterfall, from `begin` to `end` [N m]. The first and the last begin at 0.
struct WaterfallBar {
  std::string name;
  double begin = 0.0;
  double end = 0.0;
  bool total = false;  ///< an end of the waterfall, not a step
};

/// First bar: `split.from`; then each step from where the one before it ended; a bar "not
/// accounted for" if the steps leave a rest; last bar: `split.to`.
[[nodiscard]] std::vector<WaterfallBar> waterfall_bars(const bearing::FrictionSplit& split);

/// Draws one row per bar into `box`. If all changes are below 15 % of the torque, the axis does
/// not begin at zero, and says so. `measured` [N m] is drawn as a dashed line.
void draw_waterfall(Svg& svg, const Box& box, const bearing::FrictionSplit& split,
                    const std::optional<double>& measured, const Theme& theme);

}  // namespace shellback::app
