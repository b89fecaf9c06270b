#pragma once
/// One panel of a chart: error of one quantity over wall time, for one scene.
#include "validation/chart/chart.hpp"
#include "validation/chart/log_panel.hpp"

namespace shellback::validation {

/// Title and unit of the errors of a quantity, and what of them is shown. Points beyond stand at
/// the rim with an arrow.
struct RowLook {
  const char* title;
  double unit;       ///< shown per unit of ChartPoint::error
  double low, high;  ///< in that unit
};
[[nodiscard]] const RowLook& row_look(int quantity);

/// Axes that hold the points of all scenes, and of one scene. Estimates, which cost next to
/// nothing, may stand at the left rim.
[[nodiscard]] LogAxis error_axis(const std::vector<ChartScene>& scenes, int quantity);
[[nodiscard]] LogAxis time_axis(const ChartScene& scene);

/// Draws the panel; labels of the axes where wanted.
void draw_chart_panel(app::Svg& svg, const LogPanel& panel, const ChartScene& scene, int quantity,
                      bool x_labels, bool y_labels, const app::Theme& theme);

}  // namespace shellback::validation
