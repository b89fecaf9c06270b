#include "app/pictures/svg_heading.hpp"

#include "app/labels/command_words.hpp"
#include "app/labels/quantity_label.hpp"

namespace shellback::app {
namespace {

constexpr double kHeadingLeft = 24.0;  ///< [px]
constexpr double kHeadingText = 20.0;  ///< [px]
constexpr double kSceneText = 12.5;    ///< [px]
constexpr double kChangeText = 11.5;   ///< [px]

/// Scene and changes, the first line at y [px].
void draw_lines_of_scene(Svg& svg, const bearing::Case& c, double y, const Theme& theme) {
  const auto line = [&](double at, const std::string& words, double size) {
    svg.text({kHeadingLeft, at}, fitted_to(words, size, svg.width() - 2.0 * kHeadingLeft),
             {theme.muted, size});
  };
  line(y, describe_case(c, Writing::typeset), kSceneText);
  if (const std::string changes = describe_changes(c); !changes.empty()) {
    line(y + 17.0, changes, kChangeText);
  }
}

}  // namespace

void draw_scene(Svg& svg, const bearing::Case& c, const Theme& theme) {
  svg.text({kHeadingLeft, 36.0}, c.title, {theme.ink, kHeadingText, Anchor::start, true});
  draw_lines_of_scene(svg, c, 58.0, theme);
}

void draw_scene(Svg& svg, const bearing::Case& c, const std::string& how_it_went, bool good,
                const Theme& theme) {
  svg.text({kHeadingLeft, 30.0}, c.title, {theme.ink, kHeadingText, Anchor::start, true});
  svg.text({kHeadingLeft, 52.0}, how_it_went, {good ? theme.ink : theme.more, kSceneText});
  draw_lines_of_scene(svg, c, 70.0, theme);
}

}  // namespace shellback::app
