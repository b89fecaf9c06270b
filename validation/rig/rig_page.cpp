#include "validation/rig/rig_page.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/html_page.hpp"
#include "app/html_tables.hpp"
#include "app/pictures/svg.hpp"
#include "core/constants.hpp"
#include "validation/rig/rig_bands.hpp"
#include "validation/rig/rig_figures.hpp"
#include "validation/rig/rig_statements.hpp"

namespace shellback::validation {
namespace {

using app::escape_markup;
using app::figures_html;
using app::page_section;

constexpr const char* kStyle = R"css(
.yes { color: var(--accent); font-weight: 600; } .no { color: var(--more); font-weight: 600; }
.unknown { color: var(--muted); } td.left, th.left { text-align: left; white-space: normal; }
.note { border-left: 4px solid var(--total); background: var(--panel); padding: 8px 14px;
  max-width: 96ch; }
)css";

constexpr const char* kIntroduction =
    "<p class=\"note\"><strong>The load is a substitute.</strong> The paper shows the trace of its "
    "dynamic load in a figure that is not available. Here the load is one sine of 80 Hz from 5 % "
    "to "
    "100 % of the published peak (cases/ks-rig-cycle-load.csv). Clearances, supply, temperatures, "
    "groove sizes and the bodies' heat capacity are not published either: they are assumed, and "
    "changed one by one to the ends of their ranges. Measured torques could not be read, so what "
    "the paper says in words is what is checked. Nothing was turned until it was met.</p>\n";

std::string head() {
  return app::page_head(
      {.title = "KS rig: friction of three bearings",
       .scene = {"After Sander, Allmaier, Priebsch, InTech 2016, doi 10.5772/64247, Figures 5 to 7 "
                 "and 15: a test bearing of 47.8 x 17.2 mm and two supports of 54 x 25 mm, each of "
                 "these under half the load; torques added"},
       .kind = "study",
       .style = kStyle});
}

std::string statements_html(const RigStudy& study) {
  std::string html =
      "<div class=\"scroll\"><table>\n<thead><tr><th class=\"left\">the paper says</th>"
      "<th class=\"left\">ours</th><th class=\"left\">met if</th><th>verdict</th></tr></thead>\n"
      "<tbody>\n";
  for (const RigStatement& s : rig_statements(study)) {
    const char* look = s.met == Met::yes ? "yes" : s.met == Met::no ? "no" : "unknown";
    html += fmt::format(
        "<tr><td class=\"left\">{}<small>section {}</small></td><td class=\"left\">{}</td>"
        "<td class=\"left\">{}</td><td><span class=\"{}\">{}</span></td></tr>\n",
        escape_markup(s.words), s.section, escape_markup(s.ours), escape_markup(s.range), look,
        to_string(s.met));
  }
  return html + "</tbody></table></div>\n";
}

/// What an interrupted study has not come to is not "not found".
const char* missing(const RigStudy& study) { return study.interrupted ? "not known" : "not found"; }

std::string cell(const RigStudy& study, double v, int decimals) {
  return std::isfinite(v) ? fmt::format("<td>{:.{}f}</td>", v, decimals)
                          : fmt::format("<td class=\"bad\">{}</td>", missing(study));
}

std::string torque_row(const RigStudy& study, double peak, std::size_t k) {
  const double rpm = study.plan.rpm[k];
  const RigCourse& course = *study.course(peak);
  std::string row = fmt::format("<tr><td>{:.0f} kN, {:.0f} rpm</td>", 1e-3 * peak, rpm);
  for (const RigBearing b : kRigBearings) {
    const bearing::Instant* i = course.at(b, k);
    row += cell(study, i == nullptr ? NAN : i->T_shell_back - kZeroCelsius, 1);
  }
  const auto torque = [&](OilModel oil, double warmer) {
    const RigPoint* p = study.point(peak, rpm, oil, warmer);
    return p == nullptr ? NAN : p->torque();
  };
  for (const OilModel oil : kOilModels) row += cell(study, torque(oil, 0.0), 3);
  row += cell(study, torque(OilModel::full, study.plan.warmer), 3);
  const RigPoint* full = study.point(peak, rpm, OilModel::full);
  const bool good = full != nullptr && full->good();
  row += cell(study, good ? full->cycle[0].torque : NAN, 3);
  row += cell(study, good ? full->cycle[1].torque : NAN, 3);
  row += cell(study, good ? rig_torque(full->cycle[0].asperity, full->cycle[1].asperity) : NAN, 3);
  row += cell(study, course.torque(k), 3) + cell(study, course.torque(course.down_from(k)), 3);
  return row + "</tr>\n";
}

std::string torques_html(const RigStudy& study) {
  std::string html =
      "<div class=\"scroll\"><table>\n<thead><tr><th></th><th>test, back [&deg;C]</th>"
      "<th>support, back [&deg;C]</th><th>eta(T)</th><th>eta(T, p)</th><th>eta(T, p, shear)</th>"
      "<th>3 K warmer</th><th>of it test</th><th>one support</th><th>asperities</th>"
      "<th>heat solved, up</th><th>down</th></tr></thead>\n<tbody>\n";
  for (const double peak : study.plan.peaks) {
    for (std::size_t k = 0; k < study.plan.rpm.size(); ++k) html += torque_row(study, peak, k);
  }
  return html +
         "</tbody></table></div>\n<p class=\"scene\">Torques in N m: mean over the cycle, of the "
         "whole rig where nothing else is said.</p>\n";
}

std::string effects_html(const RigStudy& study) {
  if (!study.plan.bands) return "<p class=\"scene\">Left out by --quick.</p>\n";
  std::string html =
      "<div class=\"scroll\"><table>\n<thead><tr><th class=\"left\">unknown</th>"
      "<th class=\"left\">range</th><th>end</th><th>change of the rig's torque</th></tr></thead>\n"
      "<tbody>\n";
  for (const RigEffect& e : rig_effects(study)) {
    const std::string change =
        e.low > e.high ? missing(study)
                       : fmt::format("{:+.0f} to {:+.0f} %", 100.0 * e.low, 100.0 * e.high);
    html += fmt::format(
        "<tr><td class=\"left\">{}</td><td class=\"left\">{}</td><td>{}</td><td>{}{}</td></tr>\n",
        escape_markup(e.unknown->name), escape_markup(e.unknown->range),
        e.end == 0 ? "low" : "high", change,
        e.missing > 0 ? fmt::format(" ({} points {})", e.missing, missing(study)) : "");
  }
  return html + "</tbody></table></div>\n";
}

std::string starts_html(const RigStudy& study) {
  std::string html =
      "<div class=\"scroll\"><table>\n<thead><tr><th>film [&deg;C]</th><th>surface</th>"
      "<th>breakaway [N m]</th><th>mu times the sum of F R</th><th>full film [s]</th></tr></thead>"
      "\n<tbody>\n";
  for (const RigStart& s : study.starts) {
    html +=
        fmt::format("<tr><td>{:.0f}</td><td>{}</td>{}<td>{:.3f}</td>{}</tr>\n", s.T - kZeroCelsius,
                    s.worn ? "worn" : "new", cell(study, s.series.empty() ? NAN : s.breakaway, 3),
                    s.boundary, cell(study, s.full_film, 2));
  }
  return html + "</tbody></table></div>\n";
}

std::string list(const std::vector<std::string>& lines, const std::string& none) {
  if (lines.empty()) return fmt::format("<p class=\"scene\">{}</p>\n", none);
  std::string html = "<ul>\n";
  for (const std::string& line : lines) html += fmt::format("<li>{}</li>\n", escape_markup(line));
  return html + "</ul>\n";
}

std::string assumed() {
  return list(
      {"load: one sine of 80 Hz from 5 % of the peak, whatever the speed; direction fixed",
       "shaft without bending, mass and tilt: half of the load on each support at every instant",
       "run-in bearings: worn roughness of the paper's Table 3, cylindrical; the worn profile of "
       "the edges is not available",
       "isothermal films as warm as the back of their shell in our run-up (kappa = 1): the paper's "
       "relation and its measured temperatures are not published",
       "bodies: rings of 140 mm (rod, aluminium) and 150 mm (supports, steel), cooled at their "
       "outside; oil supplied at 80 degC throughout, no tank that warms",
       "start and stop: film of 60 degC, isothermal (the table has 40 and 80 degC)"},
      "");
}

}  // namespace

std::string rig_page(const RigStudy& study) {
  std::string html = head() + kIntroduction;
  if (study.interrupted) {
    html += "<p class=\"note\"><strong>Interrupted:</strong> what was finished is shown.</p>\n";
  }
  html += page_section("What the paper states", statements_html(study));
  html += page_section("Friction torque over speed", figures_html(torque_figures(study)));
  html += torques_html(study);
  html += page_section("Run-up and run-down", figures_html(course_figures(study)));
  html += page_section("Film of the test bearing", figures_html(film_figures(study)));
  html += page_section("Start and stop", figures_html(start_figures(study)) + starts_html(study));
  html += page_section("Unknown inputs", effects_html(study));
  html += page_section("Not found", list(rig_failures(study), "Every point was found."));
  html += page_section("Assumed", assumed());
  const bearing::Case c =
      rig_case(RigBearing::test, {study.plan.peaks.back(), 1000.0, study.plan.grid, nullptr, 0});
  html += fmt::format(
      "<footer>\n<h2>Provenance</h2>\n<p>Grid {} x {}, {} threads, {:.0f} s. Every bearing: "
      "cases/ks-rig-cycle.toml, ks-rig-support-bearing.toml, start-stop.toml, "
      "start-stop-support.toml; below, the first, with what the study sets in "
      "it.</p>\n{}</footer>\n</main>\n</body>\n</html>\n",
      study.plan.grid[0], study.plan.grid[1], study.threads, study.wall_s, app::provenance_html(c));
  return html;
}

}  // namespace shellback::validation
