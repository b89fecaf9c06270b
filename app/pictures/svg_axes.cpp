#include "app/pictures/svg_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shellback::app {
namespace {

constexpr double kTick = 4.0;        ///< length of a tick [px]
constexpr double kTickText = 10.5;   ///< size of its label [px]
constexpr double kTitleText = 11.0;  ///< size of an axis title [px]

/// Smallest of 1, 2, 5 times a power of ten that splits `range` into at most n intervals.
double round_step(double range, int n) {
  const double rough = range / n;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= rough * (1.0 - 1e-9)) return m * power;
  }
  return 10.0 * power;
}

/// Same relative width whatever the value: a constant field still gets an axis.
void widen_if_flat(double& low, double& high) {
  const double size = std::max(std::abs(low), std::abs(high));
  if (high - low > 1e-9 * size && high > low) return;
  const double half = size > 0.0 ? 0.05 * size : 0.5;
  low -= half;
  high += half;
}

void add_ticks(Axis& axis, double step) {
  axis.decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  const auto first = static_cast<long>(std::ceil(axis.low / step - 1e-6));
  const auto last = static_cast<long>(std::floor(axis.high / step + 1e-6));
  for (long k = first; k <= last; ++k) axis.ticks.push_back(static_cast<double>(k) * step);
}

}  // namespace

Axis round_axis(double low, double high, int max_ticks, std::string title) {
  widen_if_flat(low, high);
  const double step = round_step(high - low, max_ticks);
  Axis axis{step * std::floor(low / step + 1e-9),
            step * std::ceil(high / step - 1e-9),
            {},
            0,
            std::move(title)};
  add_ticks(axis, step);
  return axis;
}

Axis tight_axis(double low, double high, int max_ticks, std::string title) {
  widen_if_flat(low, high);
  Axis axis{low, high, {}, 0, std::move(title)};
  add_ticks(axis, round_step(high - low, max_ticks));
  return axis;
}

Axis log_axis(double low, double high, std::string title) {
  constexpr double kClose = 1.0;  // decades over which every figure has room
  constexpr double kWide = 3.2;   // decades beyond which only powers of ten have
  Axis axis{low, high, {}, 0, std::move(title), true};
  const double decades = std::log10(high / low);
  const std::vector<double> figures = decades < kClose  ? std::vector<double>{1, 2, 3, 4, 5, 6, 8}
                                      : decades < kWide ? std::vector<double>{1, 2, 5}
                                                        : std::vector<double>{1};
  const int last = static_cast<int>(std::floor(std::log10(high)));
  for (int power = static_cast<int>(std::floor(std::log10(low))); power <= last; ++power) {
    for (const double figure : figures) {
      const double tick = figure * std::pow(10.0, power);
      if (tick >= low * (1.0 - 1e-9) && tick <= high * (1.0 + 1e-9)) axis.ticks.push_back(tick);
    }
  }
  constexpr std::size_t kFewest = 2;  // between figures, a narrow range has none
  if (axis.ticks.size() >= kFewest) return axis;
  axis.ticks = tight_axis(low, high, 6, "").ticks;
  return axis;
}

double share_of(const Axis& axis, double value) {
  if (axis.logarithmic) return std::log(value / axis.low) / std::log(axis.high / axis.low);
  return (value - axis.low) / (axis.high - axis.low);
}

Axis degree_axis(double step) {
  Axis axis{0.0, 360.0, {}, 0, "φ [°]"};
  add_ticks(axis, step);
  return axis;
}

std::string tick_label(const Axis& axis, double value) {
  if (axis.logarithmic) return fmt::format("{:.4g}", value);
  const std::string text = fmt::format("{:.{}f}", value, axis.decimals);
  return text.starts_with('-') && text.find_first_of("123456789") == std::string::npos
             ? text.substr(1)
         : text.starts_with('-') ? "−" + text.substr(1)
                                 : text;
}

void draw_axes(Svg& svg, const Frame& frame, const Theme& theme, GridLines lines) {
  const Box& box = frame.box;
  const Stroke ink{theme.muted, 1.0, ""};
  const TextStyle label{theme.muted, kTickText, Anchor::middle, false, false, ""};
  double free_from = -INFINITY;  // where the label before ends [px]
  for (const double tick : frame.x.ticks) {
    const double x = frame.at(tick, frame.y.low).x;
    svg.line({x, box.bottom()}, {x, box.bottom() + kTick}, ink);
    const std::string text = tick_label(frame.x, tick);
    const double half = 0.5 * text_width(text, kTickText);
    if (x - half < free_from) continue;
    svg.text({x, box.bottom() + kTick + 11.0}, text, label);
    free_from = x + half;
  }
  TextStyle side = label;
  side.anchor = Anchor::end;
  std::size_t widest = 0;
  for (const double tick : frame.y.ticks) {
    const double y = frame.at(frame.x.low, tick).y;
    if (lines == GridLines::horizontal) svg.line({box.x, y}, {box.right(), y}, {theme.rule, 1, ""});
    svg.line({box.x - kTick, y}, {box.x, y}, ink);
    const std::string text = tick_label(frame.y, tick);
    widest = std::max(widest, text.size());
    svg.text({box.x - kTick - 3.0, y + 3.7}, text, side);
  }
  svg.frame(box, ink);
  TextStyle title = label;
  title.size = kTitleText;
  svg.text({box.x + 0.5 * box.width, box.bottom() + 31.0}, frame.x.title, title);
  title.upward = true;
  // Digits are about 0.6 of the size wide.
  const double room =
      kTick + 12.0 + 0.6 * kTickText * static_cast<double>(std::min<std::size_t>(widest, 6));
  svg.text({box.x - room, box.y + 0.5 * box.height}, frame.y.title, title);
}

}  // namespace shellback::app
