#pragma once
/// Our side of the ledger: functions that turn the numbers of one row into our values.
///
/// An evaluator calls the functions that the solver itself uses, never a copy of their formulas.
/// It gives named values in SI units (angles in degrees); a row's comparison scales them. A film
/// that does not converge is a result: `failure` says why, and there are no values.
#include <any>
#include <map>
#include <string>
#include <vector>

#include "bearing/control.hpp"
#include "validation/ledger/ledger_entry.hpp"

namespace shellback::validation {

struct Values {
  std::map<std::string, double> value;
  std::string failure;  ///< empty: solved
  bool interrupted = false;
};

/// What an evaluator is asked.
struct Question {
  const Entry& entry;
  const RowNumbers& point;  ///< numbers of the row, by column
  const Changes& changes;   ///< of an unknown input; empty: as taken
  const bearing::SolveControl& control;
  const std::any& prepared;  ///< what the evaluator's `prepare` gave

  /// The number in a column. Throws InputError if the row leaves it empty.
  [[nodiscard]] double number(const std::string& column) const;
};

/// One way to our values. `prepare` is called once for an entry, for what all its rows share.
struct Evaluator {
  const char* name;
  Values (*values)(const Question&);
  std::any (*prepare)(const Entry&);  ///< may be nullptr
};

/// The evaluator of that name, nullptr if there is none.
[[nodiscard]] const Evaluator* find_evaluator(const std::string& name);
[[nodiscard]] std::vector<std::string> evaluator_names();

/// A setting of an entry, as a word or a number. Throws InputError if it is missing or no number.
[[nodiscard]] std::string word_setting(const Entry& entry, const std::string& name);
[[nodiscard]] double number_setting(const Entry& entry, const std::string& name);

/// Bearings from ordinary case files, solved in the tier of the case; torques add up.
[[nodiscard]] Values bearing_values(const Question& question);
/// Endlessly wide film, full all round (Sommerfeld) or cavitated.
[[nodiscard]] Values wide_film_values(const Question& question);
/// Journal at rest but for its centre.
[[nodiscard]] Values squeeze_film_values(const Question& question);
/// Endlessly wide slider with a pocket.
[[nodiscard]] std::any prepare_pocket_slider(const Entry& entry);
[[nodiscard]] Values pocket_slider_values(const Question& question);
/// Slider of finite width with a pocket; Barus oil, compressible.
[[nodiscard]] std::any prepare_pocket_plate(const Entry& entry);
[[nodiscard]] Values pocket_plate_values(const Question& question);
/// Couette film that heats itself.
[[nodiscard]] Values couette_film_values(const Question& question);
/// Greenwood-Tripp integrals and contact pressure.
[[nodiscard]] Values asperity_contact_values(const Question& question);
/// Patir-Cheng factors.
[[nodiscard]] Values flow_factor_values(const Question& question);
/// Elastic ring in plane strain: harmonics of its compliance; bonded layer as its limit.
[[nodiscard]] Values elastic_ring_values(const Question& question);
[[nodiscard]] std::any prepare_bonded_layer(const Entry& entry);
[[nodiscard]] Values bonded_layer_values(const Question& question);
/// Soft layer on a steel ring under patches of pressure and under heat: gap opening.
[[nodiscard]] std::any prepare_layered_ring(const Entry& entry);
[[nodiscard]] Values layered_ring_values(const Question& question);

}  // namespace shellback::validation
