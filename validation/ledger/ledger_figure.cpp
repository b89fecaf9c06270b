#include "validation/ledger/ledger_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/pictures/svg_axes.hpp"
#include "app/pictures/svg_lines.hpp"
#include "validation/plot.hpp"

namespace shellback::validation {
namespace {

using namespace app;

constexpr double kWidth = 620.0;
constexpr double kLeft = 74.0;
constexpr double kRight = 14.0;
constexpr double kTop = 62.0;    ///< title and legend
constexpr double kMain = 300.0;  ///< height of the main plot
constexpr double kBetween = 16.0;
constexpr double kDifference = 84.0;  ///< height of the difference
constexpr double kBottom = 42.0;
constexpr double kBandOpacity = 0.16;

struct Mark {
  double x;
  double y;
  double share;  ///< difference over what is allowed; not-a-number: not judged
  Evidence evidence;
};

struct BandPoint {
  double x;
  double low;
  double high;
};

/// What one value of the series column draws.
struct Curve {
  std::vector<Point> line;
  std::vector<BandPoint> band;
  std::vector<Mark> marks;
};

struct Picture {
  std::map<double, Curve> curves;  ///< by the series' value
  std::vector<std::vector<Point>> parts;
};

bool drawn(const EntryReport& report, const Panel& panel, const RowNumbers& point) {
  const FigureSpec& f = report.entry.figure;
  if (!point.contains(f.x) || !holds(panel.where, point)) return false;
  if (f.series.empty() || f.shown.empty()) return true;
  const auto value = point.find(f.series);
  return value != point.end() && std::any_of(f.shown.begin(), f.shown.end(), [&](double v) {
           return std::abs(v - value->second) <= 1e-9 * std::abs(v);
         });
}

double series_of(const FigureSpec& f, const RowNumbers& point) {
  const auto value = f.series.empty() ? point.end() : point.find(f.series);
  return value == point.end() ? 0.0 : value->second;
}

/// Factor from ours to the panel's unit: that of the quantity it shows.
double scale_of(const EntryReport& report, const std::string& ours) {
  for (const QuantityReport& q : report.quantities) {
    if (q.spec.ours == ours) return q.spec.scale;
  }
  return 1.0;
}

void add_lines(const EntryReport& report, const Panel& panel, Picture& picture) {
  const FigureSpec& f = report.entry.figure;
  const double scale = scale_of(report, panel.ours);
  picture.parts.resize(panel.parts.size());
  for (const Evaluated& e : report.points) {
    if (!drawn(report, panel, e.point)) continue;
    const double x = e.point.at(f.x);
    const auto ours = e.values.value.find(panel.ours);
    if (ours != e.values.value.end()) {
      picture.curves[series_of(f, e.point)].line.push_back({x, scale * ours->second});
    }
    for (std::size_t k = 0; k < panel.parts.size(); ++k) {
      const auto part = e.values.value.find(panel.parts[k].ours);
      if (part != e.values.value.end()) picture.parts[k].push_back({x, scale * part->second});
    }
  }
  const auto by_x = [](const auto& a, const auto& b) { return a.x < b.x; };
  for (auto& [value, curve] : picture.curves) {
    std::stable_sort(curve.line.begin(), curve.line.end(), by_x);
  }
  for (auto& part : picture.parts) std::stable_sort(part.begin(), part.end(), by_x);
}

void add_bands(const EntryReport& report, const Panel& panel, Picture& picture) {
  const FigureSpec& f = report.entry.figure;
  const double scale = scale_of(report, panel.ours);
  if (report.bands.empty() || !panel.parts.empty()) return;
  for (std::size_t row = 0; row < report.entry.table->lines().size(); ++row) {
    const RowNumbers& point = report.points[row].point;
    if (!drawn(report, panel, point)) continue;
    const BandWidth band = band_at(report, panel.ours, row);
    if (!std::isfinite(band.low)) continue;
    picture.curves[series_of(f, point)].band.push_back(
        {point.at(f.x), scale * band.low, scale * band.high});
  }
  for (auto& [value, curve] : picture.curves) {
    std::stable_sort(curve.band.begin(), curve.band.end(),
                     [](const BandPoint& a, const BandPoint& b) { return a.x < b.x; });
  }
}

void add_marks(const EntryReport& report, const Panel& panel, Picture& picture) {
  const FigureSpec& f = report.entry.figure;
  if (!panel.parts.empty()) return;  // shown whole in a panel of its own
  for (const QuantityReport& q : report.quantities) {
    if (q.spec.ours != panel.ours) continue;
    for (const RowReport& r : q.rows) {
      const RowNumbers& point = report.points[r.row].point;
      if (!drawn(report, panel, point)) continue;
      const bool judged = r.judgement == Judgement::within || r.judgement == Judgement::outside ||
                          r.judgement == Judgement::documented;
      picture.curves[series_of(f, point)].marks.push_back(
          {point.at(f.x), r.theirs, judged ? r.difference / r.allowed : NAN, q.spec.evidence});
    }
  }
}

struct Scales {
  Scale x;
  Scale y;
  Scale share;
};

Scales scales_of(const EntryReport& report, const Panel& panel, const Picture& picture) {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> share{-1.25, 1.25};
  for (const auto& [value, curve] : picture.curves) {
    for (const Point& p : curve.line) {
      x.push_back(p.x);
      y.push_back(p.y);
    }
    for (const BandPoint& b : curve.band) y.insert(y.end(), {b.low, b.high});
    for (const Mark& m : curve.marks) {
      x.push_back(m.x);
      y.push_back(m.y);
      share.push_back(m.share);
    }
  }
  if (!panel.logarithmic) {
    for (const auto& part : picture.parts) {
      for (const Point& p : part) y.push_back(p.y);
    }
  }
  const FigureSpec& f = report.entry.figure;
  Scale across = make_scale(x, f.x_logarithmic, false, f.x_title);
  if (!f.x_logarithmic && !x.empty()) {  // the rows end where their axis ends
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    const Axis axis = tight_axis(*low, *high, 8, "");
    across = {axis.low, axis.high, false, axis.ticks, f.x_title};
  }
  return {across, make_scale(y, panel.logarithmic, true, panel.title),
          make_scale(share, false, false, "over allowed")};
}

std::vector<Point> placed(const PlotFrame& frame, const std::vector<Point>& line) {
  std::vector<Point> path;
  for (const Point& p : line) {
    if (frame.shows(p.x, p.y)) path.push_back(frame.at(p.x, p.y));
  }
  return path;
}

void draw_band(Svg& svg, const PlotFrame& frame, const Curve& curve, const std::string& colour) {
  std::vector<Point> outline;
  for (const BandPoint& b : curve.band) {
    if (frame.shows(b.x, b.high)) outline.push_back(frame.at(b.x, b.high));
  }
  for (auto b = curve.band.rbegin(); b != curve.band.rend(); ++b) {
    if (frame.shows(b->x, b->low)) outline.push_back(frame.at(b->x, b->low));
  }
  if (outline.size() > 2) svg.shade(line_path(outline) + "Z", colour, kBandOpacity);
}

/// The zone that counts as within, and every judged value.
void draw_differences(Svg& svg, const PlotFrame& frame, const Picture& picture,
                      const Theme& theme) {
  const Box& b = frame.box;
  const double top = frame.at(frame.x.low, 1.0).y;
  const double bottom = frame.at(frame.x.low, -1.0).y;
  svg.shade(line_path({{b.x, top}, {b.right(), top}, {b.right(), bottom}, {b.x, bottom}}) + "Z",
            theme.less, 0.12);
  draw_frame(svg, frame, theme, Labels::both);
  std::size_t k = 0;
  for (const auto& [value, curve] : picture.curves) {
    const std::string& colour = theme.series[k++ % theme.series.size()];
    for (const Mark& m : curve.marks) {
      if (frame.shows(m.x, m.share)) draw_mark(svg, frame.at(m.x, m.share), m.evidence, colour);
    }
  }
}

const char* short_name(Evidence evidence) {
  switch (evidence) {
    case Evidence::measurement:
      return "measured";
    case Evidence::calculation:
      return "published calculation";
    case Evidence::exact:
      return "exact";
    case Evidence::recomputed:
      return "recomputed";
    case Evidence::own:
      return "own, former";
  }
  return "";
}

class Legend {
 public:
  Legend(Svg& svg, Point at, const Theme& theme) : svg_(svg), at_(at), theme_(theme) {}
  void line(const std::string& name, const Stroke& stroke) {
    svg_.line({at_.x, at_.y - 3.5}, {at_.x + 18.0, at_.y - 3.5}, stroke);
    word(name, 23.0);
  }
  void mark(const std::string& name, Evidence evidence) {
    draw_mark(svg_, {at_.x + 5.0, at_.y - 3.5}, evidence, theme_.ink);
    word(name, 14.0);
  }
  void band(const std::string& name, const std::string& colour) {
    svg_.shade(line_path({{at_.x, at_.y - 9.0},
                          {at_.x + 16.0, at_.y - 9.0},
                          {at_.x + 16.0, at_.y + 1.0},
                          {at_.x, at_.y + 1.0}}) +
                   "Z",
               colour, 2.0 * kBandOpacity);
    word(name, 21.0);
  }
  void next_row() { at_ = {kLeft, at_.y + 15.0}; }

 private:
  void word(const std::string& name, double indent) {
    constexpr double kSize = 10.5;
    svg_.text({at_.x + indent, at_.y}, name, {theme_.muted, kSize});
    at_.x += indent + text_width(name, kSize) + 12.0;
  }
  Svg& svg_;
  Point at_;
  const Theme& theme_;
};

void draw_legend(Svg& svg, const EntryReport& report, const Panel& panel, const Picture& picture,
                 const Theme& theme) {
  const FigureSpec& f = report.entry.figure;
  Legend legend(svg, {kLeft, 32.0}, theme);
  std::size_t k = 0;
  for (const auto& [value, curve] : picture.curves) {
    const Stroke stroke{theme.series[k++ % theme.series.size()], 2.2, ""};
    const bool many = picture.curves.size() > 1;
    legend.line(many ? fmt::format("{} {:.4g}", f.series_title, value) : "ours", stroke);
  }
  for (std::size_t part = 0; part < panel.parts.size(); ++part) {
    legend.line(panel.parts[part].title,
                {theme.series[(part + 1) % theme.series.size()], 2.0, "5 3"});
  }
  legend.next_row();
  std::vector<Evidence> kinds;
  for (const auto& [value, curve] : picture.curves) {
    for (const Mark& m : curve.marks) {
      if (std::find(kinds.begin(), kinds.end(), m.evidence) == kinds.end()) {
        kinds.push_back(m.evidence);
      }
    }
  }
  for (const Evidence kind : kinds) legend.mark(short_name(kind), kind);
  const bool banded = std::any_of(picture.curves.begin(), picture.curves.end(),
                                  [](const auto& c) { return !c.second.band.empty(); });
  if (banded) legend.band("unknown inputs, one at a time", theme.series[0]);
}

/// Bands lie under lines, lines under marks.
void draw_main(Svg& svg, const PlotFrame& frame, const Picture& picture, const Theme& theme) {
  const auto colour = [&theme](std::size_t k) { return theme.series[k % theme.series.size()]; };
  svg.begin_clip(frame.box);
  std::size_t k = 0;
  for (const auto& [value, curve] : picture.curves) draw_band(svg, frame, curve, colour(k++));
  for (std::size_t part = 0; part < picture.parts.size(); ++part) {
    svg.stroke(line_path(placed(frame, picture.parts[part])), {colour(part + 1), 2.0, "5 3"});
  }
  k = 0;
  for (const auto& [value, curve] : picture.curves) {
    svg.stroke(line_path(placed(frame, curve.line)), {colour(k++), 1.8, ""});
  }
  svg.end_clip();
  for (const auto& [value, curve] : picture.curves) {
    for (const Mark& m : curve.marks) {
      if (frame.shows(m.x, m.y)) draw_mark(svg, frame.at(m.x, m.y), m.evidence, theme.ink);
    }
  }
}

std::string panel_figure(const EntryReport& report, const Panel& panel) {
  const Theme theme = page_theme();
  Picture picture;
  add_lines(report, panel, picture);
  add_bands(report, panel, picture);
  add_marks(report, panel, picture);
  const bool compared = std::any_of(picture.curves.begin(), picture.curves.end(),
                                    [](const auto& c) { return !c.second.marks.empty(); });
  const Scales scales = scales_of(report, panel, picture);
  const double width = kWidth - kLeft - kRight;
  const double below = kBetween + kDifference;  // without a comparison the main plot takes it
  const double main = compared ? kMain : kMain + below;
  Svg svg(kWidth, kTop + kMain + below + kBottom);
  const PlotFrame frame{{kLeft, kTop, width, main}, scales.x, scales.y};
  svg.text({kLeft, 14.0}, panel.head.empty() ? panel.title : panel.head,
           {theme.ink, 12.5, Anchor::start, true});
  draw_legend(svg, report, panel, picture, theme);
  draw_frame(svg, frame, theme, compared ? Labels::only_y : Labels::both);
  draw_main(svg, frame, picture, theme);
  if (compared) {
    const Box strip{kLeft, kTop + kMain + kBetween, width, kDifference};
    draw_differences(svg, {strip, scales.x, scales.share}, picture, theme);
  }
  return svg.inline_element(report.entry.title + ": " + panel.title);
}

}  // namespace

std::vector<std::string> entry_figures(const EntryReport& report) {
  std::vector<std::string> figures;
  for (const Panel& panel : report.entry.figure.panels) {
    figures.push_back(panel_figure(report, panel));
  }
  return figures;
}

}  // namespace shellback::validation
