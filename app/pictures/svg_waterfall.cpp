#include "app/pictures/svg_waterfall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_axes.hpp"
#include "app/pictures/svg_lines.hpp"

namespace shellback::app {
namespace {

constexpr double kLabelText = 11.5;        ///< [px]
constexpr double kWaterfallTop = 34.0;     ///< room for the title and the measured label [px]
constexpr double kWaterfallBottom = 40.0;  ///< room for the axis [px]
constexpr double kThickest = 26.0;         ///< bar [px]
constexpr double kBarShare = 0.62;         ///< of a row [-]
constexpr double kSmallChange = 0.15;      ///< below this part of the torque the axis is cut [-]

Axis torque_axis(const std::vector<WaterfallBar>& bars, const std::optional<double>& measured) {
  double low = bars.front().end;
  double high = low;
  for (const auto& bar : bars) {
    low = std::min(low, bar.end);
    high = std::max(high, bar.end);
  }
  if (measured) {
    low = std::min(low, *measured);
    high = std::max(high, *measured);
  }
  const bool cut = low > 0.0 && high - low < kSmallChange * high;
  const double start = cut ? std::max(0.0, low - (high - low)) : std::min(0.0, low);
  return round_axis(
      start, high, 6,
      cut ? "friction torque [N·m] (axis does not begin at 0)" : "friction torque [N·m]");
}

std::string value_text(const WaterfallBar& bar, const bearing::FrictionSplit& split) {
  if (bar.total) return typeset_number(figures(bar.end, 3));
  const double change = bar.end - bar.begin;
  return typeset_number(fmt::format("{} ({:+.1f} %)", signed_change(split, change),
                                    100.0 * change / std::abs(split.from)));
}

const std::string& bar_colour(const WaterfallBar& bar, const Theme& theme) {
  if (bar.total) return theme.total;
  return bar.end > bar.begin ? theme.more : theme.less;
}

/// Value beside a step: on the side where there is room, rather not across the measured line;
/// inside a total, whose bar reaches to the axis.
void draw_value(Svg& svg, const Frame& frame, const WaterfallBar& bar, const std::string& words,
                double y, double measured_x, const Theme& theme) {
  constexpr double kAway = 7.0;  // from the bar [px]
  const double right = frame.at(std::max(bar.begin, bar.end), 0.0).x;
  const double left = frame.at(std::min(bar.begin, bar.end), 0.0).x;
  if (bar.total) {
    return svg.text({right - kAway, y}, words, {theme.paper, kLabelText, Anchor::end, true});
  }
  const double width = text_width(words, kLabelText);
  const auto crossed = [&](double from, double to) { return from < measured_x && measured_x < to; };
  const bool fits = right + kAway + width < frame.box.right();
  const bool right_side =
      fits && (!crossed(right, right + kAway + width) || crossed(left - kAway - width, left));
  svg.text(
      {right_side ? right + kAway : left - kAway, y}, words,
      {theme.ink, kLabelText, right_side ? Anchor::start : Anchor::end, false, false, theme.paper});
}

void draw_measured(Svg& svg, const Frame& frame, double torque, const Theme& theme) {
  const std::string words = "measured " + figures(torque, 3);
  const double x = frame.at(torque, 0.0).x;
  const double top = frame.box.y;
  svg.line({x, top - 5.0}, {x, frame.box.bottom()}, {theme.ink, 1.3, "5 3"});
  const bool at_rim = x + 0.5 * text_width(words, 10.5) > frame.box.right();
  svg.text({at_rim ? x + 4.0 : x, top - 8.0}, words,
           {theme.ink, 10.5, at_rim ? Anchor::end : Anchor::middle});
}

}  // namespace

std::vector<WaterfallBar> waterfall_bars(const bearing::FrictionSplit& split) {
  std::vector<WaterfallBar> bars{{"isothermal at T_eq", 0.0, split.from, true}};
  double level = split.from;
  for (const auto& step : split.steps) {
    bars.push_back({step.name, level, level + step.change, false});
    level += step.change;
  }
  const double largest = std::max(std::abs(split.from), std::abs(split.to));
  if (std::abs(split.to - level) > kNegligibleRest * largest) {
    bars.push_back({"not accounted for", level, split.to, false});
  }
  bars.push_back({"full model", 0.0, split.to, true});
  return bars;
}

void draw_waterfall(Svg& svg, const Box& box, const bearing::FrictionSplit& of_journal,
                    const std::optional<double>& torque, const Theme& theme) {
  const bearing::FrictionSplit split = against_the_motion(of_journal);
  const std::optional<double> measured = torque ? std::optional(std::abs(*torque)) : std::nullopt;
  const auto bars = waterfall_bars(split);
  double label_room = 0.0;
  for (const auto& bar : bars) {
    label_room = std::max(label_room, text_width(bar.name, kLabelText) + 14.0);
  }
  const Axis rows{0.0, static_cast<double>(bars.size()), {}, 0, ""};
  const Frame frame{{box.x + label_room, box.y + kWaterfallTop, box.width - label_room - 12.0,
                     box.height - kWaterfallTop - kWaterfallBottom},
                    torque_axis(bars, measured),
                    rows};
  svg.text({box.x, box.y + 14.0}, "Friction torque: from isothermal to full model",
           {theme.ink, 12.5, Anchor::start, true});
  draw_axes(svg, frame, theme, GridLines::none);
  for (const double tick : frame.x.ticks) {
    svg.line(frame.at(tick, rows.low), frame.at(tick, rows.high), {theme.rule, 1.0, ""});
  }
  const double row = frame.box.height / static_cast<double>(bars.size());
  const double measured_x = measured ? frame.at(*measured, 0.0).x : -1.0;
  if (measured) draw_measured(svg, frame, *measured, theme);
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const auto& bar = bars[k];
    const double y = frame.box.y + row * (static_cast<double>(k) + 0.5);
    const double height = std::min(kBarShare * row, kThickest);
    const double a = frame.at(bar.total ? std::max(0.0, frame.x.low) : bar.begin, 0.0).x;
    const double b = frame.at(bar.end, 0.0).x;
    const std::string words = value_text(bar, split);
    svg.rect({std::min(a, b), y - 0.5 * height, std::max(std::abs(b - a), 1.0), height},
             bar_colour(bar, theme), bar.name + ": " + words + " N·m");
    if (k + 1 < bars.size()) {
      svg.line({b, y + 0.5 * height}, {b, y + row - 0.5 * height}, {theme.muted, 1.0, "2 2"});
    }
    svg.text({frame.box.x - 10.0, y + 4.0}, bar.name,
             {theme.ink, kLabelText, Anchor::end, bar.total});
    draw_value(svg, frame, bar, words, y + 4.0, measured_x, theme);
  }
}

}  // namespace shellback::app
