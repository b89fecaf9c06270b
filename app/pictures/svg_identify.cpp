#include "app/pictures/svg_identify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/labels/command_words.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_lines.hpp"
#include "bearing/quantities.hpp"

namespace shellback::app {
namespace {

constexpr double kIdentifyWidth = 1200.0;  ///< [px]
constexpr double kHead = 100.0;            ///< [px]
constexpr double kPanel = 380.0;           ///< height of a quantity [px]
constexpr double kMost = 5.0;              ///< ratio of x from which on its axis is logarithmic [-]

/// The input along x: the first that differs between points; none: the point's number.
const MeasuredInput* input_along(const MeasuredTable& table) {
  for (const MeasuredInput& input : table.inputs) {
    const auto& n = input.axis.numbers;
    if (*std::min_element(n.begin(), n.end()) < *std::max_element(n.begin(), n.end()))
      return &input;
  }
  return nullptr;
}

/// One curve of points in one panel.
struct ComputedCurve {
  std::string name;
  std::vector<double> x, measured, deviation, start, fitted;
};

class MeasuredPanel {
 public:
  MeasuredPanel(const IdentifyView& v, std::size_t quantity)
      : v_(v), quantity_(quantity), along_(input_along(v.table)) {
    double largest = 0.0;
    for (const auto& p : v.table.points) {
      largest = std::max(largest, std::abs(p.values[quantity].value));
    }
    const std::string& name = v.table.quantities[quantity];
    unit_ = display_unit(name, std::string(bearing::find_quantity(name)->unit), largest);
    for (std::size_t i = 0; i < v.table.points.size(); ++i) add(i);
  }

  void draw(Svg& svg, const Box& box, const Theme& theme) const;

 private:
  void add(std::size_t i);
  [[nodiscard]] Axis x_axis() const;
  [[nodiscard]] Axis y_axis() const;
  void draw_points(Svg& svg, const Frame& frame, const ComputedCurve& curve,
                   const std::string& colour, const Theme& theme) const;

  const IdentifyView& v_;
  std::size_t quantity_;
  const MeasuredInput* along_;
  DisplayUnit unit_;
  std::vector<ComputedCurve> curves_;
};

void MeasuredPanel::add(std::size_t i) {
  const auto& point = v_.table.points[i];
  if (i == 0 || point.curve != v_.table.points[i - 1].curve)
    curves_.push_back({point.curve, {}, {}, {}, {}, {}});
  ComputedCurve& c = curves_.back();
  const auto& p = v_.end.points[i];
  const auto shown = [&](const std::vector<double>& all) {
    return quantity_ < all.size() ? unit_(all[quantity_])
                                  : std::numeric_limits<double>::quiet_NaN();
  };
  c.x.push_back(along_ != nullptr ? along_->axis.numbers[i] : static_cast<double>(i + 1));
  c.measured.push_back(unit_(point.values[quantity_].value));
  c.deviation.push_back(point.values[quantity_].deviation * unit_.scale);
  c.start.push_back(shown(p.start));
  c.fitted.push_back(shown(p.fitted));
}

Axis MeasuredPanel::x_axis() const {
  double low = INFINITY, high = -INFINITY;
  for (const ComputedCurve& c : curves_) {
    for (const double x : c.x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  const std::string title =
      along_ != nullptr ? along_->column + " [" + typeset_unit(along_->axis.unit) + "]" : "point";
  if (low > 0.0 && high > kMost * low) return log_axis(0.95 * low, 1.05 * high, title);
  return round_axis(low, high, 8, title);
}

Axis MeasuredPanel::y_axis() const {
  double low = 0.0, high = -INFINITY;
  bool negative = false;
  double least = INFINITY;
  for (const ComputedCurve& c : curves_) {
    for (const auto* values : {&c.measured, &c.start, &c.fitted}) {
      for (const double y : *values) {
        if (!std::isfinite(y)) continue;
        least = std::min(least, y);
        high = std::max(high, y);
        negative = negative || y < 0.0;
      }
    }
  }
  const bool temperature = unit_.offset != 0.0;  // no zero that means anything
  if (negative || temperature) low = least;
  // Of deviations what is no longer than the values are large: longer ones would flatten all else.
  const double shown_low = 2.0 * std::min(low, 0.0) - std::max(high, 0.0);
  const double shown_high = 2.0 * std::max(high, 0.0) - std::min(low, 0.0);
  for (const ComputedCurve& c : curves_) {
    for (std::size_t k = 0; k < c.x.size(); ++k) {
      if (!std::isfinite(c.measured[k] + c.deviation[k])) continue;
      low = std::min(low, std::max(c.measured[k] - c.deviation[k], shown_low));
      high = std::max(high, std::min(c.measured[k] + c.deviation[k], shown_high));
    }
  }
  return round_axis(low, high, 6, "[" + typeset_unit(unit_.unit) + "]");
}

void MeasuredPanel::draw_points(Svg& svg, const Frame& frame, const ComputedCurve& curve,
                                const std::string& colour, const Theme& theme) const {
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    const Point at = frame.at(curve.x[k], curve.measured[k]);
    if (std::isfinite(curve.deviation[k])) {
      svg.line(frame.at(curve.x[k], curve.measured[k] - curve.deviation[k]),
               frame.at(curve.x[k], curve.measured[k] + curve.deviation[k]), {colour, 1.0, ""});
    }
    const bool used = std::isfinite(curve.start[k]);
    svg.circle(at, 3.5, used ? colour : theme.paper, {used ? theme.paper : theme.more, 1.2, ""});
  }
}

void MeasuredPanel::draw(Svg& svg, const Box& box, const Theme& theme) const {
  LinePlot plot;
  plot.title = quantity_label(v_.table.quantities[quantity_]);
  plot.x = x_axis();
  plot.y = y_axis();
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const ComputedCurve& c = curves_[k];
    const std::string& colour = theme.series[k % theme.series.size()];
    plot.series.push_back(
        {c.name.empty() ? "fitted" : c.name, c.x, c.fitted, colour, "", {}, true});
    plot.series.push_back({k == 0 ? "start" : "", c.x, c.start, colour, "3 4"});
  }
  const Frame frame = draw_lines(svg, box, plot, theme);
  svg.begin_clip(frame.box);
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    draw_points(svg, frame, curves_[k], theme.series[k % theme.series.size()], theme);
  }
  svg.end_clip();
}

/// "b = 312 ± 14"
std::string found_words(const IdentifyView& v) {
  std::string words;
  for (std::size_t k = 0; k < v.keys.size(); ++k) {
    const FittedKey& key = v.keys[k];
    const double deviation = k < v.end.fit.deviation.size() ? v.end.fit.deviation[k] : NAN;
    words +=
        fmt::format("{}{} = {}{}{}{}", k == 0 ? "" : ",  ", key.key.substr(key.key.rfind('.') + 1),
                    v.end.fit.computed() ? figures(v.end.fit.x[k]) : "n/a",
                    std::isfinite(deviation) ? " ± " + figures(deviation, 2) : "",
                    key.unit.empty() ? "" : " ", typeset_unit(key.unit));
  }
  return words;
}

}  // namespace

std::string identify_svg(const IdentifyView& v) {
  const Theme theme = print_theme();
  const auto panels = static_cast<double>(v.table.quantities.size());
  Svg svg(kIdentifyWidth, kHead + panels * kPanel + 20.0);
  svg.rect({0.0, 0.0, kIdentifyWidth, kHead + panels * kPanel + 20.0}, theme.paper);
  svg.text({24.0, 36.0}, v.subject.title, {theme.ink, 20.0, Anchor::start, true});
  const std::string changes = describe_changes(v.subject);
  svg.text(
      {24.0, 58.0},
      fitted_to(
          fmt::format("Identified in tier {} from {} values; measured points, lines computed{}{}",
                      to_string(v.subject.model.tier), v.end.values_used(v.table.points),
                      changes.empty() ? "" : "; ", changes),
          12.5, kIdentifyWidth - 48.0),
      {theme.muted, 12.5});
  const bool sound = complaints(v).empty();
  svg.text({24.0, 80.0}, found_words(v) + (sound ? "" : "  (not to be believed, see the table)"),
           {sound ? theme.ink : theme.more, 12.5});
  for (std::size_t k = 0; k < v.table.quantities.size(); ++k) {
    MeasuredPanel(v, k).draw(
        svg, {40.0, kHead + static_cast<double>(k) * kPanel, kIdentifyWidth - 80.0, kPanel}, theme);
  }
  return svg.document(v.subject.title);
}

}  // namespace shellback::app
