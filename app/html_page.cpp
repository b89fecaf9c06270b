#include "app/html_page.hpp"

#include <fmt/format.h>

#include "app/html_style.hpp"
#include "app/html_tables.hpp"
#include "app/labels/command_words.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg.hpp"

namespace shellback::app {

std::string page_head(const bearing::Case& c, const std::string& kind) {
  const std::string title = escape_markup(c.title);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n"
      "<p class=\"kicker\">Shellback {}</p>\n<h1>{}</h1>\n<p class=\"scene\">{}</p>\n",
      title, page_style(), kind, title, escape_markup(describe_case(c, Writing::typeset)));
  if (const std::string changes = describe_changes(c); !changes.empty()) {
    html += "<p class=\"scene\">" + escape_markup(changes) + "</p>\n";
  }
  return html;
}

std::string page_section(const std::string& heading, const std::string& content) {
  return content.empty() ? "" : fmt::format("<h2>{}</h2>\n{}", heading, content);
}

std::string page_foot(const bearing::Case& c) {
  return "<footer>\n<h2>Provenance</h2>\n" + provenance_html(c) +
         "</footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace shellback::app
