#include "validation/ledger/ledger_text.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "app/labels/csv_text.hpp"
#include "validation/ledger/ledger_deviation.hpp"

namespace shellback::validation {
namespace {

constexpr const char* kHead = "    {:<44} {:>4}  {:<24} {:>11} {:>11} {:>11} {:>10} {:>9}  {}\n";

void write_row(std::ostream& out, const QuantityReport& q, const RowReport& r,
               const EntryReport& report) {
  const bool missing = r.judgement == Judgement::missing;
  fmt::print(out, "    {:<44} {:>4}  {:<24} {:>11} {:>11} {:>11} {:>10} {:>9}  {}{}\n", "", "",
             row_label(report.entry, report.points[r.row].point),
             missing ? "-" : short_number(r.ours), short_number(r.theirs),
             missing ? "-" : signed_number(r.difference), short_number(r.allowed), "",
             to_string(r.judgement), r.reason.empty() ? "" : ": " + r.reason);
  static_cast<void>(q);
}

void write_quantity(std::ostream& out, const QuantityReport& q, const EntryReport& report,
                    RowsShown shown) {
  const std::string unit = q.spec.unit == "1" ? "" : " [" + q.spec.unit + "]";
  const std::string name = q.spec.name + unit;
  const std::string count = fmt::format("{}", q.judged);
  if (q.worst < 0) {
    fmt::print(out, kHead, name, count, "", "", "", "", "", "", to_string(q.verdict));
  } else {
    const RowReport& r = q.rows[static_cast<std::size_t>(q.worst)];
    fmt::print(out, kHead, name, count, row_label(report.entry, report.points[r.row].point),
               short_number(r.ours), short_number(r.theirs), signed_number(r.difference),
               short_number(r.allowed), fmt::format("{:.2g} %", 100.0 * q.rms_relative),
               to_string(q.verdict));
  }
  for (const RowReport& r : q.rows) {
    const bool telling = r.judgement != Judgement::within && r.judgement != Judgement::excluded;
    if (shown == RowsShown::all || telling) write_row(out, q, r, report);
  }
}

void write_features(std::ostream& out, const EntryReport& report, Evidence evidence) {
  for (const FeatureReport& f : report.features) {
    if (f.feature.evidence != evidence) continue;
    fmt::print(out, kHead, f.feature.name + " [" + f.feature.unit + "]", "", "",
               short_number(f.ours), fmt::format("{:.5g}-{:.5g}", f.feature.low, f.feature.high),
               "", "", "", to_string(f.verdict));
    if (!std::isfinite(f.ours_refined)) continue;
    fmt::print(out, kHead, "  by a parabola through three rows, not judged", "", "",
               short_number(f.ours_refined), short_number(f.theirs_refined), "", "", "", "");
  }
}

}  // namespace

std::string signed_number(double value) {
  return std::isfinite(value) ? fmt::format("{:+.4g}", value) : "-";
}

std::string short_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "-";
}

std::string after_number(const std::string& unit) { return unit == "1" ? "" : " " + unit; }

std::string describe(const Tolerance& t, const std::string& unit) {
  std::string words;
  const auto add = [&words](const std::string& part) {
    words += (words.empty() ? "" : " + ") + part;
  };
  if (t.relative > 0.0) add(fmt::format("{:.4g} %", 100.0 * t.relative));
  if (t.of_maximum > 0.0) add(fmt::format("{:.4g} % of the largest", 100.0 * t.of_maximum));
  if (t.absolute > 0.0) add(fmt::format("{:.4g}{}", t.absolute, after_number(unit)));
  return words;
}

void write_entry_table(std::ostream& out, const EntryReport& report, RowsShown shown) {
  fmt::print(out, "{}: {}  ({:.1f} s)\n", report.entry.name, report.entry.title, report.wall_s);
  if (report.interrupted) {
    fmt::print(out, "    interrupted: no verdict\n\n");
    return;
  }
  for (int k = 0; k < kEvidences; ++k) {
    const auto evidence = static_cast<Evidence>(k);
    if (!report.has(evidence)) continue;
    fmt::print(out, kHead, fmt::format("against: {}", to_string(evidence)), "rows", "worst row",
               "ours", "theirs", "difference", "allowed", "RMS", "verdict");
    for (const QuantityReport& q : report.quantities) {
      if (q.spec.evidence == evidence) write_quantity(out, q, report, shown);
    }
    write_features(out, report, evidence);
  }
  for (const DeviationReport& d : report.deviations) {
    fmt::print(out, "    {}: {}\n", d.complaint.empty() ? "as documented" : "NOT as documented",
               describe(d));
  }
  fmt::print(out, "\n");
}

void write_summary(std::ostream& out, const std::vector<EntryReport>& reports,
                   const std::vector<UnrunDataset>& gaps) {
  for (int k = 0; k < kEvidences; ++k) {
    const auto evidence = static_cast<Evidence>(k);
    int within = 0;
    std::string known;
    std::string others;
    int all = 0;
    for (const EntryReport& r : reports) {
      if (r.interrupted || !r.has(evidence)) continue;
      ++all;
      const Judgement verdict = r.verdict(evidence);
      if (verdict == Judgement::within) ++within;
      if (verdict == Judgement::documented) known += (known.empty() ? "" : ", ") + r.entry.name;
      if (as_expected(verdict)) continue;
      others +=
          fmt::format("{}{} ({})", others.empty() ? "" : ", ", r.entry.name, to_string(verdict));
    }
    if (all == 0) continue;
    fmt::print(out, "{:<37} {} of {} entries within{}{}\n", to_string(evidence), within, all,
               known.empty() ? "" : "; outside as documented: " + known,
               others.empty() ? "" : "; not: " + others);
  }
  if (!gaps.empty()) {
    fmt::print(out, "{:<37} {} datasets; the page (-o FILE.html) says why\n", "not runnable",
               gaps.size());
  }
}

std::string ledger_csv(const std::vector<EntryReport>& reports) {
  std::string csv =
      "entry,evidence,quantity,unit,row,ours,theirs,difference,allowed,verdict,remark\n";
  for (const EntryReport& report : reports) {
    if (report.interrupted) continue;
    for (const QuantityReport& q : report.quantities) {
      for (const RowReport& r : q.rows) {
        const bool missing = !std::isfinite(r.ours);
        csv += fmt::format("{},{},{},{},{},{},{:.9g},{},{:.9g},{},{}\n", report.entry.name,
                           to_string(q.spec.evidence), app::csv_text(q.spec.name),
                           app::csv_text(q.spec.unit),
                           app::csv_text(row_label(report.entry, report.points[r.row].point)),
                           missing ? "" : fmt::format("{:.9g}", r.ours), r.theirs,
                           missing ? "" : fmt::format("{:.9g}", r.difference), r.allowed,
                           to_string(r.judgement), app::csv_text(r.reason));
      }
    }
    for (const FeatureReport& f : report.features) {
      csv += fmt::format("{},{},{},{},,{},{:.9g} to {:.9g},,,{},{}\n", report.entry.name,
                         to_string(f.feature.evidence), app::csv_text(f.feature.name),
                         app::csv_text(f.feature.unit),
                         std::isfinite(f.ours) ? fmt::format("{:.9g}", f.ours) : "", f.feature.low,
                         f.feature.high, to_string(f.verdict), app::csv_text(f.reason));
    }
  }
  return csv;
}

}  // namespace shellback::validation
