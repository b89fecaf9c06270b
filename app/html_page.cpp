#include "app/html_page.hpp"

#include <fmt/format.h>

#include "app/html_style.hpp"
#include "app/html_tables.hpp"
#include "app/labels/command_words.hpp"
#include "app/labels/quantity_label.hpp"

namespace shellback::app {

std::string page_head(const PageHead& head) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}{}</style>\n</head>\n<body>\n<main>\n"
      "<p class=\"kicker\">Shellback {}</p>\n<h1>{}</h1>\n",
      escape_markup(head.title), page_style(), head.style, head.kind,
      escape_markup(head.heading.empty() ? head.title : head.heading));
  for (const std::string& line : head.scene) {
    if (!line.empty()) html += "<p class=\"scene\">" + escape_markup(line) + "</p>\n";
  }
  return html;
}

std::string page_head(const bearing::Case& c, const std::string& kind) {
  return page_head({.title = c.title,
                    .scene = {describe_case(c, Writing::typeset), describe_changes(c)},
                    .kind = kind});
}

std::string figure_html(const Svg& svg, const std::string& label, const std::string& caption) {
  std::string html = "<figure>" + svg.inline_element(label);
  if (!caption.empty()) html += "<figcaption>" + escape_markup(caption) + "</figcaption>";
  return html + "</figure>\n";
}

std::string figure_html(double width, double height, const std::string& label,
                        const std::string& caption,
                        const std::function<void(Svg&, const Box&)>& draw) {
  constexpr double kAxisTitle = 8.0;  // of the width for the title of an axis that stands upright
  Svg svg(width, height);
  draw(svg, {kAxisTitle, 0.0, width - kAxisTitle, height});
  return figure_html(svg, label, caption);
}

std::string figures_html(const std::string& figures, const char* kind) {
  return figures.empty() ? "" : fmt::format("<div class=\"{}\">\n{}</div>\n", kind, figures);
}

std::string page_section(const std::string& heading, const std::string& content) {
  return content.empty() ? "" : fmt::format("<h2>{}</h2>\n{}", heading, content);
}

std::string page_foot(const Provenance& origin, const std::string& verbatim) {
  return "<footer>\n<h2>Provenance</h2>\n" + provenance_html(origin, verbatim) +
         "</footer>\n</main>\n</body>\n</html>\n";
}

std::string page_foot(const bearing::Case& c) { return page_foot(provenance(c), c.verbatim); }

}  // namespace shellback::app
