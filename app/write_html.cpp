#include "app/write_html.hpp"

#include <fmt/format.h>

#include "app/command_words.hpp"
#include "app/html_figures.hpp"
#include "app/html_style.hpp"
#include "app/html_tables.hpp"
#include "app/quantity_label.hpp"
#include "app/svg.hpp"

namespace shellback::app {
namespace {

std::string section(const char* heading, const std::string& content) {
  return content.empty() ? "" : fmt::format("<h2>{}</h2>\n{}", heading, content);
}

}  // namespace

std::string comparison_html(const bearing::Case& c, const bearing::Comparison& comparison) {
  const std::string title = escape_markup(c.title);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n"
      "<p class=\"kicker\">Shellback {}</p>\n<h1>{}</h1>\n<p class=\"scene\">{}</p>\n",
      title, page_style(), comparison.results.size() > 1 ? "comparison" : "result", title,
      escape_markup(describe_case(c, Writing::typeset)));
  if (const std::string changes = describe_changes(c); !changes.empty()) {
    html += "<p class=\"scene\">" + escape_markup(changes) + "</p>\n";
  }
  html += failures_html(comparison) + verdict_html(c, comparison);
  html += section("Friction difference", waterfall_html(c, comparison));
  html += section("Quantities", quantities_html(c, comparison) + bars_html(c, comparison));
  html += section("Along the bearing", profiles_html(comparison));
  html += section("On the unrolled bearing", maps_html(c, comparison));
  html += section("Into the depth", depth_html(c, comparison));
  html += section("Audit and cost",
                  audit_html(comparison) +
                      "<p class=\"scene\">Audit figures are relative imbalances; – does not apply "
                      "in that tier.</p>\n");
  html += section("Effects", effects_html(comparison));
  html += notes_html(comparison);
  html += "<footer>\n<h2>Provenance</h2>\n" + provenance_html(c) + "</footer>\n";
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace shellback::app
