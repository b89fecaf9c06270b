#pragma once
/// The parts of a comparison page that are text: verdict, tables, lists. Each function returns
/// HTML with all outside text escaped; an empty string if there is nothing to say.
#include <string>
#include <vector>

#include "app/labels/tolerance_words.hpp"
#include "app/provenance.hpp"
#include "app/read_result.hpp"
#include "app/words/ending_words.hpp"
#include "bearing/result.hpp"

namespace shellback::app {

/// "± 0.012" with two figures; empty if the bar is not known.
[[nodiscard]] std::string bar_cell(double bar);

/// A loud box: heading, reason, place, cure, and what the numbers of the result mean.
[[nodiscard]] std::string failure_html(const std::string& heading, const EndingWords& words,
                                       const std::string& meaning);

/// A loud box: status, reason, place, cure, and what the numbers of the result mean.
[[nodiscard]] std::string failure_html(const std::string& name, const bearing::Result& result,
                                       const std::string& meaning);

/// One loud box per result that did not converge: status, reason, place, cure.
[[nodiscard]] std::string failures_html(const bearing::Comparison& comparison);

/// The comparison in two or three sentences: isothermal against full, the largest cause,
/// against the measured torque, the calibrated equivalent temperature.
[[nodiscard]] std::string verdict_html(const bearing::Case& c,
                                       const bearing::Comparison& comparison);

/// Quantities, one column a result, then the unit and, if any, the measured values with each
/// result's difference.
[[nodiscard]] std::string quantities_html(const bearing::Case& c,
                                          const bearing::Comparison& comparison);

/// Results whose order their bars leave open, and bars wider than model.tolerance; empty: neither.
[[nodiscard]] std::string bars_html(const bearing::Case& c, const bearing::Comparison& comparison);

/// What is missed of model.tolerance, and the command that is expected to meet it.
[[nodiscard]] std::string missed_html(const bearing::Case& c, const Missed& missed);

/// Relative imbalances, iterations, time.
[[nodiscard]] std::string audit_html(const bearing::Comparison& comparison);

/// Effects of the richest result.
[[nodiscard]] std::string effects_html(const bearing::Comparison& comparison);
[[nodiscard]] std::string effects_html(const std::vector<StoredEffect>& effects);

/// Assumptions, warnings and limiters that acted, each line once.
[[nodiscard]] std::string notes_html(const bearing::Comparison& comparison);
[[nodiscard]] std::string notes_html(const std::vector<std::string>& warnings,
                                     const std::vector<std::string>& limiters,
                                     const std::vector<std::string>& assumptions);

/// Program, source state, input, libraries and the verbatim case.
[[nodiscard]] std::string provenance_html(const Provenance& p, const std::string& verbatim);
[[nodiscard]] std::string provenance_html(const bearing::Case& c);

}  // namespace shellback::app
