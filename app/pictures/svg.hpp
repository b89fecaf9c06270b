#pragma once
/// A drawing as text: the few SVG elements that our pictures need.
///
/// Coordinates are pixels, x right, y down, as in SVG. All text that comes from outside is
/// escaped. Everything is drawn in a Theme, so that one picture serves both a page that follows
/// the reader's light or dark setting and a stand-alone file with fixed colours.
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace shellback::app {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Box {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
};

/// Colours by purpose; CSS colour values.
struct Theme {
  std::string ink;                    ///< text and axes
  std::string muted;                  ///< secondary text, ticks
  std::string rule;                   ///< grid lines
  std::string paper;                  ///< background
  std::string more;                   ///< a step that adds friction
  std::string less;                   ///< a step that takes friction away
  std::string total;                  ///< the ends of the waterfall
  std::array<std::string, 5> series;  ///< one per tier, the last for a tier shown again
};
[[nodiscard]] Theme page_theme();   ///< CSS variables; the page defines them for light and dark
[[nodiscard]] Theme print_theme();  ///< fixed colours on white

enum class Anchor { start, middle, end };

struct TextStyle {
  std::string fill{};
  double size = 11.0;  ///< [px]
  Anchor anchor = Anchor::start;
  bool bold = false;
  bool upward = false;  ///< turned to read from below
  std::string halo{};   ///< colour of an outline that keeps it readable on a map; empty: none
};

struct Stroke {
  std::string colour{};
  double width = 1.0;  ///< [px]
  std::string dash{};  ///< SVG dash pattern; empty: solid
};

/// `&`, `<`, `>` and both quotes as entities: safe in XML and HTML text and attributes.
[[nodiscard]] std::string escape_markup(std::string_view text);

/// Coordinate with one decimal, without a trailing ".0": keeps pages small.
[[nodiscard]] std::string coordinate(double value);

/// Path data of an open line through `points`.
[[nodiscard]] std::string line_path(const std::vector<Point>& points);

class Svg {
 public:
  Svg(double width, double height) : width_(width), height_(height) {}

  void line(Point a, Point b, const Stroke& stroke);
  /// `tooltip` is shown when the pointer rests on it; empty: none.
  void rect(const Box& box, const std::string& fill, const std::string& tooltip = {});
  void frame(const Box& box, const Stroke& stroke);
  /// Filled path; the even-odd rule, so that inner loops are holes.
  void fill(const std::string& path, const std::string& colour);
  /// The same, see-through: `opacity` from 0 to 1.
  void shade(const std::string& path, const std::string& colour, double opacity);
  void stroke(const std::string& path, const Stroke& stroke);
  void circle(Point centre, double radius, const std::string& fill, const Stroke& stroke);
  void text(Point at, std::string_view words, const TextStyle& style);

  /// What is drawn until end_clip() shows only inside `box`.
  void begin_clip(const Box& box);
  void end_clip();

  /// What is drawn until end_group() belongs together, under this name (class).
  void begin_group(const std::string& name);
  void end_group();

  /// For use inside an HTML page: scales with the column, `label` is read out for it.
  [[nodiscard]] std::string inline_element(const std::string& label) const;
  /// A complete SVG file.
  [[nodiscard]] std::string document(const std::string& label) const;
  [[nodiscard]] double width() const { return width_; }  ///< of the sheet [px]

 private:
  double width_;
  double height_;
  std::string body_;
};

/// Width of a line of text [px], from mean letter widths: exact enough to keep labels apart.
[[nodiscard]] double text_width(std::string_view words, double size);

/// `words`, cut where a line of `width` [px] ends, with an ellipsis then.
[[nodiscard]] std::string fitted_to(std::string_view words, double size, double width);

}  // namespace shellback::app
