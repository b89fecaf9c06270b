#pragma once
/// What came of an entry of the ledger: our values beside theirs, and how each was judged.
#include <array>
#include <string>
#include <vector>

#include "validation/evaluators/evaluators.hpp"
#include "validation/ledger/ledger_entry.hpp"

namespace shellback::validation {

enum class Judgement {
  within,      ///< the tolerance
  documented,  ///< outside the tolerance as a [[deviation]] of the entry says
  outside,     ///< the tolerance, and any deviation that is documented
  changed,     ///< a documented deviation is smaller than documented, or gone
  excluded,    ///< shown, not judged
  missing,     ///< ours did not converge
};
[[nodiscard]] const char* to_string(Judgement judgement);
/// Nothing to be alarmed about: within, documented or not judged.
[[nodiscard]] bool as_expected(Judgement judgement);
/// Of two judgements the one that weighs more in a verdict over both.
[[nodiscard]] Judgement worse(Judgement a, Judgement b);

/// One of our values: at a row of the table, or between two for the sake of the curve.
struct Evaluated {
  RowNumbers point;
  int row = -1;  ///< of the table; -1: between
  Values values;
};

/// One expected value and ours.
struct RowReport {
  std::size_t row = 0;  ///< of the table
  double theirs = 0.0;
  double ours = 0.0;        ///< in the unit of the quantity
  double difference = 0.0;  ///< ours - theirs
  double allowed = 0.0;     ///< |difference| may be this
  Judgement judgement = Judgement::within;
  std::string reason;  ///< of an exclusion, a documented deviation or a missing value

  /// (ours - theirs)/allowed [-].
  [[nodiscard]] double share() const { return difference / allowed; }
};

struct QuantityReport {
  QuantitySpec spec;
  std::vector<RowReport> rows;
  int judged = 0;
  int missing = 0;
  int worst = -1;             ///< index in `rows`: largest |difference|/allowed; -1: none judged
  double rms = 0.0;           ///< of the differences judged, in the unit
  double rms_relative = 0.0;  ///< over the rms of theirs [-]
  Judgement verdict = Judgement::within;
};

struct FeatureReport {
  Feature feature;
  double ours = 0.0;            ///< the row at which ours is lowest
  double ours_refined = 0.0;    ///< by the parabola
  double theirs_refined = 0.0;  ///< by the same parabola through their rows
  Judgement verdict = Judgement::within;
  std::string reason;
};

struct DeviationReport {
  Deviation deviation;
  std::string quantity;  ///< name of the quantity of its column
  double found = 0.0;    ///< share of the row farthest out on the documented side; NaN: none judged
  std::string complaint;  ///< how it is not as documented; empty: it is
};

/// Our values at the rows with one unknown input at its ends.
struct BandReport {
  std::string unknown;
  std::array<std::vector<Values>, 2> side;  ///< low, high; one per row of the table
};

struct EntryReport {
  Entry entry;
  std::vector<Evaluated> points;  ///< rows of the table first, in its order; then those between
  std::vector<BandReport> bands;
  std::vector<QuantityReport> quantities;
  std::vector<FeatureReport> features;
  std::vector<DeviationReport> deviations;
  bool interrupted = false;
  double wall_s = 0.0;

  /// The worst of all its quantities and features of one kind of evidence.
  [[nodiscard]] Judgement verdict(Evidence evidence) const;
  [[nodiscard]] Judgement verdict() const;
  [[nodiscard]] bool has(Evidence evidence) const;
};

/// Lowest and highest of ours at a row over all unknown inputs at their ends and as taken, one
/// at a time. Not-a-number where nothing is known.
struct BandWidth {
  double low = 0.0;
  double high = 0.0;
};
[[nodiscard]] BandWidth band_at(const EntryReport& report, const std::string& ours,
                                std::size_t row);

}  // namespace shellback::validation
