/// Lines of a sweep, four panels.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/pictures/svg_colour.hpp"
#include "app/pictures/svg_lines.hpp"
#include "app/pictures/svg_sweep_parts.hpp"
#include "app/reading/sweep_case.hpp"

namespace shellback::app {

using study::Sweep;

namespace {

constexpr double kRoom = 0.03;  ///< beside the outermost points, of the axis [-]

/// A panel: a quantity and, dashed, another that belongs to it.
struct Panel {
  const char* name;
  const char* title;
  const char* second = "";
  const char* solid_word = "";
  const char* dashed_word = "";
  bool second_may_vanish = false;  ///< it is left out where it is zero throughout
};
constexpr const char* kPower = "power_loss";  ///< only over the speed: else it goes with the torque
constexpr std::array kPanels{
    Panel{"friction_torque", "Friction torque", "friction_torque_asperity", "total",
          "from asperities", true},
    Panel{"h_min", "Smallest film"},
    Panel{"T_film_max", "Temperature", "T_shell_back", "film, largest", "shell back, mean"},
    Panel{kPower, "Power loss"},
    Panel{"p_max", "Largest film pressure"},
    Panel{"eccentricity_ratio", "Eccentricity ratio"},
    Panel{"side_flow", "Side flow"},
};

std::string line_colour(std::size_t k, std::size_t count, const Theme& theme) {
  if (count <= theme.series.size()) return theme.series[k];
  constexpr double kLightest = 0.8;  // beyond, lines fade on white
  return colour_at(kCool, kLightest * static_cast<double>(k) / static_cast<double>(count - 1));
}

/// The quantity's axis: logarithmic where linear would flatten most of the curve.
Axis value_axis(const Panel& panel, const DrawnQuantity& q, const std::string& unit) {
  constexpr double kSteep = 8.0;  // ratio of largest to least
  const std::string title = std::string("[") + unit + "]";
  const bool friction = std::string(panel.name) == "friction_torque";
  if (friction && q.low > 0.0 && q.high > kSteep * q.low) {
    return log_axis(q.low / 1.6, q.highest * 1.2, title);
  }
  const bool hugs = std::string(panel.name).starts_with("T_");
  return round_axis(hugs ? q.lowest : std::min(0.0, q.lowest), q.highest, 6, title);
}

class Panels {
 public:
  Panels(Svg& svg, const std::string& text, const bearing::Case& subject, const Sweep& sweep,
         const Theme& theme)
      : svg_(svg),
        text_(text),
        subject_(subject),
        sweep_(sweep),
        theme_(theme),
        x_(x_axis_of(sweep.axes)),
        lines_(lines_along(sweep, x_)) {}

  void legend(Point at) {
    if (lines_.size() < 2) return;
    constexpr double kMark = 30.0, kBetween = 22.0, kSize = 12.0;  // [px]
    const double each = (svg_.width() - 24.0 - at.x) / static_cast<double>(lines_.size());
    double all = 0.0;
    for (const SweepLine& line : lines_) all += kMark + text_width(line.label, kSize) + kBetween;
    const bool fits = at.x + all < svg_.width();
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const std::string& whole = lines_[k].label;
      const std::string label = fits ? whole : fitted_to(whole, kSize, each - kMark - kBetween);
      svg_.line({at.x, at.y - 4.0}, {at.x + 24.0, at.y - 4.0}, {colour(k), 2.4, ""});
      svg_.text({at.x + kMark, at.y}, label, {theme_.ink, kSize});
      at.x += kMark + text_width(label, kSize) + kBetween;
    }
  }

  void draw(const Box& box, const Panel& panel, DrawnQuantity q) {
    auto second = drawn_quantity(sweep_, panel.second);
    if (second && panel.second_may_vanish && second->low == 0.0 && second->high == 0.0) {
      second.reset();
    }
    if (std::string(panel.name).starts_with("T_") && second) {
      q.low = std::min(q.low, second->low);
      q.high = std::max(q.high, second->high);
      q.lowest = std::min(q.lowest, second->lowest);
      q.highest = std::max(q.highest, second->highest);
    }
    const auto mark = film_mark(panel);
    if (mark) q.highest = std::max(q.highest, *mark);
    LinePlot plot;
    plot.title = panel.title;
    plot.x = drawn_axis(sweep_.axes[x_], kRoom);
    plot.y = value_axis(panel, q, typeset_unit(q.unit.unit));
    add_series(plot, q, "");
    if (second) {
      add_series(plot, *second, "5 4");
      plot.series.push_back({panel.solid_word, {}, {}, theme_.muted, ""});
      plot.series.push_back({panel.dashed_word, {}, {}, theme_.muted, "5 4"});
    }
    const Frame frame = draw_lines(svg_, box, plot, theme_);
    if (mark) draw_film_mark(frame, *mark);
    draw_bars(frame, q);
    draw_points(frame, q);
    draw_measured(frame, q);
    if (second) draw_measured(frame, *second);
  }

 private:
  [[nodiscard]] std::string colour(std::size_t k) const {
    return line_colour(k, lines_.size(), theme_);
  }

  void add_series(LinePlot& plot, const DrawnQuantity& q, const char* dash) const {
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      Series series{"", lines_[k].x, {}, colour(k), dash};
      for (const auto* point : lines_[k].points) {
        const double value = q.at(*point);
        series.y.push_back(plot.y->logarithmic && !(value > 0.0) ? NAN : value);
      }
      plot.series.push_back(std::move(series));
    }
  }

  /// Film of three roughnesses, below which asperities carry load [um].
  [[nodiscard]] std::optional<double> film_mark(const Panel& panel) const {
    constexpr double kLambda = 3.0;
    const double sigma = bearing::combined_roughness(subject_.surfaces);
    const bool varied = std::any_of(  // then each point has its own
        sweep_.axes.begin(), sweep_.axes.end(),
        [](const auto& axis) { return axis.key.starts_with("surfaces"); });
    if (std::string(panel.name) != "h_min" || varied || !(sigma > 0.0)) return std::nullopt;
    return 1e6 * kLambda * sigma;
  }

  void draw_film_mark(const Frame& frame, double film) {
    const Point left = frame.at(frame.x.low, film);
    svg_.line(left, {frame.box.right(), left.y}, {theme_.more, 1.2, "7 4"});
    svg_.text({frame.box.right() - 6.0, left.y + 14.0}, "film = 3 roughnesses",
              {theme_.more, 11.0, Anchor::end, true, false, theme_.paper});
  }

  /// Error bars, where they are long enough to be seen beside a point.
  void draw_bars(const Frame& frame, const DrawnQuantity& q) {
    constexpr double kSeen = 2.5;  // [px]
    svg_.begin_clip(frame.box);
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      for (std::size_t i = 0; i < lines_[k].x.size(); ++i) {
        const double value = q.at(*lines_[k].points[i]);
        const double bar = q.bar(*lines_[k].points[i]);
        if (!std::isfinite(value) || !std::isfinite(bar)) continue;
        if (frame.y.logarithmic && !(value > 0.0)) continue;
        const double least = frame.y.logarithmic ? frame.y.low : value - bar;
        const Point top = frame.at(lines_[k].x[i], value + bar);
        const Point bottom = frame.at(lines_[k].x[i], std::max(value - bar, least));
        if (bottom.y - top.y > 2.0 * kSeen) svg_.line(top, bottom, {colour(k), 0.9, ""});
      }
    }
    svg_.end_clip();
  }

  void draw_points(const Frame& frame, const DrawnQuantity& q) {
    constexpr std::size_t kCrowd = 60;  // points on a line beyond which dots only blur it
    constexpr double kDot = 2.1;        // [px]
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const SweepLine& line = lines_[k];
      for (std::size_t i = 0; i < line.x.size(); ++i) {
        const double value = q.at(*line.points[i]);
        if (std::isfinite(value) && line.x.size() <= kCrowd) {
          svg_.circle(frame.at(line.x[i], value), kDot, colour(k), {colour(k), 0.5, ""});
        } else if (!std::isfinite(value) && line.points[i]->tried() && !line.points[i]->good()) {
          const double x = frame.at(line.x[i], frame.y.high).x;
          draw_cross(svg_, {x, frame.box.bottom() - 8.0 - 10.0 * static_cast<double>(k)},
                     colour(k));
        }
      }
    }
  }

  /// The measured value, if the operating point of the file lies on one of the lines.
  void draw_measured(const Frame& frame, const DrawnQuantity& q) {
    const auto good = std::find_if(sweep_.points.begin(), sweep_.points.end(),
                                   [](const auto& point) { return point.good(); });
    const auto x = value_in_file(text_, sweep_.axes[x_]);
    if (good == sweep_.points.end() || !x || is_changed()) return;
    for (const auto& row : quantity_rows(subject_.measured, {good->result})) {
      if (row.name != q.name || !row.measured) continue;
      for (std::size_t k = 0; k < lines_.size(); ++k) {
        if (!is_of_file(lines_[k])) continue;
        const Point at = frame.at(*x, *row.measured);
        const Box& b = frame.box;
        if (at.x < b.x || at.x > b.right() || at.y < b.y || at.y > b.bottom()) continue;
        svg_.circle(at, 5.0, theme_.paper, {colour(k), 2.2, ""});
        svg_.text({at.x - 9.0, at.y - 7.0}, "measured", {theme_.ink, 11.0, Anchor::end});
      }
    }
  }

  /// Whether the bearing is another than that of the file, but for the model and what is varied.
  [[nodiscard]] bool is_changed() const {
    return std::any_of(subject_.changes.begin(), subject_.changes.end(), [&](const auto& change) {
      const bool varied = std::any_of(sweep_.axes.begin(), sweep_.axes.end(),
                                      [&](const auto& axis) { return axis.key == change.key; });
      return !varied && !change.key.starts_with("model.");
    });
  }

  /// Whether the other axes stand at what the file says on this line.
  [[nodiscard]] bool is_of_file(const SweepLine& line) const {
    constexpr double kSame = 1e-9;  // relative: figures of a decimal number
    std::size_t at = 0;
    for (std::size_t a = 0; a < sweep_.axes.size(); ++a) {
      if (static_cast<int>(a) == x_) continue;
      const int index = line.others[at++];
      if (sweep_.axes[a].numbers.empty()) continue;  // tiers, grids: a measurement is of none
      const auto given = value_in_file(text_, sweep_.axes[a]);
      const double here = sweep_.axes[a].numbers[index];
      if (!given || std::abs(*given - here) > kSame * std::abs(here)) return false;
    }
    return true;
  }

  Svg& svg_;
  const std::string& text_;
  const bearing::Case& subject_;
  const Sweep& sweep_;
  const Theme& theme_;
  int x_;
  std::vector<SweepLine> lines_;
};

}  // namespace

void draw_sweep_lines(Svg& svg, const std::string& text, const bearing::Case& subject,
                      const Sweep& sweep, const Theme& theme) {
  constexpr std::array kBoxes{Box{24.0, 104.0, 576.0, 340.0}, Box{612.0, 104.0, 576.0, 340.0},
                              Box{24.0, 448.0, 576.0, 322.0}, Box{612.0, 448.0, 576.0, 322.0}};
  Panels panels(svg, text, subject, sweep, theme);
  panels.legend({80.0, 94.0});
  std::size_t box = 0;
  const bool over_speed = std::any_of(sweep.axes.begin(), sweep.axes.end(), [](const auto& axis) {
    return axis.key == "operation.speed";
  });
  for (const Panel& panel : kPanels) {
    if (panel.name == kPower && !over_speed) continue;
    const auto q = drawn_quantity(sweep, panel.name);
    if (q && box < kBoxes.size()) panels.draw(kBoxes[box++], panel, *q);
  }
}

}  // namespace shellback::app
