#include "app/html_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "app/labels/indistinct.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/labels/tolerance_words.hpp"
#include "app/pictures/svg.hpp"
#include "app/provenance.hpp"
#include "app/words/effect_words.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"

namespace shellback::app {
namespace {

using bearing::Comparison;
using bearing::Result;

std::string audit_cell(double value) {
  return std::isfinite(value) ? fmt::format("{:.1e}", value) : "–";
}

std::string column_heads(const Comparison& comparison) {
  const auto names = column_names(comparison.results);
  std::string html;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool good = comparison.results[k].verdict.good();
    html += fmt::format("<th{}>{}{}</th>", good ? "" : " class=\"bad\"", escape_markup(names[k]),
                        good ? "" : " (not converged)");
  }
  return html;
}

std::string list_html(const char* heading, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string html = fmt::format("<div><h2>{}</h2><ul>", heading);
  for (const auto& line : lines) html += "<li>" + escape_markup(line) + "</li>";
  return html + "</ul></div>\n";
}

/// What stands under a value: the bars of the grid and of the physics left out, and what the grids
/// lead to.
std::string value_bars(const ShownBars& bars) {
  if (!std::isfinite(bars.grid)) return "";
  std::string html = "<small title=\"grid\">± " + figures(bars.grid, 2);
  if (bars.time > 0.0) html += " ± " + figures(bars.time, 2) + " (time steps)";
  if (std::isfinite(bars.model)) html += " ± " + figures(bars.model, 2) + " (model)";
  if (std::isfinite(bars.limit)) html += " → " + figures(bars.limit) + " (extrapolated)";
  return html + "</small>";
}

std::string split_sentences(const Comparison& comparison) {
  const auto split = against_the_motion(comparison.split);
  if (split.steps.empty()) return "";
  const auto largest = std::max_element(
      split.steps.begin(), split.steps.end(),
      [](const auto& a, const auto& b) { return std::abs(a.change) < std::abs(b.change); });
  std::string html = fmt::format(
      "<p>Isothermal at the equivalent temperature: <b>{} N·m</b>; full model: <b>{} N·m</b>. "
      "The difference is <b>{}</b> of the isothermal torque.</p>",
      figures(split.from), figures(split.to), typeset_number(difference({}, split.to, split.from)));
  html +=
      fmt::format("<p>Largest cause of the difference: {} ({} N·m).", escape_markup(largest->name),
                  typeset_number(signed_change(split, largest->change)));
  std::string calibration = calibration_words(comparison, Writing::typeset);
  calibration.front() = static_cast<char>(std::toupper(calibration.front()));
  return html + " " + escape_markup(calibration) + ".</p>";
}

std::string measured_sentence(const bearing::Case& c, const Comparison& comparison) {
  if (!c.measured.friction_torque) return "";
  std::string html = fmt::format("<p>Measured friction torque: <b>{} N·m</b>",
                                 figures(*c.measured.friction_torque));
  const auto names = column_names(comparison.results);
  for (const auto& row : quantity_rows(c.measured, comparison.results)) {
    if (row.name != "friction_torque" || !row.measured) continue;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (!row.values[k]) continue;
      html += fmt::format("; {}{} {}", escape_markup(names[k]),
                          comparison.results[k].verdict.good() ? "" : " (not converged)",
                          typeset_number(difference(row.unit, *row.values[k], *row.measured)));
    }
  }
  return html + ".</p>";
}

}  // namespace

std::string bar_cell(double bar) {
  return std::isfinite(bar) ? "± " + figures(std::abs(bar), 2) : "";
}

std::string failure_html(const std::string& heading, const EndingWords& words,
                         const std::string& meaning) {
  std::string html =
      fmt::format("<section class=\"failed\"><strong>{}</strong><dl>", escape_markup(heading));
  for (const auto& [term, said] :
       {std::pair{"reason", words.reason}, std::pair{"place", words.place},
        std::pair{"cure", words.cure}}) {
    if (said.empty()) continue;
    html += fmt::format("<dt>{}</dt><dd>{}</dd>", term, escape_markup(said));
  }
  return html + "</dl>" + escape_markup(meaning) + "</section>\n";
}

std::string failure_html(const std::string& name, const Result& result,
                         const std::string& meaning) {
  return failure_html(name + ": " + status_line(result), words_of(result.verdict), meaning);
}

std::string failures_html(const Comparison& comparison) {
  const auto names = column_names(comparison.results);
  std::string html;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Result& result = comparison.results[k];
    if (result.verdict.good()) continue;
    html += failure_html(names[k], result,
                         "Its numbers and fields are those of the last iterate, not a result.");
  }
  return html;
}

std::string verdict_html(const bearing::Case& c, const Comparison& comparison) {
  const std::string sentences = split_sentences(comparison) + measured_sentence(c, comparison);
  const auto good = [](const Result& r) { return r.verdict.good(); };
  const bool all = std::all_of(comparison.results.begin(), comparison.results.end(), good);
  const auto count = comparison.results.size();
  const std::string state =
      !all ? "<p>Not every result converged; see above.</p>"
           : fmt::format("<p>{} converged.</p>",
                         count == 1 ? "The result" : fmt::format("All {} results", count));
  return "<section class=\"verdict\">" + sentences + state + "</section>\n";
}

std::string quantities_html(const bearing::Case& c, const Comparison& comparison) {
  const auto rows = quantity_rows(c.measured, comparison.results);
  const bool with_measured =
      std::any_of(rows.begin(), rows.end(), [](const auto& r) { return r.measured.has_value(); });
  std::string html = "<div class=\"scroll\"><table><thead><tr><th>quantity</th>" +
                     column_heads(comparison) + "<th class=\"unit\">unit</th>" +
                     (with_measured ? "<th>measured</th>" : "") + "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    html += fmt::format("<tr data-quantity=\"{}\"><td>{}</td>", escape_markup(row.name),
                        escape_markup(row.label));
    for (std::size_t k = 0; k < row.values.size(); ++k) {
      const auto& value = row.values[k];
      html += "<td>" + (value ? typeset_number(figures(*value)) : "") + value_bars(row.bars[k]);
      if (value && row.measured) {
        html +=
            "<small>" + typeset_number(difference(row.unit, *value, *row.measured)) + "</small>";
      }
      html += "</td>";
    }
    html += "<td class=\"unit\">" + escape_markup(typeset_unit(row.unit.unit)) + "</td>";
    if (with_measured) {
      html += "<td class=\"measured\">" + (row.measured ? figures(*row.measured) : "") + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string bars_html(const bearing::Case& c, const Comparison& comparison) {
  std::string html;
  const auto open = indistinct_words(comparison);
  if (!open.empty()) {
    html += "<p>Cannot be told apart on this grid (their difference is within its bars):</p><ul>";
    for (const std::string& line : open) html += "<li>" + escape_markup(line) + "</li>";
    html += "</ul>\n";
  }
  return html + missed_html(c, missed_tolerance(c, comparison));
}

std::string missed_html(const bearing::Case& c, const Missed& missed) {
  if (!missed) return "";
  std::string html = "<p>" + escape_markup(tolerance_lines(c, missed).front()) + ".";
  if (!missed.command.empty()) {
    html += " " + escape_markup(missed.outlook) + ": <code>" + escape_markup(missed.command) +
            "</code>";
  }
  return html + "</p>\n";
}

std::string audit_html(const Comparison& comparison) {
  const auto names = column_names(comparison.results);
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>result</th><th>status</th><th>mass</th>"
      "<th>energy</th><th>load</th><th>moment</th><th>grid</th><th>outer iterations</th>"
      "<th>Newton</th><th>factorizations</th><th>time [s]</th></tr></thead><tbody>\n";
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Result& r = comparison.results[k];
    html += fmt::format(
        "<tr><td>{}</td><td{}>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        escape_markup(names[k]), r.verdict.good() ? "" : " class=\"bad\"", status_line(r),
        audit_cell(r.audit.mass), audit_cell(r.audit.energy), audit_cell(r.audit.load),
        audit_cell(r.audit.moment), grid_words(r.grid), r.cost.outer_iterations,
        r.cost.newton_iterations, r.cost.factorizations, figures(r.cost.wall_s, 3));
  }
  return html + "</tbody></table></div>\n";
}

std::string effects_html(const std::vector<StoredEffect>& effects) {
  if (effects.empty()) return "";
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>effect</th><th>included</th><th>indicator</th>"
      "<th class=\"unit\">meaning</th></tr></thead><tbody>\n";
  for (const StoredEffect& e : effects) {
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"text\">{}</td></tr>\n",
                        escape_markup(e.name), e.included ? "yes" : "no", figures(e.indicator, 3),
                        escape_markup(e.meaning));
  }
  return html + "</tbody></table></div>\n";
}

std::string effects_html(const Comparison& comparison) {
  if (comparison.results.empty()) return "";
  std::vector<StoredEffect> rows;
  for (const auto& e : comparison.results.back().effects) {
    rows.push_back({name_of(e.kind), meaning_of(e), e.included, e.indicator});
  }
  return effects_html(rows);
}

std::string notes_html(const std::vector<std::string>& warnings,
                       const std::vector<std::string>& limiters,
                       const std::vector<std::string>& assumptions) {
  const std::string lists = list_html("Warnings", warnings) +
                            list_html("Limiters that acted", limiters) +
                            list_html("Assumptions", assumptions);
  return lists.empty() ? "" : "<div class=\"columns\">\n" + lists + "</div>\n";
}

std::string notes_html(const Comparison& comparison) {
  const auto names = column_names(comparison.results);
  const auto warnings =
      lines_of_columns(comparison.results, [](const Result& r) { return words_of(r.warnings); });
  const auto assumptions =
      lines_of_columns(comparison.results, [](const Result& r) { return words_of(r.assumptions); });
  std::vector<std::string> limiters;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Result& r = comparison.results[k];
    for (const auto& l : r.limiters) {
      limiters.push_back(fmt::format("{}: {}, {} times", names[k], words_of(l.what), l.count));
    }
  }
  return notes_html(warnings, limiters, assumptions);
}

std::string provenance_html(const Provenance& p, const std::string& verbatim) {
  std::string html =
      fmt::format("<p>Shellback {} ({}). Input {}, FNV-1a {}.<br>", escape_markup(p.version),
                  escape_markup(p.git),
                  p.input.empty() ? "not from a file" : escape_markup(p.input), p.fingerprint);
  for (const auto& [name, version] : p.libraries) {
    html += escape_markup(name + " " + version) + (name == p.libraries.back().first ? "" : " · ");
  }
  html += "</p>\n";
  if (!verbatim.empty()) {
    html += "<details><summary>The case as read</summary><pre>" + escape_markup(verbatim) +
            "</pre></details>\n";
  }
  return html;
}

std::string provenance_html(const bearing::Case& c) {
  return provenance_html(provenance(c), c.verbatim);
}

}  // namespace shellback::app
