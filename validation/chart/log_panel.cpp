#include "validation/chart/log_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"

namespace shellback::validation {

using namespace app;

LogAxis log_axis(double low, double high) {
  EXPECTS(low > 0.0 && high >= low);
  constexpr double kRoom = 0.12;   // beyond the data, in decades
  constexpr double kNarrow = 1.5;  // decades below which 2 and 5 are labelled too
  constexpr int kMostTicks = 5;
  LogAxis axis;
  const double a = std::log10(low) - kRoom;
  const double b = std::log10(high) + kRoom;
  axis.low = std::pow(10.0, a);
  axis.high = std::pow(10.0, b);
  const int first = static_cast<int>(std::ceil(a));
  const int last = static_cast<int>(std::floor(b));
  const int stride = std::max(1, (last - first + kMostTicks) / kMostTicks);
  for (int k = first - 1; k <= last; ++k) {
    const double decade = std::pow(10.0, k);
    if (k >= first) axis.rules.push_back(decade);
    if (k >= first && k % stride == 0) axis.ticks.push_back(decade);
    if (b - a >= kNarrow) continue;
    for (const double m : {2.0, 5.0}) {
      if (m * decade > axis.low && m * decade < axis.high) axis.ticks.push_back(m * decade);
    }
  }
  return axis;
}

Point LogPanel::at(double vx, double vy) const {
  const auto part = [](const LogAxis& axis, double v) {
    return std::log(v / axis.low) / std::log(axis.high / axis.low);
  };
  return {box.x + box.width * part(x, vx), box.bottom() - box.height * part(y, vy)};
}

std::string plain_number(double value) { return fmt::format("{:.6g}", value); }

void draw_log_panel(Svg& svg, const LogPanel& panel, const Theme& theme, bool x_labels,
                    bool y_labels) {
  constexpr double kText = 10.5;
  constexpr double kTick = 4.0;
  const Box& box = panel.box;
  const Stroke rule{theme.rule, 1.0, ""};
  const Stroke ink{theme.muted, 1.0, ""};
  for (const double v : panel.x.rules) {
    const double x = panel.at(v, panel.y.low).x;
    svg.line({x, box.y}, {x, box.bottom()}, rule);
  }
  for (const double v : panel.y.rules) {
    const double y = panel.at(panel.x.low, v).y;
    svg.line({box.x, y}, {box.right(), y}, rule);
  }
  for (const double v : panel.x.ticks) {
    const double x = panel.at(v, panel.y.low).x;
    svg.line({x, box.bottom()}, {x, box.bottom() + kTick}, ink);
    if (x_labels) {
      svg.text({x, box.bottom() + kTick + 11.0}, plain_number(v),
               {theme.muted, kText, Anchor::middle});
    }
  }
  for (const double v : panel.y.ticks) {
    const double y = panel.at(panel.x.low, v).y;
    svg.line({box.x - kTick, y}, {box.x, y}, ink);
    if (y_labels) {
      svg.text({box.x - kTick - 3.0, y + 3.7}, plain_number(v), {theme.muted, kText, Anchor::end});
    }
  }
  svg.frame(box, ink);
}

}  // namespace shellback::validation
