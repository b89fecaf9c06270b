#include "validation/ledger/ledger_deviation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace shellback::validation {
namespace {

/// Distance from theirs on the documented side; negative on the other.
double along(const Deviation& d, double share) { return d.from > 0.0 ? share : -share; }
double nearest(const Deviation& d) { return std::fmin(std::abs(d.from), std::abs(d.to)); }
double farthest(const Deviation& d) { return std::fmax(std::abs(d.from), std::abs(d.to)); }

std::string range_of(const Deviation& d) {
  return fmt::format("{:.3g} to {:.3g} times what is allowed {}", nearest(d), farthest(d),
                     d.from > 0.0 ? "above" : "below");
}

/// The row farthest out on the documented side among those the deviation covers.
double farthest_share(const EntryReport& report, const QuantityReport& q, const Deviation& d) {
  double most = std::numeric_limits<double>::quiet_NaN();
  for (const RowReport& r : q.rows) {
    const bool judged = r.judgement != Judgement::missing && r.judgement != Judgement::excluded;
    if (!judged || !holds(d.where, report.points[r.row].point)) continue;
    if (std::isnan(most) || along(d, r.share()) > along(d, most)) most = r.share();
  }
  return most;
}

/// How the deviation is not as documented; empty if it is.
std::string complaint_of(const Deviation& d, double found) {
  if (std::isnan(found)) return "none of its rows has a result";
  const double distance = along(d, found);
  if (distance > farthest(d)) return "it has grown";
  if (distance >= nearest(d)) return "";
  return distance > 1.0 ? "it has shrunk" : "it has disappeared";
}

}  // namespace

void judge_known(const Entry& entry, const std::string& column, const RowNumbers& point,
                 RowReport& row) {
  for (const Deviation& d : entry.deviations) {
    if (d.column != column || !holds(d.where, point)) continue;
    const double distance = along(d, row.share());
    if (distance < 0.0) continue;
    if (distance <= farthest(d)) row.judgement = Judgement::documented;
    row.reason = row.judgement == Judgement::documented
                     ? d.why
                     : fmt::format("documented {} theirs: {}", range_of(d), d.why);
    return;
  }
}

void judge_deviations(EntryReport& report) {
  report.deviations.clear();
  for (const Deviation& d : report.entry.deviations) {
    for (QuantityReport& q : report.quantities) {
      if (q.spec.column != d.column) continue;
      DeviationReport known{d, q.spec.name, farthest_share(report, q, d), ""};
      known.complaint = complaint_of(d, known.found);
      const bool calm = as_expected(q.verdict);
      if (!known.complaint.empty() && calm) q.verdict = Judgement::changed;
      report.deviations.push_back(std::move(known));
    }
  }
}

std::string describe(const DeviationReport& report) {
  const Deviation& d = report.deviation;
  std::string words = fmt::format("{}: documented {} theirs", report.quantity, range_of(d));
  if (std::isfinite(report.found)) {
    words += fmt::format(", found {:.3g} {}", std::abs(report.found),
                         report.found > 0.0 ? "above" : "below");
  }
  return words + (report.complaint.empty() ? "" : "; " + report.complaint);
}

}  // namespace shellback::validation
