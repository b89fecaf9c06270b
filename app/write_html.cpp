#include "app/write_html.hpp"

#include "app/html_figures.hpp"
#include "app/html_page.hpp"
#include "app/html_tables.hpp"

namespace shellback::app {

std::string comparison_html(const bearing::Case& c, const bearing::Comparison& comparison) {
  std::string html = page_head(c, comparison.results.size() > 1 ? "comparison" : "result");
  html += failures_html(comparison) + verdict_html(c, comparison);
  html += page_section("Friction difference", waterfall_html(c, comparison));
  html += page_section("Quantities", quantities_html(c, comparison) + bars_html(c, comparison));
  html += page_section("Along the bearing", profiles_html(comparison));
  html += page_section("On the unrolled bearing", maps_html(c, comparison));
  html += page_section("Into the depth", depth_html(c, comparison));
  html += page_section("Audit and cost",
                       audit_html(comparison) +
                           "<p class=\"scene\">Audit figures are relative imbalances; – does not "
                           "apply in that tier.</p>\n");
  html += page_section("Effects", effects_html(comparison));
  return html + notes_html(comparison) + page_foot(c);
}

}  // namespace shellback::app
