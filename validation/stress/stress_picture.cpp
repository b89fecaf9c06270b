#include "validation/stress/stress_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/pictures/svg.hpp"
#include "validation/stress/stress_words.hpp"

namespace shellback::validation {
namespace {

using namespace app;

constexpr double kMargin = 16.0;
constexpr double kTop = 132.0;       ///< title, legend, names of the methods [px]
constexpr double kTierWidth = 76.0;  ///< names of the tiers
constexpr double kCell = 58.0;       ///< a cell of the default
constexpr double kSmall = 10.0;      ///< a cell of another method
constexpr double kBetween = 14.0;    ///< between the methods
constexpr double kReason = 420.0;    ///< room for reasons
constexpr double kLastName = 60.0;   ///< a name longer than its method is wide
constexpr double kLine = 17.0;       ///< a row
constexpr double kTitle = 27.0;      ///< a scene's title
constexpr double kText = 10.5;
constexpr std::size_t kReasonLength = 78;
constexpr std::size_t kLabelLength = 10;

/// Colours after Okabe and Ito, told apart by colour-blind readers, but for the pure red of a wrong
/// refusal; a sign tells them apart in grey.
struct Look {
  StressClass what;
  const char* colour;
  const char* ink;
  const char* sign;
};
constexpr std::array<Look, 12> kLooks{{
    {StressClass::converged, "#bfe3d6", "#1c2430", ""},
    {StressClass::no_steady_state, "#56b4e9", "#1c2430", "∅"},
    {StressClass::refused_input, "#cfd4da", "#1c2430", "–"},
    {StressClass::not_found, "#f0e442", "#1c2430", "?"},
    {StressClass::by_convention, "#cbb7e6", "#1c2430", "c"},
    {StressClass::missed, "#e69f00", "#1c2430", "?!"},
    {StressClass::wrong_refusal, "#d00000", "#ffffff", "∅!"},
    {StressClass::wrong, "#d55e00", "#ffffff", "×"},
    {StressClass::not_a_number, "#cc79a7", "#ffffff", "N"},
    {StressClass::crashed, "#000000", "#ffffff", "!"},
    {StressClass::timed_out, "#7a4fa3", "#ffffff", "∞"},
    {StressClass::not_run, "#ffffff", "#5b6675", ""},
}};
const Look& look_of(StressClass c) { return kLooks[static_cast<std::size_t>(c)]; }

std::size_t widest(const StressMap& map) {
  std::size_t n = 1;
  for (const StressRow& row : map.rows) n = std::max(n, row.scene.steps.size());
  return n;
}

/// The unit that all labels end with, with its blank; empty if they do not.
std::string common_unit(const StressScene& scene) {
  const std::string& first = scene.steps.front().label;
  const std::size_t blank = first.find(' ');
  if (blank == std::string::npos) return "";
  const std::string unit = first.substr(blank);
  for (const StressStep& step : scene.steps) {
    if (!step.label.ends_with(unit)) return "";
  }
  return unit;
}

std::string cut(const std::string& text, std::size_t most) {
  return text.size() <= most ? text : text.substr(0, most - 1) + "…";
}

/// What the labels of a scene's cells differ in: no unit that all have, and of files neither the
/// ending nor the words, up to a dash, that all begin with.
std::vector<std::string> cell_words(const StressScene& scene) {
  static constexpr std::string_view kFile = ".csv";
  const std::string unit = common_unit(scene);
  std::vector<std::string> words;
  bool files = true;
  for (const StressStep& step : scene.steps) {
    files = files && step.label.ends_with(kFile);
    words.push_back(step.label.substr(0, step.label.size() - unit.size()));
  }
  if (!files) return words;
  std::size_t same = words.front().size();
  for (const std::string& w : words) {
    const auto differs =
        std::mismatch(w.begin(), w.end(), words.front().begin(), words.front().end());
    same = std::min(same, static_cast<std::size_t>(differs.first - w.begin()));
  }
  const std::size_t dash = words.front().substr(0, same).rfind('-');
  const std::size_t from = dash == std::string::npos ? 0 : dash + 1;
  for (std::string& w : words) w = w.substr(from, w.size() - kFile.size() - from);
  return words;
}

class Picture {
 public:
  explicit Picture(const StressMap& map);
  [[nodiscard]] std::string draw();

 private:
  void legend();
  void heads();
  void title_of(const StressRow& row, double y);
  void row(const StressRow& row, double y);
  [[nodiscard]] double left_of(std::size_t method) const;
  [[nodiscard]] double reasons() const {
    return kMargin + kTierWidth + static_cast<double>(columns_) * kCell + 8.0;
  }
  [[nodiscard]] double width() const {
    return left_of(stress_methods().size()) + kMargin + kLastName;
  }

  const StressMap& map_;
  std::size_t columns_;
  std::vector<bool> shown_;  ///< methods that were run
  Theme theme_ = print_theme();
  double height_;
  Svg svg_;
};

double height_of(const StressMap& map) {
  double height = kTop + kMargin;
  std::string before;
  for (const StressRow& row : map.rows) {
    height += kLine + (row.scene.name == before ? 0.0 : kTitle);
    before = row.scene.name;
  }
  return height;
}

std::vector<bool> methods_shown(const StressMap& map) {
  std::vector<bool> shown(stress_methods().size(), false);
  for (std::size_t m = 0; m < shown.size(); ++m) {
    for (const StressRow& row : map.rows) {
      for (const StressCell& cell : row.cells[m]) {
        if (cell.result != StressClass::not_run) shown[m] = true;
      }
    }
  }
  return shown;
}

Picture::Picture(const StressMap& map)
    : map_(map),
      columns_(widest(map)),
      shown_(methods_shown(map)),
      height_(height_of(map)),
      svg_(width(), height_) {}

double Picture::left_of(std::size_t method) const {
  if (method == 0) return kMargin + kTierWidth;
  double x = reasons() + kReason;
  for (std::size_t m = 1; m < method; ++m) {
    if (shown_[m]) x += static_cast<double>(columns_) * kSmall + kBetween;
  }
  return x;
}

void Picture::legend() {
  svg_.text({kMargin, 28.0},
            map_.complete ? "Stability map" : "Stability map, stopped before the end",
            {theme_.ink, 19.0, Anchor::start, true});
  svg_.text({kMargin, 48.0},
            "Each scene drives one number from harmless (left) to where a steady film ends; "
            "the value reached stands in the cell.",
            {theme_.muted, 12.0});
  Point at{kMargin, 62.0};
  for (const Look& look : kLooks) {
    if (look.what == StressClass::not_run) continue;
    const std::string words = to_string(look.what);
    const double room = 36.0 + 6.3 * static_cast<double>(words.size());
    if (at.x + room > width()) at = {kMargin, at.y + 18.0};
    svg_.rect({at.x, at.y, 16.0, 14.0}, look.colour);
    svg_.frame({at.x, at.y, 16.0, 14.0}, {theme_.muted, 0.5, ""});
    svg_.text({at.x + 8.0, at.y + 11.0}, look.sign, {look.ink, 11.0, Anchor::middle, true});
    svg_.text({at.x + 21.0, at.y + 11.5}, words, {theme_.ink, 12.0});
    at.x += room;
  }
}

void Picture::heads() {
  const auto& methods = stress_methods();
  svg_.text({left_of(0), kTop - 8.0}, "Shellback as shipped",
            {theme_.ink, 12.0, Anchor::start, true});
  svg_.text({reasons(), kTop - 8.0}, "where and why it first refuses", {theme_.muted, 12.0});
  double level = 0.0;
  for (std::size_t m = 1; m < methods.size(); ++m) {
    if (!shown_[m]) continue;
    svg_.text({left_of(m), kTop - 8.0 - level}, methods[m].title, {theme_.ink, 11.0});
    level = level == 0.0 ? 14.0 : 0.0;  // long names side by side need two lines
  }
}

void Picture::title_of(const StressRow& row, double y) {
  svg_.line({kMargin, y + 3.0}, {width() - kMargin, y + 3.0}, {theme_.rule, 1.0, ""});
  const std::string unit = common_unit(row.scene);
  svg_.text({kMargin, y + 19.0},
            row.scene.title + (unit.empty() ? "" : " [" + unit.substr(1) + "]"),
            {theme_.ink, 12.0, Anchor::start, true});
}

void Picture::row(const StressRow& row, double y) {
  svg_.text({kMargin, y + 12.0}, to_string(row.scene.tier), {theme_.muted, kText + 0.5});
  const std::vector<std::string> words = cell_words(row.scene);
  for (std::size_t m = 0; m < row.cells.size(); ++m) {
    const double size = m == 0 ? kCell : kSmall;
    for (std::size_t k = 0; k < row.cells[m].size(); ++k) {
      const StressCell& cell = row.cells[m][k];
      if (cell.result == StressClass::not_run) continue;
      const Look& look = look_of(cell.result);
      const Box box{left_of(m) + static_cast<double>(k) * size, y, size - 1.0, kLine - 2.0};
      const std::string& label = row.scene.steps[k].label;
      svg_.rect(box, look.colour,
                fmt::format("{}, {}, {}: {}{}{}", full_name(row.scene), stress_methods()[m].title,
                            label, to_string(cell.result), cell.why.empty() ? "" : ": ", cell.why));
      if (m == 0) {
        const std::string sign = look.sign;
        svg_.text({box.x + 0.5 * box.width, y + 11.5},
                  (sign.empty() ? "" : sign + " ") + cut(words[k], kLabelLength),
                  {look.ink, kText - 1.0, Anchor::middle});
      } else if (is_fault(cell.result)) {
        svg_.text({box.x + 0.5 * box.width, y + 11.5}, look.sign,
                  {look.ink, kText - 1.0, Anchor::middle, true});
      }
    }
  }
  svg_.text({reasons(), y + 11.5}, in_short(end_of_row(row), kReasonLength),
            {theme_.muted, kText - 0.5});
}

std::string Picture::draw() {
  svg_.rect({0.0, 0.0, width(), height_}, theme_.paper);
  legend();
  heads();
  double y = kTop;
  std::string before;
  for (const StressRow& r : map_.rows) {
    if (r.scene.name != before) {
      title_of(r, y);
      y += kTitle;
      before = r.scene.name;
    }
    row(r, y);
    y += kLine;
  }
  return svg_.document("Stability map: scenes by methods, how each solve ended");
}

}  // namespace

std::string stress_svg(const StressMap& map) { return Picture(map).draw(); }

}  // namespace shellback::validation
