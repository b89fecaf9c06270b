#include "app/pictures/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shellback::app {
namespace {

constexpr const char* kFont =
    "system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue','DejaVu Sans',Arial,sans-serif";

std::string stroke_attributes(const Stroke& stroke) {
  const std::string dash =
      stroke.dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", stroke.dash);
  return fmt::format("stroke=\"{}\" stroke-width=\"{}\"{}", stroke.colour, coordinate(stroke.width),
                     dash);
}

}  // namespace

Theme page_theme() {
  return {"var(--ink)",   "var(--muted)",
          "var(--rule)",  "var(--paper)",
          "var(--more)",  "var(--less)",
          "var(--total)", {"var(--s0)", "var(--s1)", "var(--s2)", "var(--s3)", "var(--s4)"}};
}

Theme print_theme() {
  return {"#1c2430", "#5b6675", "#dfe3e8", "#ffffff",
          "#c2492f", "#2f7f86", "#46536a", {"#2b6cb0", "#d08a00", "#2f7f86", "#c2392b", "#7a4fa3"}};
}

std::string escape_markup(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:  // XML has no control characters but these
        out += static_cast<unsigned char>(c) >= 0x20U || c == '\t' || c == '\n' ? std::string(1, c)
                                                                                : "\uFFFD";
    }
  }
  return out;
}

std::string coordinate(double value) {
  std::string text = fmt::format("{:.1f}", value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text == "-0" ? "0" : text;
}

std::string line_path(const std::vector<Point>& points) {
  std::string path;
  for (const auto& p : points) {
    path += fmt::format("{}{} {}", path.empty() ? "M" : "L", coordinate(p.x), coordinate(p.y));
  }
  return path;
}

void Svg::line(Point a, Point b, const Stroke& stroke) {
  body_ +=
      fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", coordinate(a.x),
                  coordinate(a.y), coordinate(b.x), coordinate(b.y), stroke_attributes(stroke));
}

void Svg::rect(const Box& box, const std::string& fill, const std::string& tooltip) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"",
                       coordinate(box.x), coordinate(box.y), coordinate(box.width),
                       coordinate(box.height), fill);
  body_ +=
      tooltip.empty() ? "/>\n" : fmt::format("><title>{}</title></rect>\n", escape_markup(tooltip));
}

void Svg::frame(const Box& box, const Stroke& stroke) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" {}/>\n",
                       coordinate(box.x), coordinate(box.y), coordinate(box.width),
                       coordinate(box.height), stroke_attributes(stroke));
}

void Svg::fill(const std::string& path, const std::string& colour) {
  if (path.empty()) return;
  body_ += fmt::format("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\"/>\n", path, colour);
}

void Svg::shade(const std::string& path, const std::string& colour, double opacity) {
  if (path.empty()) return;
  body_ += fmt::format("<path d=\"{}\" fill=\"{}\" fill-opacity=\"{:.2f}\" stroke=\"none\"/>\n",
                       path, colour, opacity);
}

void Svg::stroke(const std::string& path, const Stroke& stroke) {
  if (path.empty()) return;
  body_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", path,
                       stroke_attributes(stroke));
}

void Svg::circle(Point centre, double radius, const std::string& fill, const Stroke& stroke) {
  body_ +=
      fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" {}/>\n", coordinate(centre.x),
                  coordinate(centre.y), coordinate(radius), fill, stroke_attributes(stroke));
}

void Svg::text(Point at, std::string_view words, const TextStyle& style) {
  constexpr std::array anchors{"start", "middle", "end"};
  const std::string x = coordinate(at.x);
  const std::string y = coordinate(at.y);
  std::string extra;
  if (style.bold) extra += " font-weight=\"600\"";
  if (style.upward) extra += fmt::format(" transform=\"rotate(-90 {} {})\"", x, y);
  if (!style.halo.empty()) {
    extra += fmt::format(
        " paint-order=\"stroke\" stroke=\"{}\" stroke-width=\"3\" stroke-linejoin=\"round\"",
        style.halo);
  }
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n", x, y,
      coordinate(style.size), anchors[static_cast<std::size_t>(style.anchor)], style.fill, extra,
      escape_markup(words));
}

// A nested svg element clips by itself; a clipPath would need an id that is unique on the page.
void Svg::begin_clip(const Box& box) {
  const std::string place = fmt::format("{} {} {} {}", coordinate(box.x), coordinate(box.y),
                                        coordinate(box.width), coordinate(box.height));
  body_ += fmt::format(
      "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{}\" overflow=\"hidden\">\n",
      coordinate(box.x), coordinate(box.y), coordinate(box.width), coordinate(box.height), place);
}

void Svg::end_clip() { body_ += "</svg>\n"; }

void Svg::begin_group(const std::string& name) {
  body_ += fmt::format("<g class=\"{}\">\n", escape_markup(name));
}

void Svg::end_group() { body_ += "</g>\n"; }

std::string Svg::inline_element(const std::string& label) const {
  return fmt::format(
      "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\" font-family=\"{}\">\n{}</svg>\n",
      coordinate(width_), coordinate(height_), escape_markup(label), kFont, body_);
}

std::string Svg::document(const std::string& label) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\" font-family=\"{3}\">\n{4}</svg>\n",
      coordinate(width_), coordinate(height_), escape_markup(label), kFont, body_);
}

namespace {

constexpr double kLetter = 0.58;  ///< mean width of a letter over its size [-]

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

}  // namespace

double text_width(std::string_view words, double size) {
  return kLetter * size *
         static_cast<double>(std::count_if(words.begin(), words.end(), begins_letter));
}

std::string fitted_to(std::string_view words, double size, double width) {
  const auto most = static_cast<long>(width / (kLetter * size));
  long letters = 0;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (!begins_letter(words[k]) || ++letters < most || text_width(words, size) <= width) continue;
    return std::string(words.substr(0, k)) + "…";
  }
  return std::string(words);
}

}  // namespace shellback::app
