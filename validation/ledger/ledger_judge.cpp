#include "validation/ledger/ledger_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/reading/did_you_mean.hpp"
#include "core/contract.hpp"
#include "validation/ledger/ledger_deviation.hpp"

namespace shellback::validation {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Our value of a name; not-a-number if the row has none. A name that no solved row knows is an
/// error of the entry, which a solved row shows.
double our_value(const Entry& entry, const Values& values, const std::string& name) {
  const auto found = values.value.find(name);
  if (found != values.value.end()) return found->second;
  if (values.value.empty()) return kNone;
  std::vector<std::string> known;
  for (const auto& [word, value] : values.value) known.push_back(word);
  throw InputError(
      entry.folder + "/entry.toml",
      fmt::format("the evaluator {} gives no value {}{}", app::in_quotes(entry.evaluator),
                  app::in_quotes(name), app::choices_for(name, known, "it gives")));
}

/// Why the row's expected value is not judged; empty if it is.
std::string exclusion_of(const Entry& entry, const std::string& column, const RowNumbers& point) {
  for (const Exclusion& e : entry.exclusions) {
    const bool meant = e.columns.empty() ||
                       std::find(e.columns.begin(), e.columns.end(), column) != e.columns.end();
    if (meant && holds(e.where, point)) return e.why;
  }
  return "";
}

double group_of(const QuantitySpec& spec, const RowNumbers& point) {
  return spec.group.empty() ? 0.0 : point.at(spec.group);
}

/// Largest |theirs| in every group of rows.
std::map<double, double> maxima_of(const EntryReport& report, const QuantitySpec& spec) {
  std::map<double, double> most;
  for (std::size_t row = 0; row < report.entry.table->lines().size(); ++row) {
    const auto theirs = report.entry.table->number(row, spec.column);
    if (!theirs) continue;
    double& value = most[group_of(spec, report.points[row].point)];
    value = std::max(value, std::abs(*theirs));
  }
  return most;
}

RowReport compare(const EntryReport& report, const QuantitySpec& spec, std::size_t row,
                  double theirs, double most) {
  const Evaluated& at = report.points[row];
  RowReport r;
  r.row = row;
  r.theirs = theirs;
  r.ours = spec.scale * our_value(report.entry, at.values, spec.ours);
  r.difference = r.ours - theirs;
  r.allowed = spec.tolerance.relative * std::abs(theirs) + spec.tolerance.absolute +
              spec.tolerance.of_maximum * most;
  r.reason = exclusion_of(report.entry, spec.column, at.point);
  if (!r.reason.empty()) {
    r.judgement = Judgement::excluded;
  } else if (!std::isfinite(r.ours)) {
    r.judgement = Judgement::missing;
    r.reason = at.values.failure.empty() ? "no value" : at.values.failure;
  } else if (std::abs(r.difference) > r.allowed) {
    r.judgement = Judgement::outside;
    judge_known(report.entry, spec.column, at.point, r);
  }
  return r;
}

void sum_up(QuantityReport& q) {
  double squares = 0.0;
  double size = 0.0;
  double worst = -1.0;
  for (std::size_t k = 0; k < q.rows.size(); ++k) {
    const RowReport& r = q.rows[k];
    if (r.judgement == Judgement::missing) ++q.missing;
    if (r.judgement == Judgement::missing || r.judgement == Judgement::excluded) continue;
    ++q.judged;
    q.verdict = worse(q.verdict, r.judgement);
    squares += r.difference * r.difference;
    size += r.theirs * r.theirs;
    if (std::abs(r.share()) > worst) {
      worst = std::abs(r.share());
      q.worst = static_cast<int>(k);
    }
  }
  if (q.judged > 0) q.rms = std::sqrt(squares / q.judged);
  if (size > 0.0) q.rms_relative = std::sqrt(squares / size);
  if (q.missing > 0) q.verdict = worse(q.verdict, Judgement::missing);
  if (q.judged + q.missing == 0) q.verdict = Judgement::excluded;
}

QuantityReport judge_quantity(const EntryReport& report, const QuantitySpec& spec) {
  QuantityReport q;
  q.spec = spec;
  const auto most = maxima_of(report, spec);
  for (std::size_t row = 0; row < report.entry.table->lines().size(); ++row) {
    const auto theirs = report.entry.table->number(row, spec.column);
    if (!theirs) continue;
    const double group = group_of(spec, report.points[row].point);
    q.rows.push_back(compare(report, spec, row, *theirs, most.at(group)));
  }
  sum_up(q);
  return q;
}

struct Place {
  double x;
  double y;
};

/// Abscissa of the parabola's lowest point through three points.
double vertex(const Place& a, const Place& b, const Place& c) {
  const double ab = (b.y - a.y) / (b.x - a.x);
  const double bc = (c.y - b.y) / (c.x - b.x);
  const double curvature = (bc - ab) / (c.x - a.x);
  return curvature > 0.0 ? 0.5 * (a.x + b.x) - 0.5 * ab / curvature : b.x;
}

/// Lowest of the places and the parabola's vertex there, both as abscissas; not-a-number if the
/// lowest lies at an end.
struct Lowest {
  double at = kNone;
  double refined = kNone;
};

Lowest lowest(std::vector<Place> curve, bool logarithmic) {
  std::sort(curve.begin(), curve.end(), [](const Place& a, const Place& b) { return a.x < b.x; });
  const auto least = std::min_element(curve.begin(), curve.end(),
                                      [](const Place& a, const Place& b) { return a.y < b.y; });
  if (curve.size() < 3 || least == curve.begin() || least + 1 == curve.end()) return {};
  const auto back = [logarithmic](double x) { return logarithmic ? std::exp(x) : x; };
  return {back(least->x), back(vertex(*(least - 1), *least, *(least + 1)))};
}

FeatureReport judge_feature(const EntryReport& report, const Feature& feature) {
  const Entry& entry = report.entry;
  const bool logarithmic = entry.figure.x_logarithmic && entry.figure.x == feature.along;
  std::vector<Place> ours;
  std::vector<Place> theirs;
  for (std::size_t row = 0; row < entry.table->lines().size(); ++row) {
    const Evaluated& e = report.points[row];
    if (!holds(feature.where, e.point) || !e.point.contains(feature.along)) continue;
    const double along = e.point.at(feature.along);
    const double x = logarithmic ? std::log(along) : along;
    const double y = our_value(entry, e.values, feature.ours);
    if (std::isfinite(y)) ours.push_back({x, y});
    if (const auto other = entry.table->number(row, feature.column)) theirs.push_back({x, *other});
  }
  const Lowest mine = lowest(std::move(ours), logarithmic);
  FeatureReport f{feature,           mine.at,
                  mine.refined,      lowest(std::move(theirs), logarithmic).refined,
                  Judgement::within, ""};
  constexpr double kSlack = 1e-9;  // a row's abscissa through logarithm and back
  if (!std::isfinite(f.ours)) {
    f.verdict = Judgement::missing;
    f.reason = "our curve has no lowest row inside the rows compared";
  } else if (f.ours < feature.low * (1.0 - kSlack) || f.ours > feature.high * (1.0 + kSlack)) {
    f.verdict = Judgement::outside;
  }
  return f;
}

}  // namespace

void judge(EntryReport& report) {
  report.quantities.clear();
  report.features.clear();
  for (const QuantitySpec& spec : report.entry.quantities) {
    report.quantities.push_back(judge_quantity(report, spec));
  }
  for (const Feature& feature : report.entry.features) {
    report.features.push_back(judge_feature(report, feature));
  }
  judge_deviations(report);
}

}  // namespace shellback::validation
