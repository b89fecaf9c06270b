#include "validation/ledger/ledger_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/html_page.hpp"
#include "app/pictures/svg.hpp"
#include "app/provenance.hpp"
#include "validation/ledger/ledger_deviation.hpp"
#include "validation/ledger/ledger_figure.hpp"
#include "validation/ledger/ledger_text.hpp"

namespace shellback::validation {
namespace {

using app::escape_markup;

constexpr const char* kStyle = R"css(
.within { color: var(--accent); font-weight: 600; } .outside { color: var(--more); font-weight: 600; }
.quiet { color: var(--muted); } section { margin-top: 34px; }
td.left, th.left { text-align: left; white-space: normal; } tr.kind th { text-align: left;
  padding-top: 18px; color: var(--ink); }
.facts { display: grid; grid-template-columns: max-content 1fr; gap: 4px 18px; margin: 12px 0; }
.facts dt { color: var(--muted); } .facts dd { margin: 0; max-width: 84ch; }
.note { border-left: 4px solid var(--total); background: var(--panel); padding: 8px 14px;
  max-width: 96ch; }
)css";

std::string verdict_html(Judgement verdict) {
  const char* look = verdict == Judgement::within ? "within"
                     : as_expected(verdict)       ? "quiet"
                                                  : "outside";
  return fmt::format("<span class=\"{}\">{}</span>", look, to_string(verdict));
}

/// Largest |difference| over what is allowed, of all quantities of one kind.
double worst_share(const EntryReport& report, Evidence evidence) {
  double worst = 0.0;
  for (const QuantityReport& q : report.quantities) {
    if (q.spec.evidence != evidence || q.worst < 0) continue;
    const RowReport& r = q.rows[static_cast<std::size_t>(q.worst)];
    worst = std::max(worst, std::abs(r.difference) / r.allowed);
  }
  return worst;
}

std::string overview_row(const EntryReport& report, Evidence evidence) {
  int values = 0;
  std::string names;
  for (const QuantityReport& q : report.quantities) {
    if (q.spec.evidence != evidence) continue;
    values += q.judged;
    if (q.judged > 0) {
      names += fmt::format("{}{} {:.2g} %", names.empty() ? "" : "; ", escape_markup(q.spec.name),
                           100.0 * q.rms_relative);
    }
  }
  return fmt::format(
      "<tr><td class=\"left\"><a href=\"#{}\">{}</a></td><td>{}</td><td class=\"left\">{}</td>"
      "<td>{:.2f}</td><td>{}</td></tr>\n",
      escape_markup(report.entry.name), escape_markup(report.entry.title), values, names,
      worst_share(report, evidence), verdict_html(report.verdict(evidence)));
}

std::string overview_html(const std::vector<EntryReport>& reports) {
  std::string html =
      "<div class=\"scroll\"><table>\n<thead><tr><th class=\"left\">entry</th><th>values</th>"
      "<th class=\"left\">RMS difference over the RMS of theirs</th><th>largest difference over "
      "allowed</th><th>verdict</th></tr></thead>\n<tbody>\n";
  for (int k = 0; k < kEvidences; ++k) {
    const auto evidence = static_cast<Evidence>(k);
    std::string rows;
    for (const EntryReport& report : reports) {
      if (report.has(evidence)) rows += overview_row(report, evidence);
    }
    if (rows.empty()) continue;
    html +=
        fmt::format("<tr class=\"kind\"><th colspan=\"5\">{}{}</th></tr>\n{}", to_string(evidence),
                    evidence == Evidence::own ? ": an alarm when digits move, no proof" : "", rows);
  }
  return html + "</tbody></table></div>\n";
}

std::string quantity_row(const EntryReport& report, const QuantityReport& q) {
  std::string values = "<td colspan=\"5\" class=\"quiet\">no value judged</td>";
  if (q.worst >= 0) {
    const RowReport& r = q.rows[static_cast<std::size_t>(q.worst)];
    values = fmt::format("<td class=\"left\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
                         escape_markup(row_label(report.entry, report.points[r.row].point)),
                         short_number(r.ours), short_number(r.theirs), signed_number(r.difference),
                         short_number(r.allowed));
  }
  return fmt::format(
      "<tr><td class=\"left\">{}{}<small>{}</small></td><td>{}</td>{}<td>{:.2g} %</td>"
      "<td class=\"left\">{}<small>{}</small></td><td>{}</td></tr>\n",
      escape_markup(q.spec.name),
      q.spec.unit == "1" ? "" : fmt::format(" [{}]", escape_markup(q.spec.unit)),
      to_string(q.spec.evidence), q.judged, values, 100.0 * q.rms_relative,
      escape_markup(describe(q.spec.tolerance, q.spec.unit)), escape_markup(q.spec.why),
      verdict_html(q.verdict));
}

std::string feature_row(const FeatureReport& f) {
  const std::string refined =
      std::isfinite(f.ours_refined)
          ? fmt::format("lowest row; a parabola through three rows puts ours at {}, theirs at {}",
                        short_number(f.ours_refined), short_number(f.theirs_refined))
          : f.reason;
  return fmt::format(
      "<tr><td class=\"left\">{} [{}]<small>{}</small></td><td></td><td class=\"left\">{}</td>"
      "<td>{}</td><td>{} to {}</td><td></td><td></td><td></td><td class=\"left\"><small>{}</small>"
      "</td><td>{}</td></tr>\n",
      escape_markup(f.feature.name), escape_markup(f.feature.unit), to_string(f.feature.evidence),
      escape_markup(refined), short_number(f.ours), short_number(f.feature.low),
      short_number(f.feature.high), escape_markup(f.feature.why), verdict_html(f.verdict));
}

std::string quantities_html(const EntryReport& report) {
  std::string html =
      "<div class=\"scroll\"><table>\n<thead><tr><th class=\"left\">quantity</th><th>rows</th>"
      "<th class=\"left\">worst row</th><th>ours</th><th>theirs</th><th>difference</th>"
      "<th>allowed</th><th>RMS</th><th class=\"left\">tolerance, and why</th><th>verdict</th></tr>"
      "</thead>\n<tbody>\n";
  for (const QuantityReport& q : report.quantities) html += quantity_row(report, q);
  for (const FeatureReport& f : report.features) html += feature_row(f);
  return html + "</tbody></table></div>\n";
}

std::string rows_html(const EntryReport& report) {
  std::string html =
      "<details><summary>every row</summary><div class=\"scroll\"><table>\n<thead><tr>"
      "<th class=\"left\">quantity</th><th class=\"left\">row</th><th>ours</th><th>theirs</th>"
      "<th>difference</th><th>allowed</th><th>band</th><th>verdict</th></tr></thead>\n<tbody>\n";
  for (const QuantityReport& q : report.quantities) {
    for (const RowReport& r : q.rows) {
      const BandWidth band = band_at(report, q.spec.ours, r.row);
      const std::string width = std::isfinite(band.low)
                                    ? fmt::format("{} to {}", short_number(q.spec.scale * band.low),
                                                  short_number(q.spec.scale * band.high))
                                    : "";
      html += fmt::format(
          "<tr><td class=\"left\">{}<small>{}</small></td><td class=\"left\">{}</td><td>{}</td>"
          "<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}<small>{}</small></td></tr>\n",
          escape_markup(q.spec.name), to_string(q.spec.evidence),
          escape_markup(row_label(report.entry, report.points[r.row].point)), short_number(r.ours),
          short_number(r.theirs), signed_number(r.difference), short_number(r.allowed), width,
          verdict_html(r.judgement), escape_markup(r.reason));
    }
  }
  return html + "</tbody></table></div></details>\n";
}

/// How far one unknown input moves ours, at its ends: the largest change over the rows.
std::string effect_of(const EntryReport& report, std::size_t unknown, const std::string& ours) {
  double worst = 0.0;
  for (const auto& side : report.bands[unknown].side) {
    for (std::size_t row = 0; row < side.size(); ++row) {
      const auto changed = side[row].value.find(ours);
      const auto taken = report.points[row].values.value.find(ours);
      if (changed == side[row].value.end() || taken == report.points[row].values.value.end()) {
        continue;
      }
      const double change = changed->second / taken->second - 1.0;
      if (std::abs(change) > std::abs(worst)) worst = change;
    }
  }
  return fmt::format("{:+.0f} %", 100.0 * worst);
}

std::string unknowns_html(const EntryReport& report) {
  if (report.entry.unknowns.empty()) return "";
  const QuantitySpec& first = report.entry.quantities.front();
  int inside = 0;
  int rows = 0;
  for (const RowReport& r : report.quantities.front().rows) {
    const BandWidth band = band_at(report, first.ours, r.row);
    if (!std::isfinite(band.low)) continue;
    ++rows;
    if (r.theirs >= first.scale * band.low && r.theirs <= first.scale * band.high) ++inside;
  }
  std::string html = fmt::format(
      "<h3>Unknown inputs</h3>\n<p>Each changed alone to the ends of its range, the others as "
      "taken. {} of {} values of the source ({}) lie inside the band that they span.</p>\n"
      "<div class=\"scroll\"><table><thead><tr><th class=\"left\">input</th>"
      "<th class=\"left\">range</th><th class=\"left\">why</th><th>largest change of ours</th>"
      "</tr></thead><tbody>\n",
      inside, rows, escape_markup(first.name));
  for (std::size_t k = 0; k < report.entry.unknowns.size(); ++k) {
    const Unknown& u = report.entry.unknowns[k];
    html += fmt::format(
        "<tr><td class=\"left\">{}</td><td class=\"left\">{}</td><td class=\"left\">{}</td>"
        "<td>{}</td></tr>\n",
        escape_markup(u.name), escape_markup(u.range), escape_markup(u.why),
        k < report.bands.size() ? effect_of(report, k, first.ours) : "");
  }
  return html + "</tbody></table></div>\n";
}

std::string facts_html(const Entry& entry) {
  std::string html = fmt::format(
      "<dl class=\"facts\"><dt>compared</dt><dd>{}</dd>"
      "<dt>source</dt><dd>{}</dd>",
      escape_markup(entry.compared), escape_markup(entry.source));
  if (!entry.assumptions.empty()) {
    html += "<dt>assumed</dt><dd><ul>";
    for (const std::string& line : entry.assumptions) {
      html += fmt::format("<li>{}</li>", escape_markup(line));
    }
    html += "</ul></dd>";
  }
  return html + "</dl>\n";
}

std::string deviations_html(const EntryReport& report) {
  if (report.deviations.empty()) return "";
  std::string html = "<h3>Documented deviations</h3>\n<ul>\n";
  for (const DeviationReport& d : report.deviations) {
    html += fmt::format("<li>{}<small>{}</small></li>\n", escape_markup(describe(d)),
                        escape_markup(d.deviation.why));
  }
  return html + "</ul>\n";
}

std::string entry_html(const EntryReport& report) {
  const Entry& entry = report.entry;
  std::string html =
      fmt::format("<section id=\"{}\">\n<h2>{} &nbsp; {}</h2>\n", escape_markup(entry.name),
                  escape_markup(entry.title), verdict_html(report.verdict()));
  html += facts_html(entry);
  if (!entry.note.empty()) {
    html += fmt::format("<p class=\"note\">{}</p>\n", escape_markup(entry.note));
  }
  html += "<div class=\"figures\">\n";
  for (const std::string& figure : entry_figures(report)) {
    html += fmt::format("<figure>{}</figure>\n", figure);
  }
  html += "</div>\n";
  html += quantities_html(report) + deviations_html(report) + unknowns_html(report);
  html += rows_html(report);
  return html + fmt::format("<p class=\"quiet\">validation/{}, {:.1f} s</p>\n</section>\n",
                            escape_markup(entry.name), report.wall_s);
}

/// Entries by their strongest evidence, otherwise in their order.
std::vector<const EntryReport*> in_order(const std::vector<EntryReport>& reports) {
  std::vector<const EntryReport*> order;
  for (int k = 0; k < kEvidences; ++k) {
    for (const EntryReport& report : reports) {
      const bool there = std::find(order.begin(), order.end(), &report) != order.end();
      if (!there && !report.interrupted && report.has(static_cast<Evidence>(k))) {
        order.push_back(&report);
      }
    }
  }
  return order;
}

std::string unrun_html(const std::vector<UnrunDataset>& unrun) {
  if (unrun.empty()) return "";
  std::string html =
      "<h2>Datasets that are not run</h2>\n<div class=\"scroll\"><table><thead><tr>"
      "<th class=\"left\">dataset</th><th class=\"left\">why not</th></tr></thead><tbody>\n";
  for (const UnrunDataset& set : unrun) {
    html += fmt::format("<tr><td class=\"left\">{}</td><td class=\"left\">{}</td></tr>\n",
                        escape_markup(set.title), escape_markup(set.reason));
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string ledger_page(const std::vector<EntryReport>& reports,
                        const std::vector<UnrunDataset>& unrun) {
  std::string html = app::page_head(
      {.title = "Shellback: validation ledger",
       .heading = "The ledger: ours against theirs",
       .scene = {"What was published stands apart from what was recomputed or derived for the "
                 "comparison, and both from our own former digits. Lines are ours, marks are "
                 "theirs; the strip below a picture shows each difference over what is allowed, "
                 "and inside the shaded zone a value is within."},
       .kind = "validation",
       .style = kStyle});
  html += overview_html(reports);
  for (const EntryReport* report : in_order(reports)) html += entry_html(*report);
  html += unrun_html(unrun);
  const app::Provenance from = app::provenance(bearing::Case{});
  html += fmt::format("<footer>Shellback {}, {}</footer>\n</main>\n</body>\n</html>\n",
                      escape_markup(from.version), escape_markup(from.git));
  return html;
}

}  // namespace shellback::validation
