#pragma once
/// A small frame with two logarithmic axes.
#include <string>
#include <vector>

#include "app/pictures/svg.hpp"

namespace shellback::validation {

/// Positive values, placed by their logarithm.
struct LogAxis {
  double low = 1.0;
  double high = 10.0;
  std::vector<double> ticks;  ///< labelled
  std::vector<double> rules;  ///< all powers of ten, for grid lines
};

/// Axis that encloses [low, high] with a little room; ticks at powers of ten, thinned to at most
/// five, and at 2 and 5 times them where less than 1.5 decades are shown.
[[nodiscard]] LogAxis log_axis(double low, double high);

struct LogPanel {
  app::Box box;
  LogAxis x;
  LogAxis y;
  [[nodiscard]] app::Point at(double vx, double vy) const;
};

/// Frame and grid lines; labels at the ticks of x and y where wanted.
void draw_log_panel(app::Svg& svg, const LogPanel& panel, const app::Theme& theme, bool x_labels,
                    bool y_labels);

/// A tick's label: "0.01", "100".
[[nodiscard]] std::string plain_number(double value);

}  // namespace shellback::validation
