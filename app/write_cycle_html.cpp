#include "app/write_cycle_html.hpp"

#include "app/html_cycle.hpp"
#include "app/html_page.hpp"
#include "app/html_tables.hpp"
#include "app/labels/cycle_shown.hpp"

namespace shellback::app {

std::string cycle_html(const bearing::Case& c, const bearing::CycleResult& cycle) {
  bearing::Comparison alone;
  alone.results = {head_of(cycle)};
  std::string html = page_head(c, "load cycle");
  if (!cycle.verdict.good()) {
    html += failure_html(to_string(cycle.tier), alone.results.front(), meaning_of_the_rest(cycle));
  }
  html +=
      page_section("Quantities", cycle_quantities_html(c, cycle) + cycle_tolerance_html(c, cycle));
  html += page_section("The film over the cycle", cycle_animation_html(c, cycle));
  html += page_section("Over the cycle", cycle_curves_html(c, cycle));
  html += page_section("On the unrolled bearing", cycle_maps_html(c, cycle));
  html += page_section("Effects", effects_html(alone));
  html += page_section("Audit and cost", cycle_audit_html(c, cycle));
  return html + notes_html(alone) + page_foot(c);
}

}  // namespace shellback::app
