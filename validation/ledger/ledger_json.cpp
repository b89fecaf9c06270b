#include "validation/ledger/ledger_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "validation/ledger/ledger_text.hpp"

namespace shellback::validation {
namespace {

using nlohmann::ordered_json;

void put(ordered_json& object, const char* key, double value) {
  if (std::isfinite(value)) object[key] = value;
}

ordered_json row_json(const EntryReport& report, const RowReport& r) {
  ordered_json row;
  row["row"] = row_label(report.entry, report.points[r.row].point);
  put(row, "ours", r.ours);
  put(row, "theirs", r.theirs);
  put(row, "difference", r.difference);
  put(row, "allowed", r.allowed);
  row["verdict"] = to_string(r.judgement);
  if (!r.reason.empty()) row["remark"] = r.reason;
  return row;
}

ordered_json quantity_json(const EntryReport& report, const QuantityReport& q) {
  ordered_json out;
  out["name"] = q.spec.name;
  out["unit"] = q.spec.unit;
  out["evidence"] = to_string(q.spec.evidence);
  out["tolerance"] = describe(q.spec.tolerance, q.spec.unit);
  out["why"] = q.spec.why;
  out["judged"] = q.judged;
  put(out, "rms", q.rms);
  put(out, "rms_relative", q.rms_relative);
  out["verdict"] = to_string(q.verdict);
  out["rows"] = ordered_json::array();
  for (const RowReport& r : q.rows) {
    ordered_json row = row_json(report, r);
    const BandWidth band = band_at(report, q.spec.ours, r.row);
    put(row, "band_low", band.low * q.spec.scale);
    put(row, "band_high", band.high * q.spec.scale);
    out["rows"].push_back(std::move(row));
  }
  return out;
}

ordered_json feature_json(const FeatureReport& f) {
  ordered_json out;
  out["name"] = f.feature.name;
  out["unit"] = f.feature.unit;
  out["evidence"] = to_string(f.feature.evidence);
  put(out, "ours", f.ours);
  put(out, "ours_by_parabola", f.ours_refined);
  put(out, "theirs_by_parabola", f.theirs_refined);
  out["theirs"] = {f.feature.low, f.feature.high};
  out["verdict"] = to_string(f.verdict);
  return out;
}

ordered_json deviation_json(const DeviationReport& d) {
  ordered_json out;
  out["quantity"] = d.quantity;
  out["column"] = d.deviation.column;
  put(out, "found", d.found);
  out["documented"] = {d.deviation.from, d.deviation.to};
  out["as_documented"] = d.complaint.empty();
  if (!d.complaint.empty()) out["complaint"] = d.complaint;
  out["why"] = d.deviation.why;
  return out;
}

}  // namespace

std::string ledger_json(const std::vector<EntryReport>& reports,
                        const std::vector<UnrunDataset>& gaps) {
  ordered_json root;
  root["entries"] = ordered_json::array();
  for (const EntryReport& report : reports) {
    ordered_json entry;
    entry["name"] = report.entry.name;
    entry["title"] = report.entry.title;
    entry["wall_s"] = report.wall_s;
    if (report.interrupted) {
      entry["verdict"] = "interrupted";
      root["entries"].push_back(std::move(entry));
      continue;
    }
    entry["verdict"] = to_string(report.verdict());
    entry["quantities"] = ordered_json::array();
    for (const auto& q : report.quantities) entry["quantities"].push_back(quantity_json(report, q));
    entry["features"] = ordered_json::array();
    for (const auto& f : report.features) entry["features"].push_back(feature_json(f));
    entry["deviations"] = ordered_json::array();
    for (const auto& d : report.deviations) entry["deviations"].push_back(deviation_json(d));
    root["entries"].push_back(std::move(entry));
  }
  root["not_run"] = ordered_json::array();
  for (const UnrunDataset& gap : gaps) {
    root["not_run"].push_back({{"title", gap.title}, {"reason", gap.reason}});
  }
  return root.dump(2) + "\n";
}

}  // namespace shellback::validation
