#include "validation/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/pictures/svg_axes.hpp"

namespace shellback::validation {
namespace {

using namespace app;

constexpr double kTick = 4.0;        ///< [px]
constexpr double kTickText = 10.5;   ///< [px]
constexpr double kTitleText = 11.0;  ///< [px]
constexpr double kMark = 3.6;        ///< half the size of a mark [px]
constexpr int kMostTicks = 6;

/// Ticks at 1, 2, 5 times powers of ten; at the powers alone if there are many.
std::vector<double> logarithmic_ticks(double low, double high) {
  const double decades = std::log10(high / low);
  const int stride = decades > 8.0 ? static_cast<int>(std::ceil(decades / 6.0)) : 1;
  std::vector<double> ticks;
  const int first = static_cast<int>(std::floor(std::log10(low)));
  for (int k = first; std::pow(10.0, k) <= high; ++k) {
    for (const double m : {1.0, 2.0, 5.0}) {
      if (m > 1.0 && decades > 2.6) continue;
      if (decades > 2.6 && (k - first) % stride != 0) continue;
      const double tick = m * std::pow(10.0, k);
      if (tick >= low * (1.0 - 1e-9) && tick <= high * (1.0 + 1e-9)) ticks.push_back(tick);
    }
  }
  return ticks;
}

std::string label_of(double value) {
  std::string text = fmt::format("{:.4g}", std::abs(value) < 1e-300 ? 0.0 : value);
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

}  // namespace

double Scale::at(double value) const {
  if (logarithmic) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

bool PlotFrame::shows(double vx, double vy) const {
  return std::isfinite(vx) && std::isfinite(vy) && (!x.logarithmic || vx > 0.0) &&
         (!y.logarithmic || vy > 0.0);
}

Scale make_scale(const std::vector<double>& values, bool logarithmic, bool from_zero,
                 std::string title) {
  double low = INFINITY;
  double high = -INFINITY;
  for (const double v : values) {
    if (!std::isfinite(v) || (logarithmic && v <= 0.0)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  if (low > high) low = high = 1.0;
  if (logarithmic) {
    const double room = std::max(1.03, std::pow(high / low, 0.03));
    return {low / room, high * room, true, logarithmic_ticks(low / room, high * room),
            std::move(title)};
  }
  if (from_zero && low > 0.0) low = 0.0;
  const Axis axis = round_axis(low, high, kMostTicks, "");
  return {axis.low, axis.high, false, axis.ticks, std::move(title)};
}

void draw_frame(Svg& svg, const PlotFrame& frame, const Theme& theme, Labels labels) {
  const Box& box = frame.box;
  const Stroke ink{theme.muted, 1.0, ""};
  TextStyle text{theme.muted, kTickText, Anchor::middle, false, false, ""};
  for (const double tick : frame.x.ticks) {
    const double x = box.x + box.width * frame.x.at(tick);
    svg.line({x, box.y}, {x, box.bottom()}, {theme.rule, 1.0, ""});
    svg.line({x, box.bottom()}, {x, box.bottom() + kTick}, ink);
    if (labels == Labels::both) svg.text({x, box.bottom() + kTick + 11.0}, label_of(tick), text);
  }
  text.anchor = Anchor::end;
  std::size_t widest = 0;
  for (const double tick : frame.y.ticks) {
    const double y = box.bottom() - box.height * frame.y.at(tick);
    svg.line({box.x, y}, {box.right(), y}, {theme.rule, 1.0, ""});
    svg.line({box.x - kTick, y}, {box.x, y}, ink);
    widest = std::max(widest, label_of(tick).size());
    svg.text({box.x - kTick - 3.0, y + 3.7}, label_of(tick), text);
  }
  svg.frame(box, ink);
  TextStyle title{theme.muted, kTitleText, Anchor::middle, false, false, ""};
  if (labels == Labels::both) {
    svg.text({box.x + 0.5 * box.width, box.bottom() + 31.0}, frame.x.title, title);
  }
  title.upward = true;
  svg.text({box.x - 56.0, box.y + 0.5 * box.height}, frame.y.title, title);
}

void draw_mark(Svg& svg, Point p, Evidence evidence, const std::string& colour) {
  const Stroke line{colour, 1.6, ""};
  switch (evidence) {
    case Evidence::measurement:
      svg.circle(p, kMark, colour, {colour, 1.0, ""});
      break;
    case Evidence::calculation:
      svg.circle(p, kMark, "none", line);
      break;
    case Evidence::exact:
      svg.line({p.x - kMark, p.y}, {p.x + kMark, p.y}, line);
      svg.line({p.x, p.y - kMark}, {p.x, p.y + kMark}, line);
      break;
    case Evidence::recomputed:
      svg.line({p.x - kMark, p.y - kMark}, {p.x + kMark, p.y + kMark}, line);
      svg.line({p.x - kMark, p.y + kMark}, {p.x + kMark, p.y - kMark}, line);
      break;
    case Evidence::own:
      svg.frame({p.x - kMark, p.y - kMark, 2.0 * kMark, 2.0 * kMark}, line);
      break;
  }
}

}  // namespace shellback::validation
