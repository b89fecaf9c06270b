#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/pictures/svg.hpp"
#include "validation/honesty/coverage.hpp"
#include "validation/honesty/honesty_report.hpp"

namespace shellback::validation {

using namespace app;
using bearing::Tier;

namespace {

constexpr double kLow = 0.03;     ///< bar over error at the left rim [-]
constexpr double kHigh = 1000.0;  ///< at the right rim [-]
constexpr double kText = 12.0;    ///< [px]
constexpr double kAllowed = 0.1;  ///< part of the bars that may miss the truth [-]
constexpr double kLongest = 5.0;  ///< median bar over error that is allowed [-]

/// One panel: cumulative part of the bars over bar/error.
struct CoveragePanel {
  Box box;
  [[nodiscard]] Point at(double ratio, double part) const {
    const double u = std::log(std::clamp(ratio, kLow, kHigh) / kLow) / std::log(kHigh / kLow);
    return {box.x + u * box.width, box.bottom() - part * box.height};
  }
};

std::vector<double> sorted_ratios(const std::vector<BarSample>& samples, BarKind kind, Tier tier) {
  std::vector<double> ratios;
  for (const BarSample& s : samples) {
    if (s.tier != tier || !testable(s, kind)) continue;
    const BarAgainstError b = bar_against_error(s, kind);
    ratios.push_back(b.error > 0.0 ? b.bar / b.error : INFINITY);
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

void draw_frame(Svg& svg, const CoveragePanel& p, const Theme& theme, const std::string& title) {
  const Box& b = p.box;
  const Point one = p.at(1.0, 0.0);
  svg.rect({b.x, b.y, one.x - b.x, b.height}, theme.rule);
  for (const double x : {0.1, 1.0, 5.0, 10.0, 100.0}) {
    const Point foot = p.at(x, 0.0);
    svg.line({foot.x, b.bottom()}, {foot.x, b.bottom() + 4.0}, {theme.muted, 1.0, ""});
    svg.text({foot.x, b.bottom() + 18.0}, fmt::format("{:g}", x),
             {theme.muted, kText, Anchor::middle});
  }
  for (int k = 0; k <= 10; k += 2) {
    const double y = p.at(1.0, 0.1 * k).y;
    svg.line({b.x - 4.0, y}, {b.x, y}, {theme.muted, 1.0, ""});
    svg.text({b.x - 8.0, y + 4.0}, fmt::format("{} %", 10 * k), {theme.muted, kText, Anchor::end});
  }
  svg.frame(b, {theme.muted, 1.0, ""});
  svg.text({b.x + 0.5 * b.width, b.y - 12.0}, title, {theme.ink, 14.0, Anchor::middle, true});
  svg.text({b.x + 0.5 * b.width, b.bottom() + 38.0}, "bar over true error",
           {theme.ink, kText, Anchor::middle});
  svg.text({0.5 * (b.x + one.x), b.y + 20.0}, "bar misses the truth",
           {theme.muted, kText, Anchor::middle});
}

/// Where the curves must pass: below 10 % at 1, above 50 % at 5.
void draw_promise(Svg& svg, const CoveragePanel& p, const Theme& theme) {
  const Stroke dashed{theme.ink, 1.2, "5 4"};
  const Point missed = p.at(1.0, kAllowed);
  const Point median = p.at(kLongest, 0.5);
  svg.line({p.box.x, missed.y}, missed, dashed);
  svg.line(missed, {missed.x, p.box.bottom()}, dashed);
  svg.line(median, {p.box.right(), median.y}, dashed);
  svg.line(median, {median.x, p.box.y}, dashed);
  svg.text({p.box.x + 6.0, missed.y - 6.0}, "at most 10 %", {theme.ink, kText});
  svg.text({p.box.right() - 6.0, median.y + 16.0}, "median at most 5",
           {theme.ink, kText, Anchor::end});
}

constexpr Tier kTiers[] = {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd};

void draw_curves(Svg& svg, const CoveragePanel& p, const Theme& theme,
                 const std::vector<BarSample>& samples, BarKind kind) {
  constexpr std::size_t kMostPoints = 400;  // a curve needs no more
  int shown = 0;
  for (int k = 0; k < 4; ++k) {
    const auto ratios = sorted_ratios(samples, kind, kTiers[k]);
    if (ratios.empty()) continue;
    std::vector<Point> points;
    const std::size_t stride = std::max<std::size_t>(1, ratios.size() / kMostPoints);
    for (std::size_t i = 0; i < ratios.size(); i += stride) {
      points.push_back(
          p.at(ratios[i], static_cast<double>(i + 1) / static_cast<double>(ratios.size())));
    }
    points.push_back(p.at(ratios.back(), 1.0));
    svg.stroke(line_path(points), {theme.series[k], 2.0, ""});
    const double y = p.box.bottom() - 16.0 - 18.0 * (3 - shown++);
    const double x = p.box.right() - 150.0;
    svg.line({x, y - 4.0}, {x + 24.0, y - 4.0}, {theme.series[k], 2.5, ""});
    svg.text({x + 32.0, y}, fmt::format("{} ({})", to_string(kTiers[k]), ratios.size()),
             {theme.ink, kText});
  }
}

/// Below a panel, a line a tier: what holds, how sure that is, what has no truth.
void write_shares(Svg& svg, const CoveragePanel& p, const Theme& theme,
                  const std::vector<BarSample>& samples, BarKind kind) {
  double y = p.box.bottom() + 62.0;
  for (const Tier tier : kTiers) {
    std::vector<BarSample> some;
    for (const BarSample& s : samples) {
      if (s.tier == tier) some.push_back(s);
    }
    const Coverage c = coverage_of(some, kind);
    if (c.count + c.no_truth == 0) continue;
    std::string words = fmt::format("{}: ", to_string(tier));
    words += c.count == 0 ? "none judged"
                          : fmt::format("{:.1f} % [{:.1f}, {:.1f}] hold", 100.0 * c.held,
                                        100.0 * c.interval.low, 100.0 * c.interval.high);
    words += fmt::format(", {:.1f} % without a truth", 100.0 * c.share_without_truth());
    svg.text({p.box.x, y}, words, {theme.ink, kText});
    y += 17.0;
  }
}

}  // namespace

std::string honesty_svg(const HonestyRecord& record) {
  const Theme theme = print_theme();
  Svg svg(1340.0, 500.0);
  const CoveragePanel panels[] = {
      {{60.0, 40.0, 370.0, 330.0}}, {{500.0, 40.0, 370.0, 330.0}}, {{940.0, 40.0, 370.0, 330.0}}};
  const BarKind kinds[] = {BarKind::grid, BarKind::limit, BarKind::total};
  const char* titles[] = {"grid bars against a finer grid", "grid bars against the limit of grids",
                          "grid and model against the full physics"};
  for (int k = 0; k < 3; ++k) {
    draw_frame(svg, panels[k], theme, titles[k]);
    draw_promise(svg, panels[k], theme);
    draw_curves(svg, panels[k], theme, record.samples, kinds[k]);
    write_shares(svg, panels[k], theme, record.samples, kinds[k]);
  }
  svg.text({18.0, 205.0}, "part of the bars that are this long or shorter",
           {theme.ink, kText, Anchor::middle, false, true});
  if (const int cut = record.count(CaseEnd::stopped); cut > 0) {
    svg.text({60.0, 490.0}, fmt::format("stopped before the end: {} cases are missing", cut),
             {theme.ink, kText, Anchor::start});
  }
  return svg.document("How long the error bars are against the true errors");
}

}  // namespace shellback::validation
