#include "app/pictures/svg_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/labels/command_words.hpp"
#include "app/labels/sweep_columns.hpp"
#include "app/pictures/svg_sweep_parts.hpp"
#include "core/contract.hpp"

namespace shellback::app {

using study::Sweep;

namespace {

constexpr double kSweepWidth = 1200.0;  ///< [px]
constexpr double kSweepHeight = 780.0;  ///< [px]
constexpr int kMostLines = 8;           ///< beyond, lines cannot be told apart

/// Whether maps are to be drawn: more lines than can be told apart, over two numeric axes.
bool wants_map(const Sweep& sweep) {
  const int x = x_axis_of(sweep.axes);
  const auto numeric = std::count_if(sweep.axes.begin(), sweep.axes.end(),
                                     [](const auto& axis) { return axis.numbers.size() >= 2; });
  const int lines = static_cast<int>(sweep.points.size()) / sweep.axes[x].size();
  return lines > kMostLines && numeric >= 2;
}

/// Tier and grid of all solved points, where they are the same.
std::string describe_model(const Sweep& sweep) {
  const bearing::Result* first = nullptr;
  bool same_tier = true;
  bool same_grid = true;
  for (const auto& point : sweep.points) {
    if (!point.good()) continue;
    if (first == nullptr) first = &point.result;
    same_tier = same_tier && point.result.tier == first->tier;
    same_grid = same_grid && point.result.grid == first->grid;
  }
  std::string words;
  if (first != nullptr && same_tier) words += fmt::format(", tier {}", to_string(first->tier));
  if (first != nullptr && same_grid && first->grid[0] > 0) {
    words += ", grid " + grid_words(first->grid);
  }
  return words;
}

}  // namespace

void expect_drawable(const std::vector<study::Axis>& axes) {
  if (x_axis_of(axes) >= 0) return;
  throw InputError("--picture",
                   "no axis holds two numbers, so there is nothing to draw over; vary a number "
                   "too, or leave out --picture");
}

std::string sweep_svg(const std::string& text, const bearing::Case& subject, const Sweep& sweep) {
  const Theme theme = print_theme();
  Svg svg(kSweepWidth, kSweepHeight);
  svg.rect({0.0, 0.0, kSweepWidth, kSweepHeight}, theme.paper);
  svg.text({24.0, 36.0}, subject.title, {theme.ink, 20.0, Anchor::start, true});
  std::string words = describe_subject(subject, sweep, Writing::typeset) + describe_model(sweep);
  if (wants_map(sweep)) {
    const std::string left_out = draw_sweep_maps(svg, sweep, theme);
    if (!left_out.empty()) words += "; " + left_out;
  } else {
    draw_sweep_lines(svg, text, subject, sweep, theme);
  }
  svg.text({24.0, 58.0}, words, {theme.muted, 12.5});
  if (const std::string changes = describe_changes(subject); !changes.empty()) {
    svg.text({24.0, 75.0}, fitted_to(changes, 11.5, kSweepWidth - 48.0), {theme.muted, 11.5});
  }
  if (sweep.count_good() < static_cast<int>(sweep.points.size())) {
    svg.text({kSweepWidth - 24.0, 36.0},
             count_words(sweep) + (sweep.count_failed() > 0 ? " (×)" : ""),
             {theme.more, 13.0, Anchor::end, true});
  }
  return svg.document(subject.title);
}

}  // namespace shellback::app
