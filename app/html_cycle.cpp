#include "app/html_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/html_page.hpp"
#include "app/html_tables.hpp"
#include "app/labels/cycle_shown.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/pictures/svg_cycle.hpp"
#include "app/pictures/svg_cycle_frames.hpp"
#include "app/pictures/svg_orbit.hpp"

namespace shellback::app {
namespace {

using bearing::CycleResult;

constexpr const char* kPlayer = R"html(
<p class="player"><button type="button">pause</button>
<input type="range" min="0" value="0" aria-label="instant of the cycle"/></p>
<style>
.frame { display: none; } .frame.now { display: inline; }
.player { display: flex; gap: 14px; align-items: center; margin: 8px 0 0; }
.player input { flex: 1; } .player button { font: inherit; width: 5em; }
</style>
<script>
(() => {
  const frames = document.querySelectorAll('.frame');
  const slider = document.querySelector('.player input');
  const button = document.querySelector('.player button');
  const kPause = 110;
  let timer = 0;
  const show = (k) => {
    frames.forEach((frame, i) => frame.classList.toggle('now', i === k));
    slider.value = k;
  };
  const step = () => show((Number(slider.value) + 1) % frames.length);
  const play = (on) => {
    clearInterval(timer);
    timer = on ? setInterval(step, kPause) : 0;
    button.textContent = on ? 'pause' : 'play';
  };
  slider.max = frames.length - 1;
  slider.addEventListener('input', () => { play(false); show(Number(slider.value)); });
  button.addEventListener('click', () => play(timer === 0));
  play(!matchMedia('(prefers-reduced-motion: reduce)').matches);
})();
</script>
)html";

/// What was measured, and how far the value is from it; an empty cell: nothing.
std::string measured_cell(const bearing::Measured& measured, const bearing::Quantity& q,
                          const DisplayUnit& unit) {
  const auto si = measured_value(measured, q);
  if (!si) return "<td></td>";
  return fmt::format("<td class=\"measured\">{} <small>{}</small></td>", figures(unit(*si)),
                     typeset_number(difference(unit, unit(q.value), unit(*si))));
}

}  // namespace

std::string cycle_quantities_html(const bearing::Case& c, const CycleResult& cycle) {
  if (cycle.quantities.empty()) return "";
  const bool physics =
      std::any_of(cycle.quantities.begin(), cycle.quantities.end(),
                  [](const auto& q) { return std::isfinite(q.quantity.error_model); });
  const bool measured = is_measured(c.measured, cycle);
  std::string html = fmt::format(
      "<div class=\"scroll\"><table><thead><tr><th>quantity</th><th>value</th><th>grid</th>"
      "<th>time steps</th>{}<th class=\"unit\">unit</th><th>at [{}]</th>{}</tr></thead><tbody>\n",
      physics ? "<th>physics</th>" : "", typeset_unit(told_unit(cycle)),
      measured ? "<th>measured</th>" : "");
  for (const auto& q : cycle.quantities) {
    const DisplayUnit unit = cycle_unit(q);
    html += fmt::format(
        "<tr data-quantity=\"{}\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td>{}"
        "<td class=\"unit\">{}</td><td>{}</td>{}</tr>\n",
        escape_markup(q.quantity.name), escape_markup(cycle_label(q)),
        typeset_number(figures(unit(q.quantity.value))),
        bar_cell(unit.scale * q.quantity.error_grid), bar_cell(unit.scale * q.quantity.error_time),
        physics ? "<td>" + bar_cell(unit.scale * q.quantity.error_model) + "</td>" : "",
        escape_markup(typeset_unit(unit.unit)),
        std::isfinite(q.at) ? figures(shown_instant(cycle, q.at)) : "",
        measured ? measured_cell(c.measured, q.quantity, unit) : "");
  }
  return html + "</tbody></table></div>\n";
}

std::string cycle_tolerance_html(const bearing::Case& c, const CycleResult& cycle) {
  const bearing::Result result = bearing::as_result(cycle);
  std::string html = cycle.choice ? "<p>" + escape_markup(choice_words(*cycle.choice)) + ".</p>\n"
                                  : missed_html(c, missed_tolerance(c, result));
  if (const std::string open = undetermined_words(result); !open.empty()) {
    html += "<p>" + escape_markup(open) + ".</p>\n";
  }
  return html;
}

std::string cycle_audit_html(const bearing::Case& c, const CycleResult& cycle) {
  return fmt::format(
      "<p>{}.</p>\n<p>Relative imbalances over the cycle: {}. Grid: {}, {} "
      "Newton iterations, {} factorizations, {} s.</p>\n",
      how_it_ran(c, cycle), audit_words(cycle), grid_words(cycle.grid),
      cycle.cost.newton_iterations, cycle.cost.factorizations, figures(cycle.cost.wall_s, 3));
}

std::string cycle_curves_html(const bearing::Case& c, const CycleResult& cycle) {
  if (cycle.instants.empty()) return "";
  const Theme theme = page_theme();
  std::string html = "<div class=\"figures\">\n";
  html += figure_html(kColumnWidth, 600.0, "Path of the journal", "",
                      [&](Svg& svg, const Box& box) { draw_orbit(svg, box, c, cycle, theme); });
  const double height = std::max(600.0, height_of_cycle_curves(cycle));
  Svg svg(kColumnWidth, height);
  draw_cycle_curves(svg, {0.0, 0.0, kColumnWidth, height}, cycle, theme);
  html += "<figure>" + svg.inline_element("Curves over the cycle") + "</figure>\n";
  return html + "</div>\n";
}

std::string cycle_maps_html(const bearing::Case& c, const CycleResult& cycle) {
  std::string html;
  for (const CycleMap which : {CycleMap::pressure, CycleMap::contact, CycleMap::gap,
                               CycleMap::friction, CycleMap::shell, CycleMap::shell_heat}) {
    const auto map = cycle_map(c, cycle, which);
    if (!map) continue;
    html += figure_html(kColumnWidth, 232.0, map->title, "",
                        [&](Svg& svg, const Box& box) { draw_map(svg, box, *map, page_theme()); });
  }
  return figures_html(html);
}

std::string cycle_animation_html(const bearing::Case& c, const CycleResult& cycle) {
  const std::string svg = animation_svg(c, cycle);
  if (svg.empty()) return "";
  return "<figure>" + svg + "<figcaption>Dashed: where the full film ends." +
         (c.supplies.empty() ? "" : " Supply features outlined.") + "</figcaption></figure>\n" +
         kPlayer;
}

}  // namespace shellback::app
