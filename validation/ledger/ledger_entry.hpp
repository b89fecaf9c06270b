#pragma once
/// One entry of the validation ledger: what is compared with what, and how near it must be.
///
/// An entry is a folder of validation/ with `entry.toml` (this struct), a table of expected values
/// and, where bearings are solved, ordinary case files. docs/validation-ledger.md describes the
/// file. ledger_read.hpp fills the struct.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/reading/overrides.hpp"
#include "validation/ledger/ledger_table.hpp"

namespace shellback::validation {

/// Where an expected value comes from, from the strongest to the weakest.
enum class Evidence {
  measurement,  ///< published measurement
  calculation,  ///< published calculation
  exact,        ///< exact solution
  recomputed,   ///< recomputed by an independent program
  own,          ///< our own digits of a former version: no proof, only an alarm
};
inline constexpr int kEvidences = 5;
[[nodiscard]] const char* to_string(Evidence evidence);

/// |ours - theirs| may be relative |theirs| + absolute + of_maximum max |theirs| over the rows.
struct Tolerance {
  double relative = 0.0;    ///< [-]
  double absolute = 0.0;    ///< in the unit of the quantity
  double of_maximum = 0.0;  ///< [-]
};

/// One column of expected values and what of ours stands beside it.
struct QuantitySpec {
  std::string name;
  std::string column;  ///< of the table
  std::string ours;    ///< name among the evaluator's values
  std::string unit;    ///< as printed; "1": none
  double scale = 1.0;  ///< ours times this is in `unit`
  Evidence evidence = Evidence::calculation;
  Tolerance tolerance;
  std::string group;  ///< column whose values split the rows into curves with their own maximum
  std::string why;    ///< why this tolerance
};

/// Rows by their columns: equal to `at`, above `above`, below `below`.
struct Condition {
  std::map<std::string, double> at;
  std::map<std::string, double> above;
  std::map<std::string, double> below;
};

/// Rows that are shown but not judged.
struct Exclusion {
  std::vector<std::string> columns;  ///< of the expected values; empty: all
  Condition where;
  std::string why;
};

/// A difference that is known: rows that are outside, how far, and why. What is outside without
/// one, or outside by another measure than the documented one, is an alarm.
struct Deviation {
  std::string column;  ///< of the expected values
  Condition where;     ///< which rows; empty: all
  /// (ours - theirs)/allowed of the row that is farthest outside lies between these, ends
  /// included [-]; both above 1 or both below -1.
  double from = 0.0;
  double to = 0.0;
  std::string why;
};

/// A column that sets a key of the case files.
struct Vary {
  std::string column;
  std::string key;      ///< as for --set
  std::string unit;     ///< put behind the number; empty: a plain number
  double factor = 1.0;  ///< the number is the cell's value times this
  std::string bearing;  ///< name of the bearing; empty: all
};

/// One of the bearings whose results add up.
struct BearingPart {
  std::string name;
  std::string file;    ///< path of its case
  double times = 1.0;  ///< how many of them
};

/// One way to change the bearings: overrides by the bearing's name.
using Changes = std::map<std::string, std::vector<app::Override>>;

/// An input that the source does not tell, with the range in which it may lie.
struct Unknown {
  std::string name;
  std::string range;  ///< in words, with what was taken
  std::string why;
  Changes low;
  Changes high;
};

/// A property of our curve that theirs has too: at which row it is lowest. Their curve is known at
/// the rows only, so ours is looked at there as well; a parabola through the lowest row and its
/// neighbours, the same for both, says more and is shown, not judged.
struct Feature {
  std::string name;
  std::string ours;    ///< value whose minimum is sought
  std::string column;  ///< theirs
  std::string along;   ///< column of the abscissa
  Condition where;
  double low = 0.0;  ///< it must lie between these, ends included
  double high = 0.0;
  std::string unit;
  Evidence evidence = Evidence::calculation;
  std::string why;
};

/// A further curve of ours in a panel, without a counterpart.
struct PartCurve {
  std::string ours;
  std::string title;
};

struct Panel {
  std::string ours;   ///< name among the evaluator's values
  std::string title;  ///< of its axis, with unit
  std::string head;   ///< above the panel; may be empty
  bool logarithmic = false;
  Condition where;               ///< which rows are drawn
  std::vector<PartCurve> parts;  ///< ours taken apart
};

struct FigureSpec {
  std::string x;  ///< column
  std::string x_title;
  bool x_logarithmic = false;
  std::string series;  ///< column that splits the rows into curves; empty: one curve
  std::string series_title;
  std::vector<double> shown;  ///< values of `series` that are drawn; empty: all
  int between = 0;            ///< points of our curve between two rows
  std::vector<Panel> panels;
};

struct Entry {
  std::string name;  ///< of its folder
  std::string folder;
  std::string title;
  std::string source;    ///< the publication, and what of it was really read
  std::string compared;  ///< what is compared with what, in a sentence or two
  std::string note;      ///< what is known about deviations; may be empty
  std::vector<std::string> assumptions;
  std::string evaluator;
  std::vector<BearingPart> bearings;
  std::vector<Vary> vary;
  std::map<std::string, std::string> settings;  ///< of the evaluator
  std::vector<QuantitySpec> quantities;
  std::vector<Exclusion> exclusions;
  std::vector<Deviation> deviations;
  std::vector<Unknown> unknowns;
  std::vector<Feature> features;
  FigureSpec figure;
  std::optional<Table> table;  ///< always there once read
};

/// A dataset of which we have no entry, and why.
struct UnrunDataset {
  std::string title;
  std::string reason;
};

/// The numbers of one row, or of a point between two.
using RowNumbers = std::map<std::string, double>;

[[nodiscard]] bool holds(const Condition& condition, const RowNumbers& point);

/// The row in the words of its figure's columns: "L/D 1, eps 0.6".
[[nodiscard]] std::string row_label(const Entry& entry, const RowNumbers& point);

}  // namespace shellback::validation
