#include "validation/ledger/ledger_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellback::validation {

const char* to_string(Judgement judgement) {
  switch (judgement) {
    case Judgement::within:
      return "within";
    case Judgement::documented:
      return "as documented";
    case Judgement::changed:
      return "not as documented";
    case Judgement::outside:
      return "outside";
    case Judgement::excluded:
      return "not judged";
    case Judgement::missing:
      return "no result";
  }
  return "";
}

bool as_expected(Judgement judgement) {
  return judgement == Judgement::within || judgement == Judgement::documented ||
         judgement == Judgement::excluded;
}

Judgement worse(Judgement a, Judgement b) {
  const auto rank = [](Judgement j) {
    switch (j) {
      case Judgement::excluded:
        return 0;
      case Judgement::within:
        return 1;
      case Judgement::documented:
        return 2;
      case Judgement::changed:
        return 3;
      case Judgement::missing:
        return 4;
      case Judgement::outside:
        return 5;
    }
    return 5;
  };
  return rank(a) >= rank(b) ? a : b;
}

bool EntryReport::has(Evidence evidence) const {
  const auto of_kind = [evidence](const auto& spec) { return spec.evidence == evidence; };
  return std::any_of(entry.quantities.begin(), entry.quantities.end(), of_kind) ||
         std::any_of(entry.features.begin(), entry.features.end(), of_kind);
}

Judgement EntryReport::verdict(Evidence evidence) const {
  Judgement all = Judgement::excluded;
  for (const QuantityReport& q : quantities) {
    if (q.spec.evidence == evidence) all = worse(all, q.verdict);
  }
  for (const FeatureReport& f : features) {
    if (f.feature.evidence == evidence) all = worse(all, f.verdict);
  }
  return all;
}

Judgement EntryReport::verdict() const {
  Judgement all = Judgement::excluded;
  for (int k = 0; k < kEvidences; ++k) all = worse(all, verdict(static_cast<Evidence>(k)));
  return all;
}

BandWidth band_at(const EntryReport& report, const std::string& ours, std::size_t row) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  BandWidth band{kNone, kNone};
  const auto add = [&](const Values& values) {
    const auto found = values.value.find(ours);
    if (found == values.value.end()) return;
    band.low = std::fmin(band.low, found->second);
    band.high = std::fmax(band.high, found->second);
  };
  if (report.bands.empty()) return band;
  add(report.points[row].values);
  for (const BandReport& unknown : report.bands) {
    for (const auto& side : unknown.side) add(side[row]);
  }
  return band;
}

}  // namespace shellback::validation
